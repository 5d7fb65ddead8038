// The operations a law needs beside + - * /, for one lane. base/lane_vectors.hpp has them for several, under the same names
// and with the same result in every lane.
#pragma once

#include <algorithm>
#include <cmath>

namespace demlua {

/// Marks the few functions that the loops cannot afford to call.
#define DEMLUA_INLINE __attribute__((always_inline)) inline

constexpr double select(bool condition, double yes, double no) { return condition ? yes : no; }
constexpr bool either(bool a, bool b) { return a || b; }
constexpr bool both(bool a, bool b) { return a && b; }
constexpr bool any(bool condition) { return condition; }
constexpr double largest(double value) { return value; }
constexpr double smaller(double a, double b) { return std::min(a, b); }
constexpr double larger(double a, double b) { return std::max(a, b); }
inline double magnitude(double value) { return std::fabs(value); }
inline double square_root(double value) { return std::sqrt(value); }

template <class T>
DEMLUA_INLINE constexpr T clamped(T value, T limit) {
    return larger(-limit, smaller(value, limit));
}

/// Nearest whole number, ties to even, for |value| below 2^51.
template <class T>
DEMLUA_INLINE T nearest_whole(T value) {
    constexpr double magic = 0x1.8p52;
    return (value + magic) - magic;
}

/// Arctangent of |t| <= 1, rad: halved twice, atan t = 2 atan(t/(1 + sqrt(1 + t^2))), to below 0.2, and there by its series,
/// whose first term left out is below one unit in the last place.
template <class T>
T angle_of_slope(T t) {
    for (int halving = 0; halving < 2; ++halving) t = t / (1.0 + square_root(1.0 + t * t));
    const T q = t * t;
    T series = T{1.0 / 25.0};
    for (int n = 23; n > 0; n -= 2) series = 1.0 / n - q * series;
    return 4.0 * (t * series);
}

/// Angle of the vector (cosine, sine), any but zero, rad.
template <class T>
T angle_of(T cosine, T sine) {
    constexpr double quarter = 1.57079632679489661923;
    const T across = magnitude(sine);
    const T along = magnitude(cosine);
    const auto steep = across > along;
    const T flat = angle_of_slope(select(steep, along, across) / select(steep, across, along));
    const T upper = select(steep, quarter - flat, flat);
    const T angle = select(cosine < 0.0, 2.0 * quarter - upper, upper);
    return select(sine < 0.0, -angle, angle);
}

/// Cosine and sine of an angle.
template <class T>
struct Rotation {
    T cosine, sine;
};

/// Of any angle, rad, below 2^20 turns, to a few units in the last place: series for a quarter of it, doubled twice.
template <class T>
Rotation<T> rotation_by(T angle) {
    // 2 pi in two parts, of which the first has 33 bits.
    constexpr double turn = 6.28318530693650245667;
    constexpr double rest = 2.43084020260247689973e-10;
    const T whole = nearest_whole(angle * (1.0 / (turn + rest)));
    const T quarter = 0.25 * ((angle - whole * turn) - whole * rest);
    const T q = quarter * quarter;
    T s = T{1.0};
    T c = T{1.0};
    for (int n = 15; n > 1; n -= 2) s = 1.0 - q * (1.0 / (n * (n - 1))) * s;
    for (int n = 16; n > 0; n -= 2) c = 1.0 - q * (1.0 / (n * (n - 1))) * c;
    s = quarter * s;
    for (int doubling = 0; doubling < 2; ++doubling) {
        const T twice = s * c;
        c = 1.0 - 2.0 * (s * s);
        s = twice + twice;
    }
    return {c, s};
}

// Series about zero; the first term left out is below one unit in the last place. Terms are taken in pairs, so that few
// operations wait for each other.

/// sqrt(1 + x) - 1 for |x| below small_growth.
inline constexpr double small_growth = 3.5e-3;
template <class T>
DEMLUA_INLINE T root_growth(T x) {
    const T x2 = x * x;
    const T lower = (1.0 / 2 - 1.0 / 8 * x) + (1.0 / 16 - 5.0 / 128 * x) * x2;
    return x * (lower + (7.0 / 256 - 21.0 / 1024 * x) * (x2 * x2));
}

/// 1/(1 + x) for |x| below small_growth: the geometric series to x^7.
template <class T>
DEMLUA_INLINE T inverse_growth(T x) {
    const T x2 = x * x;
    return (1.0 - x) * (1.0 + x2) * (1.0 + x2 * x2);
}

/// Arctangent, rad, of |t| below small_slope.
inline constexpr double small_slope = 0.02;
template <class T>
DEMLUA_INLINE T angle_of_small(T t) {
    const T q = t * t;
    const T series = (1.0 / 3 - 1.0 / 5 * q) + (1.0 / 7 - 1.0 / 9 * q) * (q * q);
    return t - (t * q) * series;
}

} // namespace demlua
