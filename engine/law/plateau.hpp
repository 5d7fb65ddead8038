// Elastic, then plastic at the caps that a strength sets, gone when the opening has spent the fracture energy.
//
//   |fn| <= fn_crit in tension, |ft| <= ft_crit both ways (law/strength_caps.hpp); unloading with Kn and Kt
//   d_max     = G 2Rt/fn_crit + fn_crit/(2 Kn)                 Tavarez & Plesha 2007, eq. 34 with 35; broken when e > d_max
//   With break_in_shear also broken when |ut| > G 2Rt/ft_crit + ft_crit/(2 Kt) (figure 14b).
//
// e stretch, ut shear displacement, R mean radius of the two elements, t thickness, G fracture energy.
// Limits: d_max >= fn_crit/Kn, or there is no plateau; the printed law spends 2.07 G per crack area along the rows of a
// close-packed body at nu* = 0.3; compression never yields in the normal direction.
#pragma once

#include "engine/law/bond_motion.hpp"
#include "engine/law/strength_caps.hpp"

#include <array>
#include <limits>

namespace demlua::law {

struct Plateau {
    static constexpr const char* name = "plateau";
    static constexpr bool breaks = true;
    static constexpr bool yields = true;
    static constexpr bool wakes = false;

    using Params = StrengthCaps;
    using Tractions = FacetCaps;

    template <class T>
    struct History {
        T stretch{}; ///< plastic stretch, m
        T shear{};   ///< plastic shear displacement, m
        T work{};    ///< plastic work, J
        static constexpr std::array<T History::*, 3> members{&History::stretch, &History::shear, &History::work};
    };

    /// Of strength_caps, for pairs or for facets.
    template <class Caps>
    static constexpr Caps derive(Caps caps, bool break_in_shear) {
        if (!break_in_shear) caps.slip = std::numeric_limits<double>::infinity();
        return caps;
    }

    static constexpr Params on_facet(const Tractions& p, ContactStiffness k, double A, double /*radius*/) {
        return law::on_facet(p, k, A);
    }

    /// The radius at which d_max has come down to fn_crit/Kn, m.
    static constexpr double largest_radius(const Params& p) { return 2.0 * p.opening / p.stretch_per_radius; }

    template <class T>
    static BondForce<T> respond(const Params& p, T radius, const BondMotion<T>& motion, History<T>& history) {
        const T stretch = motion.stretch - history.stretch;
        const T shear = motion.shear - history.shear;
        const T held_stretch = smaller(stretch, p.stretch_per_radius * radius);
        const T held_shear = clamped(shear, p.shear_per_radius * radius);
        const BondForce<T> force{p.Kn * held_stretch, p.Kt * held_shear};
        const T opened = stretch - held_stretch;
        const T slipped = shear - held_shear;
        history.stretch += opened;
        history.shear += slipped;
        history.work += force.normal * opened + force.shear * slipped;
        return force;
    }

    /// Plastic work grows with every plastic displacement.
    template <class T>
    static auto has_yielded(const History<T>& before, const History<T>& now) {
        return now.work > before.work;
    }

    template <class T>
    static auto broken(const Params& p, T radius, const BondMotion<T>& motion, const History<T>& /*history*/) {
        return either(motion.stretch > p.opening + 0.5 * p.stretch_per_radius * radius,
                      magnitude(motion.shear) > p.slip + 0.5 * p.shear_per_radius * radius);
    }

    /// Whether a facet of length A (m) may yield or break under `force` (N): said too often rather than too seldom.
    template <class T>
    static auto may_fail(const Tractions& p, T A, T /*radius*/, const BondForce<T>& force,
                         const History<T>& /*history*/) {
        return may_pass(p, A, force);
    }

    /// Greatest tension and greatest shear force that the bond bears now, N.
    template <class T>
    static BondForce<T> caps(const Params& p, T radius, const History<T>& /*history*/) {
        return {p.Kn * p.stretch_per_radius * radius, p.Kt * p.shear_per_radius * radius};
    }

    /// Share of the way from first yield to breaking, 0 to 1.
    template <class T>
    static T damage(const Params& p, T /*radius*/, const History<T>& history) {
        return smaller(T{1.0}, larger(history.stretch / p.opening, magnitude(history.shear) / p.slip));
    }

    template <class T>
    static T stored_energy(const Params& p, const BondMotion<T>& motion, const History<T>& history) {
        const T e = motion.stretch - history.stretch;
        const T ut = motion.shear - history.shear;
        return 0.5 * (p.Kn * e * e + p.Kt * ut * ut);
    }
};

} // namespace demlua::law
