// Elastic, then plastic at the caps that a strength sets, gone when the opening has spent the fracture energy.
//
//   fn_crit   = R t s/(2(1-nu*)) (sqrt(3) - nu*/sqrt(3))       Tavarez & Plesha 2007, eq. 32
//   ft_crit   = R t s/(2(1-nu*)) (1 - 3 nu*)                   eq. 33
//   d_max     = G 2Rt/fn_crit + fn_crit/(2 Kn)                 eq. 34 with 35, G = K_Ic^2/E* (eq. 31)
//   |fn| <= fn_crit in tension, |ft| <= ft_crit both ways; unloading with Kn and Kt; broken when e > d_max.
//   With break_in_shear also broken when |ut| > G 2Rt/ft_crit + ft_crit/(2 Kt) (figure 14b).
// On facets (law/facet.hpp), whose forces are true tractions: fn_crit = s A t, ft_crit = sqrt(3/7) s A t.
//
// R mean radius of the two elements, t thickness, s tensile strength, e stretch, ut shear displacement, starred values
// eq. 13, 14. A strain-rate factor f stands for s -> f s and G -> f G.
// Limits: the printed law spends 2.07 G per crack area along the rows of a close-packed body at nu* = 0.3, because two
// bonds are cut there for each 2R; compression never yields in the normal direction.
#pragma once

#include "engine/law/bond_motion.hpp"
#include "engine/law/stiffness.hpp"

#include <array>
#include <limits>
#include <numbers>

namespace demlua::law {

struct Plateau {
    static constexpr const char* name = "plateau";
    static constexpr bool breaks = true;
    static constexpr double shear_over_tension = 0.6546536707079771; ///< strength ratio on a facet, sqrt(3/7)

    /// Displacements follow from the mean radius R of a bond: yield at stretch_per_radius R, where fn = fn_crit, and
    /// d_max = opening + stretch_per_radius R / 2; the same in shear.
    struct Params {
        double Kn = 0.0;                                       ///< N/m
        double Kt = 0.0;                                       ///< N/m
        double stretch_per_radius = 0.0;                       ///< fn_crit/(Kn R)
        double shear_per_radius = 0.0;                         ///< ft_crit/(Kt R)
        double opening = 0.0;                                  ///< m, plastic part of d_max
        double slip = std::numeric_limits<double>::infinity(); ///< m, plastic part of the greatest shear
    };

    /// The same strength for facets, whose forces are true tractions: s t and sqrt(3/7) s t, N/m, with the plastic
    /// displacements that spend G per area, m.
    struct Tractions {
        double normal = 0.0;
        double shear = 0.0;
        double opening = 0.0;
        double slip = std::numeric_limits<double>::infinity();
    };

    template <class T>
    struct History {
        T stretch{}; ///< plastic stretch, m
        T shear{};   ///< plastic shear displacement, m
        T work{};    ///< plastic work, J
        static constexpr std::array<T History::*, 3> members{&History::stretch, &History::shear, &History::work};
    };

    /// `strength` in Pa and `toughness` in Pa m^0.5, both positive; `rate_factor` multiplies strength and fracture energy.
    static constexpr Params derive(ContactStiffness k, PlaneModuli plane, double thickness, double strength,
                                   double toughness, double rate_factor, bool break_in_shear) {
        const double nu = plane.poissons_ratio;
        const double common = thickness * strength * rate_factor / (2.0 * (1.0 - nu));
        const double fracture_energy = rate_factor * toughness * toughness / plane.youngs_modulus;
        const double fn_per_radius = common * (std::numbers::sqrt3 - nu * std::numbers::inv_sqrt3);
        const double ft_per_radius = common * (1.0 - 3.0 * nu);
        Params p;
        p.Kn = k.normal;
        p.Kt = k.shear;
        p.stretch_per_radius = fn_per_radius / k.normal;
        p.opening = fracture_energy * 2.0 * thickness / fn_per_radius;
        // At the limit of Poisson's ratio there is neither stiffness nor strength in shear.
        if (k.shear <= 0.0) return p;
        p.shear_per_radius = ft_per_radius / k.shear;
        if (break_in_shear) p.slip = fracture_energy * 2.0 * thickness / ft_per_radius;
        return p;
    }

    static constexpr Tractions derive_tractions(PlaneModuli plane, double thickness, double strength, double toughness,
                                                double rate_factor, bool break_in_shear) {
        const double fracture_energy = rate_factor * toughness * toughness / plane.youngs_modulus;
        Tractions p;
        p.normal = rate_factor * strength * thickness;
        p.shear = shear_over_tension * p.normal;
        p.opening = fracture_energy * thickness / p.normal;
        if (break_in_shear) p.slip = fracture_energy * thickness / p.shear;
        return p;
    }

    /// For a facet of length A (m) that yields against the stiffness k: to be used with a radius of 1.
    static constexpr Params on_facet(const Tractions& p, ContactStiffness k, double A) {
        return {k.normal, k.shear, p.normal * A / k.normal, p.shear * A / k.shear, p.opening, p.slip};
    }

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
    static bool has_yielded(const History<T>& before, const History<T>& now) {
        return now.work > before.work;
    }

    template <class T>
    static bool broken(const Params& p, T radius, const BondMotion<T>& motion, const History<T>& /*history*/) {
        return motion.stretch > p.opening + 0.5 * p.stretch_per_radius * radius ||
               magnitude(motion.shear) > p.slip + 0.5 * p.shear_per_radius * radius;
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
