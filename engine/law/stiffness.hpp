// Contact stiffness from Young's modulus and Poisson's ratio; fracture energy and toughness.
//
//   E* = E,          nu* = nu              plane stress      Tavarez & Plesha 2007, eq. 13, 14
//   E* = E/(1-nu^2), nu* = nu/(1-nu)       plane strain
//   Kn = E* t / (sqrt(3) (1 - nu*))                          eq. 15
//   Kt = Kn (1 - 3 nu*) / (1 + nu*)                          eq. 16
//   G = K_Ic^2 / E*                                          eq. 31
//
// E Young's modulus, nu Poisson's ratio, t thickness, Kn and Kt normal and shear stiffness of one contact.
// Exact for a close-packed assembly of equal elements of any radius. Limit: nu* <= 1/3, for beyond it Kt is negative
// and elements that can rotate are unstable.
#pragma once

#include <cmath>
#include <numbers>

namespace demlua::law {

/// Moduli of the plane problem: `youngs_modulus` in Pa.
struct PlaneModuli {
    double youngs_modulus;
    double poissons_ratio;
};

/// E in Pa, nu below 1/2. Source: eq. 13, 14.
constexpr PlaneModuli plane_moduli(double E, double nu, bool plane_strain) {
    return plane_strain ? PlaneModuli{E / (1.0 - nu * nu), nu / (1.0 - nu)} : PlaneModuli{E, nu};
}

/// The reverse of eq. 13, 14: the material that has these plane moduli.
constexpr PlaneModuli solid_moduli(PlaneModuli plane, bool plane_strain) {
    if (!plane_strain) return plane;
    const double nu = plane.poissons_ratio / (1.0 + plane.poissons_ratio);
    return {plane.youngs_modulus * (1.0 - nu * nu), nu};
}

/// J/m^2, of a toughness in Pa m^0.5. Source: eq. 31.
constexpr double fracture_energy(double toughness, PlaneModuli plane) {
    return toughness * toughness / plane.youngs_modulus;
}

/// The reverse: Pa m^0.5, of a fracture energy in J/m^2.
inline double fracture_toughness(double energy, PlaneModuli plane) { return std::sqrt(energy * plane.youngs_modulus); }

/// N/m.
struct ContactStiffness {
    double normal;
    double shear;
};

/// `thickness` in m. Source: eq. 15, 16.
constexpr ContactStiffness contact_stiffness(PlaneModuli plane, double thickness) {
    const double nu = plane.poissons_ratio;
    const double Kn = plane.youngs_modulus * thickness / (std::numbers::sqrt3 * (1.0 - nu));
    return {Kn, Kn * (1.0 - 3.0 * nu) / (1.0 + nu)};
}

/// Two contacts' halves in series: the stiffness between elements of unlike materials. Zero when either is zero.
constexpr double in_series(double a, double b) { return a + b > 0.0 ? 2.0 * a * b / (a + b) : 0.0; }

} // namespace demlua::law
