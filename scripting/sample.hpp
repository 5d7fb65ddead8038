// A function of time turned into a piecewise linear signal.
#pragma once

#include "engine/base/signal.hpp"

#include <cstddef>
#include <functional>

namespace demlua::scripting {

inline constexpr double sampling_tolerance = 1e-6; ///< share of the largest value
inline constexpr std::size_t greatest_sample_count = 65536;

struct Sampled {
    Signal signal;
    double error = 0.0; ///< largest deviation seen half-way between samples, as a share of the largest value
};

/// Samples `function` from `begin` to `end` (s), halving where a straight line is worst until it is within the
/// tolerance everywhere, or the samples are used up. A jump becomes a rise within 1e-9 of the span.
Sampled sample(const std::function<double(double)>& function, double begin, double end);

} // namespace demlua::scripting
