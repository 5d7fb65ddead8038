// Moment against rolling in a contact: a spring and dashpot that turn, capped by the pressure.
//
//   M = kr q + Cr q',  |M| <= mu_r r N,  kr = Kt r^2      q elastic part of the turn of j against i, r = R_i R_j/(R_i + R_j)
//
// on i, the opposite on j: a couple, which does not notice that both turn together. Beyond the cap the pair rolls on.
// Sources: Iwashita & Oda, J. Eng. Mech. 124 (1998) 285 (stiffness); Ai, Chen, Rotter & Ooi, Powder Technology 206 (2011)
// 269, model C (spring, dashpot and cap). Limits: mu_r >= 0; the couple stands for a contact of some width.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/law/spent.hpp"

#include <array>

namespace demlua::law {

struct Rolling {
    template <class T>
    struct History {
        T turn{};   ///< elastic part q, rad
        T moment{}; ///< at the last instant, N m
        static constexpr std::array<T History::*, 2> members{&History::turn, &History::moment};
    };

    /// What the pair does now: the stiffness (N m), the dashpot (N m s), the greatest moment (N m; zero while nothing
    /// touches), and how fast j turns against i (rad/s).
    template <class T>
    struct Input {
        T stiffness;
        T dashpot;
        T cap;
        T rolling;
    };

    /// Moment on i, N m; adds to `spent` what this step takes.
    template <class T>
    static T respond(const Input<T>& in, double dt, History<T>& history, Spent<T>& spent) {
        const T rolled = in.rolling * dt;
        const T turned = history.turn + rolled;
        const T trial = in.stiffness * turned + in.dashpot * in.rolling;
        const auto rolls_on = magnitude(trial) > in.cap;
        const T moment = clamped(trial, in.cap);
        const T kept =
            select(both(in.stiffness > 0.0, in.cap > 0.0), clamped(in.stiffness * turned, in.cap) / in.stiffness, T{});
        const T taken =
            0.5 * (history.moment + moment) * rolled - 0.5 * in.stiffness * (kept * kept - history.turn * history.turn);
        spent.friction += select(rolls_on, taken, T{});
        spent.damped += select(rolls_on, T{}, taken);
        history.turn = kept;
        history.moment = moment;
        return moment;
    }

    template <class T>
    static T stored_energy(T stiffness, const History<T>& history) {
        return 0.5 * stiffness * history.turn * history.turn;
    }
};

} // namespace demlua::law
