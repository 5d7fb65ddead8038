// Caps that a tensile strength sets on the forces of a bond, and plastic displacements that spend the fracture energy at them.
//
//   fn_crit = R t s/(2(1-nu*)) (sqrt(3) - nu*/sqrt(3))        Tavarez & Plesha 2007, eq. 32
//   ft_crit = R t s/(2(1-nu*)) (1 - 3 nu*)                    eq. 33
//   opening = G 2Rt/fn_crit,   slip = G 2Rt/ft_crit           G = K_Ic^2/E* (eq. 31)
// On facets (law/facet.hpp), whose forces are true tractions:
//   fn_crit = s A t,   ft_crit = sqrt(3/7) s A t,   opening = G/s,   slip = G/(sqrt(3/7) s)
//
// R mean radius of the two elements, A length of a facet, t thickness, s tensile strength, starred values eq. 13, 14. A
// strain-rate factor f stands for s -> f s and G -> f G.
// Limit: as printed, eqs 32 to 35 owe G for each bond's 2R, of which a crack along the rows of a close-packed body cuts two
// for every 2R it grows.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/law/bond_motion.hpp"
#include "engine/law/stiffness.hpp"

#include <array>
#include <limits>
#include <numbers>

namespace demlua::law {

inline constexpr double shear_over_tension = 0.6546536707079771; ///< strength ratio on a facet, sqrt(3/7)

/// Displacements follow from the mean radius R of a bond: it yields at stretch_per_radius R, where fn = fn_crit, and at
/// shear_per_radius R.
struct StrengthCaps {
    double Kn = 0.0;                                       ///< N/m
    double Kt = 0.0;                                       ///< N/m
    double stretch_per_radius = 0.0;                       ///< fn_crit/(Kn R)
    double shear_per_radius = 0.0;                         ///< ft_crit/(Kt R)
    double opening = 0.0;                                  ///< plastic stretch that spends G at fn_crit, m
    double slip = std::numeric_limits<double>::infinity(); ///< plastic shear that spends G at ft_crit, m
};

/// The same for facets.
struct FacetCaps {
    double normal = 0.0; ///< s t, N/m
    double shear = 0.0;  ///< N/m
    double opening = 0.0;
    double slip = std::numeric_limits<double>::infinity();
};

/// `strength` in Pa and `toughness` in Pa m^0.5, both positive; `rate_factor` multiplies strength and fracture energy.
constexpr StrengthCaps strength_caps(ContactStiffness k, PlaneModuli plane, double thickness, double strength,
                                     double toughness, double rate_factor) {
    const double nu = plane.poissons_ratio;
    const double common = thickness * strength * rate_factor / (2.0 * (1.0 - nu));
    const double energy = rate_factor * fracture_energy(toughness, plane);
    const double fn_per_radius = common * (std::numbers::sqrt3 - nu * std::numbers::inv_sqrt3);
    const double ft_per_radius = common * (1.0 - 3.0 * nu);
    StrengthCaps p;
    p.Kn = k.normal;
    p.Kt = k.shear;
    p.stretch_per_radius = fn_per_radius / k.normal;
    p.opening = energy * 2.0 * thickness / fn_per_radius;
    // At the limit of Poisson's ratio there is neither stiffness nor strength in shear.
    if (k.shear <= 0.0) return p;
    p.shear_per_radius = ft_per_radius / k.shear;
    p.slip = energy * 2.0 * thickness / ft_per_radius;
    return p;
}

/// `strength` times as strong, for `energy` times the fracture energy.
constexpr StrengthCaps scaled(StrengthCaps p, double strength, double energy) {
    p.stretch_per_radius *= strength;
    p.shear_per_radius *= strength;
    p.opening *= energy / strength;
    p.slip *= energy / strength;
    return p;
}

constexpr FacetCaps facet_caps(PlaneModuli plane, double thickness, double strength, double toughness,
                               double rate_factor) {
    const double energy = rate_factor * fracture_energy(toughness, plane);
    FacetCaps p;
    p.normal = rate_factor * strength * thickness;
    p.shear = shear_over_tension * p.normal;
    p.opening = energy * thickness / p.normal;
    p.slip = energy * thickness / p.shear;
    return p;
}

/// For a facet of length A (m) that yields against the stiffness k: to be used with a radius of 1.
constexpr StrengthCaps on_facet(const FacetCaps& p, ContactStiffness k, double A) {
    return {k.normal, k.shear, p.normal * A / k.normal, p.shear * A / k.shear, p.opening, p.slip};
}

/// Whether forces on a facet of length A come up to its caps, or within rounding of them.
template <class T>
auto may_pass(const FacetCaps& p, T A, const BondForce<T>& force) {
    constexpr double nearly = 1.0 - 1e-9;
    return either(force.normal >= nearly * p.normal * A, magnitude(force.shear) >= nearly * p.shear * A);
}

} // namespace demlua::law
