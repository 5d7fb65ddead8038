// How much stronger concrete is when it is stretched fast.
//
//   f = 1                        r <= 1e-6 /s
//   f = (r/1e-6)^d               to 1 /s,       d = 1/(1 + 8 fc/10 MPa)
//   f = b (r/1e-6)^(1/3)         beyond,        log10 b = 6 d - 2, which makes both meet at 1 /s
//
// f dynamic over static tensile strength, r strain rate in 1/s, fc static compressive strength. The fracture energy grows by
// f^0.5. Source: Malvar & Crawford 1998, Dynamic increase factors for concrete, 28th DDESB seminar; for tension.
// Limits: measured up to 157 /s. What was measured holds the inertia of the cracking zone, which a model with masses has
// already: docs/theory/strain_rate.md. Compression has factors of its own (CEB-FIP 1990), for which bonds have no use: they
// do not yield under it.
#pragma once

#include <cmath>

namespace demlua::law {

/// d; `compressive_strength` positive, in Pa.
constexpr double rate_exponent(double compressive_strength) { return 1.0 / (1.0 + 8.0 * compressive_strength / 10e6); }

/// f >= 1, of d and a rate in 1/s.
inline double tension_factor(double exponent, double rate) {
    constexpr double slowest = 1e-6;
    constexpr double bend = 1.0;
    if (rate <= slowest) return 1.0;
    if (rate <= bend) return std::pow(rate / slowest, exponent);
    return std::pow(10.0, 6.0 * exponent - 2.0) * std::cbrt(rate / slowest);
}

/// Of the fracture energy, where the strength has f.
inline double energy_factor(double f) { return std::sqrt(f); }

} // namespace demlua::law
