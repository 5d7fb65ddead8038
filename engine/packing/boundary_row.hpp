// A row of elements on a region's boundary.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"
#include "engine/model/region.hpp"

#include <cstdint>
#include <vector>

namespace demlua::packing {

/// Places on the boundary of a bounded region: every corner, and between corners as many as `size` (m) asks for, evenly
/// by size. Where pieces meet at less than about 17 degrees there is no corner. A boundary without corners has at least
/// three, from a place that `seed` draws. Throws RunError for more than ten million.
std::vector<Vec2> boundary_row(const model::Region& region, const model::Spacing& size, std::uint64_t seed);

} // namespace demlua::packing
