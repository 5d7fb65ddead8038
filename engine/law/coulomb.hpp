// Frictional contact: spring and dashpot in both directions, never pulling, shear capped by friction.
//
//   delta = L - d                              overlap; L the pair's reference length, R_i + R_j unless it was bonded
//   N  = max(0, Kn delta + Cn delta')          while delta > 0
//   ft = Kt us + Ct us',  |ft| <= mu N         us elastic shear displacement; beyond the cap it slips
//
// Source: Tavarez & Plesha 2007, section 4 and figure 1 (frictional contact); Kn, Kt eqs 15, 16.
// The work the shear force takes out of the motion, less what is stored in the spring, is spent: on friction while the
// contact slips, on the dashpot while it sticks. What a contact gives back while it slips, the dashpot reversing its force,
// is the dashpot's: friction never gives. Work over a step is the mean of the forces at its two ends times the
// displacement, which is what central difference really exchanges. A contact that is met or let go within a step was within
// reach for a part of it only: what that work then is beyond what the spring stores counts as the dashpot's, if it has one.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/law/spent.hpp"

#include <array>

namespace demlua::law {

struct Coulomb {
    static constexpr const char* name = "coulomb";

    template <class T>
    struct Constants {
        T Kn{}; ///< N/m
        T Kt{}; ///< N/m
        T mu{}; ///< friction coefficient
    };
    using Params = Constants<double>;

    template <class T>
    struct History {
        T shear{};   ///< elastic shear displacement us, m
        T damping{}; ///< normal dashpot force at the last instant, N
        T force{};   ///< shear force at the last instant, N
        static constexpr std::array<T History::*, 3> members{&History::shear, &History::damping, &History::force};
    };

    /// What the pair does now: overlap (m), speeds at which overlap and shear grow (m/s), the dashpots (N s/m).
    template <class T>
    struct Input {
        T overlap;
        T closing;
        T sliding;
        T Cn;
        T Ct;
    };

    /// Pressure (positive) and shear, N.
    template <class T>
    struct Force {
        T pressure;
        T shear;
    };

    /// Adds to `spent` what this step takes.
    template <class T>
    static Force<T> respond(const Constants<T>& p, const Input<T>& in, double dt, History<T>& history,
                            Spent<T>& spent) {
        const auto touching = in.overlap > 0.0;
        const T spring = p.Kn * in.overlap;
        const T pressure = select(touching, larger(T{}, spring + in.Cn * in.closing), T{});
        const T damping = select(touching, pressure - spring, T{});

        const T slide = in.sliding * dt;
        const T stretched = history.shear + slide;
        const T trial = p.Kt * stretched + in.Ct * in.sliding;
        const T cap = p.mu * pressure;
        const auto slips = magnitude(trial) > cap;
        const T shear = select(touching, clamped(trial, cap), T{});
        // The spring cannot hold more than friction lets through.
        T held = stretched;
        if (any(slips)) held = select(both(slips, p.Kt > 0.0), clamped(p.Kt * stretched, cap) / p.Kt, stretched);
        const T kept = select(both(touching, p.Kt > 0.0), held, T{});

        const T taken =
            0.5 * (history.force + shear) * slide - 0.5 * p.Kt * (kept * kept - history.shear * history.shear);
        const T rubbed = select(slips, larger(T{}, taken), T{});
        spent.friction += rubbed;
        const T closed = in.closing * dt;
        spent.damped += taken - rubbed + 0.5 * (history.damping + damping) * closed +
                        select(in.Cn > 0.0, 0.5 * p.Kn * out_of_reach(in.overlap - closed, in.overlap), T{});
        history.shear = kept;
        history.force = shear;
        history.damping = damping;
        return {pressure, shear};
    }

    /// Twice the work of a spring of 1 N/m over a step from overlap `before` to `now`, the mean of its forces times the way,
    /// beyond twice the energy it gains; zero unless one of the two is a gap. m^2.
    template <class T>
    static T out_of_reach(T before, T now) {
        return larger(T{}, now) * larger(T{}, -before) - larger(T{}, before) * larger(T{}, -now);
    }

    template <class T>
    static T stored_energy(const Params& p, T overlap, const History<T>& history) {
        const T delta = larger(T{}, overlap);
        return 0.5 * (p.Kn * delta * delta + p.Kt * history.shear * history.shear);
    }
};

} // namespace demlua::law
