// Where the clusters of a pack begin.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/region.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace demlua::packing {

/// Middles for clusters, none nearer to another or to the boundary than the circles around them, which have
/// the returned radius (m). Growing clusters at once would leave some locked into each other.
struct Middles {
    std::vector<Vec2> at;
    double circle;
};

/// Middles for `count` clusters with circles of at most `circle` (m) in a region of `area` (m^2).
Middles spread(const model::Region& region, double area, std::size_t count, double circle, std::uint64_t seed);

} // namespace demlua::packing
