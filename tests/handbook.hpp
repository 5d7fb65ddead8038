// Closed forms of fracture that the engine is compared with. scenarios/shared/handbook.lua holds the same for scenes.
//
// Sources: Tada, Paris & Irwin, The Stress Analysis of Cracks Handbook, 3rd ed. (2000); Murakami, Stress Intensity Factors
// Handbook (1987); Srawley, Int. J. Fracture 12 (1976) 475, in ASTM E399; Erdogan & Sih, J. Basic Eng. 85 (1963) 519;
// Hondros, Aust. J. Appl. Sci. 10 (1959) 243; Kolsky, Stress Waves in Solids (1953).
//
// Shapes: K_I = stress sqrt(pi a) shape. Units are SI or any consistent ones; shares are of the full width, below 1.
#pragma once

#include <cmath>
#include <numbers>

namespace demlua::test::handbook {

constexpr double pi = std::numbers::pi;

// ---- cracks across the load ----

/// One crack from an edge, ends free to turn; `share` = a / width. Within 1 % below 0.6 (Brown & Srawley 1966; eq. 37 of
/// Tavarez & Plesha 2007).
inline double edge_crack_polynomial(double share) {
    return 1.12 + share * (-0.23 + share * (10.6 + share * (-21.7 + share * 30.4)));
}

/// The same within 0.6 % for every share (Tada 1973, where it is 0.5 %).
inline double edge_crack(double share) {
    const double turn = 0.5 * pi * share;
    return std::sqrt(std::tan(turn) / turn) * (0.752 + 2.02 * share + 0.37 * std::pow(1.0 - std::sin(turn), 3)) /
           std::cos(turn);
}

/// A crack of length 2 a in the middle; `share` = 2 a / width. Within 0.1 % for every share: the secant with Tada's factor.
inline double centre_crack(double share) {
    const double square = share * share;
    return (1.0 + square * (-0.025 + 0.06 * square)) / std::sqrt(std::cos(0.5 * pi * share));
}

/// Cracks of length a from both edges; `share` = 2 a / width. Said to be good to 0.5 % for every share (Tada 1973); finite
/// elements differ by up to 0.8 %. Tada's other formula, a polynomial over sqrt(1 - share), is 1.5 % high near 0.3.
inline double double_edge_crack(double share) {
    const double turn = 0.5 * pi * share;
    return (1.0 + 0.122 * std::pow(std::cos(turn), 4)) * std::sqrt(std::tan(turn) / turn);
}

/// Three-point bend, span 4 W; `share` = a / W; the stress is 6 M / W^2 with M = P W. Within 0.8 % for every share
/// (Srawley 1976, ASTM E399, where it is 0.5 %): K_I = P S / (B W^1.5) f.
inline double three_point_bend(double share) {
    const double f = 1.5 * std::sqrt(share) * (1.99 - share * (1.0 - share) * (2.15 + share * (-3.93 + 2.7 * share))) /
                     ((1.0 + 2.0 * share) * std::pow(1.0 - share, 1.5));
    return f / (1.5 * std::sqrt(pi * share));
}

/// The stress at which a crack of length `a` grows, its shape given.
inline double critical_stress(double toughness, double a, double shape) {
    return toughness / (shape * std::sqrt(pi * a));
}

/// The force per thickness at which a beam of depth W notched by a and bent over a span of 4 W fails.
inline double three_point_bend_force(double toughness, double a, double width) {
    return critical_stress(toughness, a, three_point_bend(a / width)) * width / 6.0;
}

/// Length a_t = (K_Ic / s)^2 / pi below which strength rules.
inline double transition_length(double toughness, double strength) {
    return toughness * toughness / (strength * strength * pi);
}

// ---- a crack of length 2 a in a wide plate, its normal turned by `angle` (rad) from the load ----

struct Intensities {
    double opening; // K_I
    double sliding; // K_II
};

inline Intensities slanted_crack(double stress, double a, double angle) {
    const double whole = stress * std::sqrt(pi * a);
    return {whole * std::cos(angle) * std::cos(angle), whole * std::sin(angle) * std::cos(angle)};
}

/// Direction (rad from the crack's own) in which the hoop stress at the tip is highest: K_I sin t + K_II (3 cos t - 1) = 0,
/// on the side that a positive K_II turns it away from (Erdogan & Sih 1963).
inline double kink_angle(const Intensities& k) {
    const double root = std::sqrt(k.opening * k.opening + 8.0 * k.sliding * k.sliding);
    return -2.0 * std::atan(2.0 * k.sliding / (k.opening + root));
}

/// What K_I would give the same highest hoop stress.
inline double hoop_intensity(const Intensities& k) {
    const double t = kink_angle(k);
    const double c = std::cos(0.5 * t);
    return c * (k.opening * c * c - 1.5 * k.sliding * std::sin(t));
}

/// The stress at which a slanted crack kinks.
inline double slanted_critical_stress(double toughness, double a, double angle) {
    return toughness / hoop_intensity(slanted_crack(1.0, a, angle));
}

// ---- a cohesive zone of constant traction (Dugdale) ----

/// The highest stress, over the strength, of a wide plate with a crack of length 2 a that lets go at an opening G / s:
/// (2 / pi) acos(exp(-pi^2 / (8 a / a_t))). Burdekin & Stone 1966.
inline double plateau_wide_plate(double a_over_transition) {
    return 2.0 / pi * std::acos(std::exp(-pi * pi / (8.0 * a_over_transition)));
}

// ---- other bodies ----

/// Tension at the centre of a disc under the force P pressed radially on arcs of `half_angle` (rad; 0: lines), per P:
/// 2 / (pi D t) (sin 2a - a) / sin a. Hondros 1959, P being the resultant.
inline double disc_tension(double diameter, double thickness, double half_angle) {
    const double line = 2.0 / (pi * diameter * thickness);
    return half_angle > 0.0 ? line * (std::sin(2.0 * half_angle) - half_angle) / std::sin(half_angle) : line;
}

struct Spall {
    double thickness; // m
    double speed;     // m/s
};

/// A compressive pulse of constant stress and given length meets a free end: where tension first appears, its momentum is
/// trapped in half the length.
inline Spall spall_of_block(double stress, double length, double impedance) {
    return {0.5 * length, 2.0 * stress / impedance};
}

/// A pulse with a sharp front that falls linearly to zero: the first spall, where the tension reaches the strength (Kolsky).
inline Spall spall_of_ramp(double stress, double length, double impedance, double strength) {
    return {0.5 * length * strength / stress, (2.0 * stress - strength) / impedance};
}

} // namespace demlua::test::handbook
