// Where the clusters of a pack begin.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/region.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace demlua::packing {

/// Middles for clusters, none nearer to another or to the boundary than the circles around them, which have
/// the returned radius (m) times the size of their cluster. Growing clusters at once would leave some locked into each other.
struct Middles {
    std::vector<Vec2> at;
    double circle;
};

/// Middles for a cluster of each of `sizes` with circles of at most `circle` (m) times its size in a region of `area`
/// (m^2).
Middles spread(const model::Region& region, double area, const std::vector<double>& sizes, double circle,
               std::uint64_t seed);

} // namespace demlua::packing
