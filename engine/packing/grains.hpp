// Loose grains: disks, or clusters of disks, of one shape and many sizes.
#pragma once

#include "engine/packing/grain_shapes.hpp"
#include "engine/packing/packing.hpp"

#include <vector>

namespace demlua::packing {

/// Grains as the settings ask for, a pure function of these and of `region`, which must be bounded. Elements of a grain
/// have numbers in a row, grains are numbered by bands (numbering.hpp); the cell areas of a grain's elements share out
/// what its disks cover by radius squared. A region too small for one grain gives an empty packing. Throws RunError where the
/// porosity or number asked for cannot be had, saying what was reached.
///
/// Consolidation presses grains as `consolidated` does its clusters. Overlaps come down to 0.001 radii of the smaller
/// element where grains have room to spare; in packs as dense as they can be a few hundredths of a radius stay.
Packing grains(const model::Region& region, const model::GrainPacking& settings);

/// Mean radius of the elements (m), grain by grain, as the sizes ask for.
double mean_radius(const model::GrainPacking& settings);

/// A packing without the share `removed` of its elements, drawn at random.
Packing thinned(const Packing& packing, double removed, std::uint64_t seed);

// --- one by one --------------------------------------------------------------------------------------------------------

/// What is asked of grains that are put down one by one.
struct GrainOrder {
    GrainShape shape;
    SizeSpread sizes;
    double region_area = 0.0; ///< m^2
    std::size_t count = 0;    ///< grains; 0: as many as find a place
    double solid_area = 0.0;  ///< or what they are to cover, m^2; 0: as much as there is room for
    std::uint64_t seed = 1;
};

/// Random sequential insertion: grains at random angles at random places of the region where they overlap nothing, the
/// largest first. Of equal disks about 0.547 of the area is the most (Feder, J. Theor. Biol. 87, 237, 1980).
std::vector<Grain> inserted(const model::Region& region, const GrainOrder& order);

/// Grains dropped one by one at random places and angles. Each falls straight down and then, touching what lies below
/// or the region's boundary, slides and turns without friction or speed until it can get no lower (for disks: Visscher &
/// Bolsterli, Nature 239, 504, 1972). Those that lie already do not move. Overlaps stay below 0.002 of the smallest radius.
std::vector<Grain> rained(const model::Region& region, const GrainOrder& order);

} // namespace demlua::packing
