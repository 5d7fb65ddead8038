// The dashpot of a contact from its restitution.
//
//   e = exp(-xi/sqrt(1-xi^2) (pi - 2 asin xi))                       xi < 1
//   e = exp(-xi/sqrt(xi^2-1) ln((xi+sqrt(xi^2-1))/(xi-sqrt(xi^2-1))))   xi > 1
//
// e speed after over speed before a head-on impact, xi fraction of critical damping of the contact c/(2 sqrt(k m)),
// k stiffness, m reduced mass. Source: the linear spring and dashpot released when its force has fallen to zero, so that
// a contact never pulls; solve for that instant. (The contact that may pull has e = exp(-pi xi/sqrt(1-xi^2)).)
// Limits: 0 < e <= 1; xi grows without bound as e goes to zero.
#pragma once

#include <cmath>
#include <numbers>

namespace demlua::law {

/// xi >= 0. Returns e in (0, 1].
inline double restitution_of(double xi) {
    if (std::fabs(xi - 1.0) < 1e-7) return std::exp(-2.0);
    if (xi < 1.0) return std::exp(-xi / std::sqrt(1.0 - xi * xi) * (std::numbers::pi - 2.0 * std::asin(xi)));
    const double root = std::sqrt(xi * xi - 1.0);
    return std::exp(-xi / root * std::log((xi + root) / (xi - root)));
}

/// Inverse of restitution_of. `restitution` in (0, 1].
inline double damping_fraction(double restitution) {
    double low = 0.0;
    double high = 1.0;
    while (restitution_of(high) > restitution) high *= 2.0;
    for (int halving = 0; halving < 100; ++halving) {
        const double middle = 0.5 * (low + high);
        (restitution_of(middle) > restitution ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

} // namespace demlua::law
