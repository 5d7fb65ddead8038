// A law with caps (law/strength_caps.hpp) that are higher, and cost more, the faster a bond is stretched when it first yields.
//
//   s -> f s,  G -> f^0.5 G            f(r) of law/strain_rate.hpp, kept from the first yield on
//   dr/dt = (|de/dt|/l - r)/window     r running mean of the rate at which a bond of length l stretches
//
// f is at most (0.99 R_max/R)^(2/3), R_max the law's largest radius: beyond, a bond would store more than its energy.
// Limits: the stretch alone counts, and vibration counts as stretching. Runs from rest to rest leave r as it stands.
#pragma once

#include "engine/law/bond_motion.hpp"
#include "engine/law/strain_rate.hpp"
#include "engine/law/strength_caps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace demlua::law {

struct RateParams {
    double exponent = 0.0; ///< d of law/strain_rate.hpp
    double window = 0.0;   ///< s
};

/// What a law remembers, after two members more.
template <class History, class T, std::size_t count, class Plain>
constexpr std::array<T History::*, count + 2> members_after(T History::*first, T History::*second,
                                                            const std::array<T Plain::*, count>& plain) {
    std::array<T History::*, count + 2> all{first, second};
    for (std::size_t m = 0; m < count; ++m) all[m + 2] = plain[m];
    return all;
}

template <class Law>
struct RateDependent {
    static_assert(std::is_same_v<typename Law::Params, StrengthCaps>);

    static constexpr const char* name = Law::name;
    static constexpr bool breaks = Law::breaks;
    static constexpr bool yields = Law::yields;
    static constexpr bool wakes = Law::wakes;

    struct Params : StrengthCaps {
        RateParams rate;
    };

    struct Tractions : FacetCaps {
        RateParams rate;
    };

    template <class T>
    struct History : Law::template History<T> {
        using Plain = typename Law::template History<T>;
        T rate{};   ///< r, 1/s
        T factor{}; ///< f from the first yield on; 0 before
        static constexpr std::size_t rate_column = 0;
        static constexpr std::size_t factor_column = 1;
        static constexpr std::array<T History::*, Plain::members.size() + 2> members =
            members_after<History, T>(&History::rate, &History::factor, Plain::members);
    };

    static constexpr Params on_facet(const Tractions& p, ContactStiffness k, double A, double radius) {
        return {Law::on_facet(p, k, A, radius), p.rate};
    }

    static constexpr double largest_radius(const Params& p) { return Law::largest_radius(p); }

    /// f of a bond as it is now.
    static double factor(const Params& p, double radius, const History<double>& history) {
        if (history.factor > 0.0) return history.factor;
        const double resolved = std::pow(0.99 * Law::largest_radius(p) / radius, 2.0 / 3.0);
        return std::max(1.0, std::min(tension_factor(p.rate.exponent, history.rate), resolved));
    }

    /// Below the caps of slow stretching a bond is elastic at any rate.
    static BondForce<double> respond(const Params& p, double radius, const BondMotion<double>& motion,
                                     History<double>& history) {
        const History<double> before = history;
        if (before.factor == 0.0) {
            const BondForce<double> slow = Law::respond(p, radius, motion, history);
            if (!Law::has_yielded(before, history)) return slow;
            history = before;
        }
        const double f = factor(p, radius, before);
        const BondForce<double> force = Law::respond(at_factor(p, f), radius, motion, history);
        if (Law::has_yielded(before, history)) history.factor = f;
        return force;
    }

    static bool has_yielded(const History<double>& before, const History<double>& now) {
        return Law::has_yielded(before, now);
    }

    static bool broken(const Params& p, double radius, const BondMotion<double>& motion,
                       const History<double>& history) {
        return history.factor > 0.0 && Law::broken(at_factor(p, history.factor), radius, motion, history);
    }

    /// By the caps of slow stretching, which are the least there are.
    template <class T>
    static auto may_fail(const Tractions& p, T A, T radius, const BondForce<T>& force, const History<T>& history) {
        return Law::may_fail(p, A, radius, force, static_cast<const typename Law::template History<T>&>(history));
    }

    /// Greatest tension and greatest shear force that the bond bears now, N.
    static BondForce<double> caps(const Params& p, double radius, const History<double>& history) {
        return Law::caps(at_factor(p, factor(p, radius, history)), radius, history);
    }

    static double damage(const Params& p, double radius, const History<double>& history) {
        return Law::damage(at_factor(p, factor(p, radius, history)), radius, history);
    }

    static double stored_energy(const Params& p, const BondMotion<double>& motion, const History<double>& history) {
        return Law::stored_energy(p, motion, history);
    }

private:
    static StrengthCaps at_factor(const StrengthCaps& p, double f) { return scaled(p, f, energy_factor(f)); }
};

/// Whether the rates of a law's bonds are followed.
template <class Law>
inline constexpr bool follows_rate = false;
template <class Law>
inline constexpr bool follows_rate<RateDependent<Law>> = true;

} // namespace demlua::law
