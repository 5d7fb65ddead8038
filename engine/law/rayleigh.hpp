// Rayleigh damping C = alpha M + beta K from fractions of critical damping.
//
//   xi(w) = alpha/(2 w) + beta w/2                Tavarez & Plesha 2007, section 4
//
// One fraction and frequency: alpha alone. Two: alpha and beta so that both are met. w = 2 pi f.
// Limits: two fractions so different that alpha or beta would be negative feed energy into the motion.
#pragma once

#include <numbers>
#include <optional>

namespace demlua::law {

struct Rayleigh {
    double alpha = 0.0; ///< 1/s
    double beta = 0.0;  ///< s
};

/// Fraction `xi` at frequency `f` (Hz).
constexpr Rayleigh rayleigh(double xi, double f) { return {2.0 * xi * 2.0 * std::numbers::pi * f, 0.0}; }

/// Fractions xi1 at f1 and xi2 at f2 (Hz), f1 != f2.
constexpr Rayleigh rayleigh(double xi1, double f1, double xi2, double f2) {
    const double w1 = 2.0 * std::numbers::pi * f1;
    const double w2 = 2.0 * std::numbers::pi * f2;
    const double beta = 2.0 * (xi2 * w2 - xi1 * w1) / (w2 * w2 - w1 * w1);
    return {2.0 * xi1 * w1 - beta * w1 * w1, beta};
}

} // namespace demlua::law
