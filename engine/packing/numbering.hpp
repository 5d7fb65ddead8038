// The order in which a pack numbers its elements.
#pragma once

#include "engine/base/vec2.hpp"

#include <cstddef>
#include <vector>

namespace demlua::packing {

/// Order of points by bands of width `band` (m) across the longer side of `box`, and within a band along the shorter, so
/// that neighbours get near numbers.
std::vector<std::size_t> order_by_bands(const std::vector<Vec2>& points, const Box& box, double band);

} // namespace demlua::packing
