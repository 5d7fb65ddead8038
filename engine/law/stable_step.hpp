// The largest stable step of central difference with velocities at half steps and damping from the lagged velocity.
//
//   dt = (2/w) (sqrt(1 + xi^2) - xi),   w^2 = k,  2 xi w = c        one mode
//   dt^2 k + 2 dt c <= 4                                            the same, and for any pair of matrices: every row
//                                                                   of dt^2 K + 2 dt C with row sums k and c
//   dt = (1/2) sqrt(m/Kn) (sqrt(1 - xi^2) - xi)                     Tavarez & Plesha 2007, eq. 19
//
// K, C stiffness and damping scaled by M^-1/2 on both sides, k (1/s^2) and c (1/s) their Gerschgorin row sums.
// Source of the first: z-transform of the difference equation, |z| = 1 at z = -1. The paper's eq. 17 has
// sqrt(1 - xi^2) - xi, which is safe but vanishes at xi = 0.707. Eq. 19 is not a bound: it is unstable for
// Kt/Kn > 2/3 and needlessly small below.
#pragma once

#include <cmath>
#include <limits>

namespace demlua::law {

/// k >= 0 in 1/s^2, c >= 0 in 1/s. Seconds; infinite for a row without stiffness or damping.
inline double stable_step(double k, double c) {
    if (k <= 0.0) return c > 0.0 ? 2.0 / c : std::numeric_limits<double>::infinity();
    return (std::sqrt(c * c + 4.0 * k) - c) / k;
}

/// Eq. 19; `mass` kg, `Kn` N/m, xi below 0.707.
inline double paper_step(double mass, double Kn, double xi) {
    return 0.5 * std::sqrt(mass / Kn) * (std::sqrt(1.0 - xi * xi) - xi);
}

} // namespace demlua::law
