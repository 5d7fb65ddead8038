// The plane shared out among elements.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/vec2.hpp"
#include "engine/model/region.hpp"

#include <vector>

namespace demlua::packing {

/// The border two cells share: straight, across the line between their elements, from `from` to `to`. Seen along i to j
/// it runs from right to left, so that turned_left(normal) points from `from` to `to`. An end on the region's boundary
/// carries the unit vector out of the region there; an end inside the region carries (0, 0).
struct Facet {
    Index i = 0; ///< below j
    Index j = 0;
    Vec2 from; ///< m
    Vec2 to;   ///< m
    Vec2 outward_from;
    Vec2 outward_to;
    Vec2 to_image; ///< from j's element to that image of it whose cell it is; (0, 0) but in a plane that repeats, m
};

/// `area` (m^2) and `centroid` (m) of each element's cell, and what cells share, sorted by (i, j). Each point of the
/// region belongs to the element with the least |x - x_i|^2 - R_i^2 (power cells; Voronoi cells for equal radii). A cell
/// with no area belongs to an element that others hide.
struct Cells {
    std::vector<Facet> facets;
    std::vector<double> area;
    std::vector<Vec2> centroid;
};

/// Cells of the elements at `centre` (m) with radii `radius` (m), clipped to `region`, which must be bounded. The areas
/// add up to the region's. Curved boundaries are followed exactly.
Cells cells_of(const std::vector<Vec2>& centre, const std::vector<double>& radius, const model::Region& region);

} // namespace demlua::packing
