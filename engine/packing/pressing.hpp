// A pack that has grown to its size is pressed until hardly anything overlaps.
#pragma once

#include "engine/packing/growth.hpp"

#include <cstdint>

namespace demlua::packing {

/// Overlap, in radii of the smaller disk, above which it is no pack.
inline constexpr double largest_overlap = 0.1;

/// Settles a pack grown to `radius` and returns the largest overlap left. A pack that has jammed is squeezed, shaken
/// and let go, which rearranges it and keeps it from ordering. A shake may also lock clusters into each other or
/// push one astride a thin wall; then it did not happen.
double press(Growth& pack, double radius, std::uint64_t seed);

/// Shrinks a pack until it fits; the radius at which it does over the one it had.
double fitting_share(Growth& pack);

} // namespace demlua::packing
