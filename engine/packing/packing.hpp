// Where the elements of a body stand before anything has moved.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"
#include "engine/model/region.hpp"

#include <optional>
#include <vector>

namespace demlua::packing {

/// Element centres (m) and radii (m), all of one length. `cluster[k]` numbers the cluster an element came in,
/// from zero. `cell_area` is the part of the plane each element stands for (m^2): its lattice cell, or the
/// region's area shared out in proportion to radius squared, or its cell in a relaxed pack.
struct Packing {
    std::vector<Vec2> centre;
    std::vector<double> radius;
    std::vector<Index> cluster;
    std::vector<double> cell_area;
};

using model::Consolidation;
using model::Fit;
using model::Relaxation;
using model::Rows;

/// Hexagonal lattice, every element touching six others; rows stand 2R and sqrt(3) R apart. A lattice point
/// lies at `origin`; without one, at the lower left corner of the region's box (Fit::centres) or R away from
/// it along both axes (Fit::inside). Elements are numbered row by row. Cell area 2 sqrt(3) R^2. Boundaries
/// count as inside to 1e-9 R. Returns an empty packing when nothing fits.
Packing close_packed(const model::Region& region, double radius, Rows rows, Fit fit, std::optional<Vec2> origin);

/// Element radius (m) that a consolidated pack of `region` will have: sqrt(solid_fraction area / (pi count)).
double consolidated_radius(const model::Region& region, const Consolidation& settings);

/// Clusters put down at random and at random angles, grown to their size and pressed against each other and
/// against the region's boundary until no overlap exceeds a few hundredths of a radius. Same seed, same pack.
/// Every disk lies inside the region to within that overlap. Elements are numbered by position (bands along
/// the longer side of the box) so that neighbours stand close in memory; clusters are numbered by their first
/// element. Large packs reach a solid fraction of about 0.85 (clusters of 1 and 2), 0.84 (3), 0.81 (4), 0.79 (7),
/// ordering more and more as they come near it; small ones reach less, because walls take room. Throws RunError
/// where more is asked, saying what fits; an empty region, or one too small for one cluster of `radius`, gives an
/// empty packing. With `relax` the elements then take that many steps of Lloyd's method, which undoes the clusters'
/// shapes and lets disks overlap by more.
Packing consolidated(const model::Region& region, const Consolidation& settings);

/// Elements sown at random with the density asked for, then moved `steps` times to the middles of their cells, weighted
/// where their size differs from place to place. Each is a cluster of its own. Cell areas are those of cells_of, their
/// sum is the region's area; the radius is that of the hexagon of that area, sqrt(area / (2 sqrt(3))), but no disk
/// reaches across the boundary except those of elements that stand on it, which are as large as their neighbours
/// inside. Disks of neighbours overlap by up to about a quarter of their diameter: a pack to be bonded, not one of loose grains.
/// With `on_boundary` a row of elements stands on the boundary, one in every corner, even if `count` is less. Numbered like a consolidated
/// pack. Throws RunError for more than ten million elements; an empty region gives an empty packing.
Packing relaxed(const model::Region& region, const Relaxation& settings);

/// Radius (m) of a full cell of mean area in that pack, sown but not yet relaxed.
double relaxed_radius(const model::Region& region, const Relaxation& settings);

} // namespace demlua::packing
