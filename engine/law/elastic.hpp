// Bonds that never break.
//
//   fn = Kn e,   ft = Kt ut,   U = Kn e^2/2 + Kt ut^2/2        Tavarez & Plesha 2007, figure 1 (bonded contact)
//
// e stretch, ut shear displacement, Kn, Kt eqs 15, 16. No limits.
#pragma once

#include "engine/law/bond_motion.hpp"
#include "engine/law/stiffness.hpp"

#include <array>

namespace demlua::law {

struct Elastic {
    static constexpr const char* name = "elastic";
    static constexpr bool breaks = false;
    static constexpr bool yields = false;
    static constexpr bool wakes = false;

    struct Params {
        double Kn = 0.0; ///< N/m
        double Kt = 0.0; ///< N/m
    };

    struct Tractions {};

    template <class T>
    struct History {
        static constexpr std::array<T History::*, 0> members{};
    };

    static constexpr Params derive(ContactStiffness k) { return {k.normal, k.shear}; }

    template <class T>
    static BondForce<T> respond(const Params& p, T /*radius*/, const BondMotion<T>& motion, History<T>& /*history*/) {
        return {p.Kn * motion.stretch, p.Kt * motion.shear};
    }

    template <class T>
    static bool has_yielded(const History<T>& /*before*/, const History<T>& /*now*/) {
        return false;
    }

    template <class T>
    static T stored_energy(const Params& p, const BondMotion<T>& motion, const History<T>& /*history*/) {
        return 0.5 * (p.Kn * motion.stretch * motion.stretch + p.Kt * motion.shear * motion.shear);
    }
};

} // namespace demlua::law
