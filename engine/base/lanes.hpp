// The operations a law needs beside + - * /, for one lane. A vector of lanes supplies its own under the same names.
#pragma once

#include <algorithm>
#include <cmath>

namespace demlua {

constexpr double select(bool condition, double yes, double no) { return condition ? yes : no; }
constexpr double smaller(double a, double b) { return std::min(a, b); }
constexpr double larger(double a, double b) { return std::max(a, b); }
constexpr double clamped(double value, double limit) { return larger(-limit, smaller(value, limit)); }
inline double magnitude(double value) { return std::fabs(value); }
inline double square_root(double value) { return std::sqrt(value); }

/// Marks the few functions that the loops cannot afford to call.
#define DEMLUA_INLINE [[gnu::always_inline]] inline

/// Angle of the vector (cosine, sine), rad. Small angles, nearly all there are between bonds, by the series of the
/// arctangent, whose first term left out is below one unit in the last place.
DEMLUA_INLINE double angle_of(double cosine, double sine) {
    constexpr double series_limit = 0.02;
    if (!(std::fabs(sine) < series_limit * cosine)) [[unlikely]]
        return std::atan2(sine, cosine);
    const double t = sine / cosine;
    const double q = t * t;
    return t * (1.0 - q * (1.0 / 3.0 - q * (1.0 / 5.0 - q * (1.0 / 7.0 - q * (1.0 / 9.0)))));
}

/// Nearest whole number, ties to even, for |value| below 2^51.
inline double nearest_whole(double value) {
    constexpr double magic = 0x1.8p52;
    return (value + magic) - magic;
}

} // namespace demlua
