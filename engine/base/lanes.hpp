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
inline double angle_of(double cosine, double sine) { return std::atan2(sine, cosine); }
inline double nearest_whole(double value) { return std::nearbyint(value); }

} // namespace demlua
