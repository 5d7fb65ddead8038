// Packs of a plane that repeats along x: a region that reaches from edge to edge goes on there.
#pragma once

#include "engine/base/period.hpp"
#include "engine/model/packings.hpp"
#include "engine/packing/cells.hpp"
#include "engine/packing/packing.hpp"

#include <vector>

namespace demlua::packing {

/// Whether a region is as wide as the period, so that it meets its images.
bool goes_on(const model::Region& region, Period period);

/// Whether the lattice is the same one period on: with horizontal rows the period is a number of diameters, with vertical rows
/// a number of pairs of rows.
bool lattice_repeats(const model::ClosePacking& lattice, Period period);

/// close_packed(), of the region and its images together, of every element one image: rows go on across the edge. Where region or
/// lattice do not go on it is close_packed() itself.
Packing close_packed_across(const model::Region& region, const model::ClosePacking& lattice, Period period);

/// cells_of(), of the region and its images together: there is no boundary where they meet, and facets of elements on both
/// sides have Facet::to_image.
Cells cells_across(const std::vector<Vec2>& centre, const std::vector<double>& radius, const model::Region& region,
                   Period period);

} // namespace demlua::packing
