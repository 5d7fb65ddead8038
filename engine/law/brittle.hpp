// What brittle laws share: elastic, and gone at once when the pull exceeds one cap.
//
//   fn = Kn e,   ft = Kt ut;   broken when fn > f_ult(R)
//
// e stretch, ut shear displacement, R mean radius of the two elements. `Cap` says how f_ult grows with R and what it comes
// to on facets. What is stored at that instant is released: the law knows no fracture energy.
// Limits: shear and compression never break a bond.
#pragma once

#include "engine/law/bond_motion.hpp"
#include "engine/law/stiffness.hpp"

#include <array>
#include <limits>

namespace demlua::law {

template <class Cap>
struct Brittle {
    static constexpr const char* name = Cap::name;
    static constexpr bool breaks = true;
    static constexpr bool yields = false;
    static constexpr bool wakes = false;

    struct Params {
        double Kn = 0.0;  ///< N/m
        double Kt = 0.0;  ///< N/m
        double cap = 0.0; ///< f_ult = cap times Cap::growth(R)
    };

    struct Tractions {
        double normal = 0.0; ///< f_ult on a facet = normal A Cap::stress_growth(R)
    };

    template <class T>
    struct History {
        static constexpr std::array<T History::*, 0> members{};
    };

    /// To be used with a radius of 1. `radius`, the true one, in m.
    static Params on_facet(const Tractions& p, ContactStiffness k, double A, double radius) {
        return {k.normal, k.shear, p.normal * A * Cap::stress_growth(radius)};
    }

    template <class T>
    static BondForce<T> respond(const Params& p, T /*radius*/, const BondMotion<T>& motion, History<T>& /*history*/) {
        return {p.Kn * motion.stretch, p.Kt * motion.shear};
    }

    template <class T>
    static bool has_yielded(const History<T>& /*before*/, const History<T>& /*now*/) {
        return false;
    }

    template <class T>
    static auto broken(const Params& p, T radius, const BondMotion<T>& motion, const History<T>& /*history*/) {
        return p.Kn * motion.stretch > p.cap * Cap::growth(radius);
    }

    /// Whether a facet of length A (m) may break under `force` (N): said too often rather than too seldom.
    template <class T>
    static auto may_fail(const Tractions& p, T A, T radius, const BondForce<T>& force, const History<T>& /*history*/) {
        constexpr double nearly = 1.0 - 1e-9;
        return force.normal >= nearly * p.normal * A * Cap::stress_growth(radius);
    }

    /// Greatest tension that the bond bears, N; no shear force is too great for it.
    template <class T>
    static BondForce<T> caps(const Params& p, T radius, const History<T>& /*history*/) {
        return {p.cap * Cap::growth(radius), T{std::numeric_limits<double>::infinity()}};
    }

    /// All or nothing: a bond that holds has none.
    template <class T>
    static T damage(const Params& /*p*/, T /*radius*/, const History<T>& /*history*/) {
        return T{};
    }

    template <class T>
    static T stored_energy(const Params& p, const BondMotion<T>& motion, const History<T>& /*history*/) {
        return 0.5 * (p.Kn * motion.stretch * motion.stretch + p.Kt * motion.shear * motion.shear);
    }
};

} // namespace demlua::law
