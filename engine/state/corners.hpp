// The corners of a rigid figure as what meets walls and other figures.
//
//   centre = corner + (r/sin a) b      b unit vector inwards along the bisector, 2 a the angle of the corner
//
// A disk of radius r that touches both sides of the corner from within stands for it, so that a side that lies on a wall
// touches it where it should, and a corner meets a wall as an element does (step/wall_parts.hpp). What is left out is the tip,
// (1/sin a - 1) r of it. Where a figure turns inwards or goes straight on nothing meets a wall first; the disk is then no more than
// a place within the figure.
#pragma once

#include "engine/base/vec2.hpp"

#include <vector>

namespace demlua::state {

struct Corner {
    Vec2 centre;         ///< m
    double radius = 0.0; ///< m
    bool meets = false;  ///< whether the figure turns outwards here
};

/// One for every point of a closed path, in either sense. Radii are `rounding` (m), or less where a disk would touch a side
/// farther from the corner than a quarter of the side, or would not lie within the figure.
std::vector<Corner> corners_of_path(const std::vector<Vec2>& path, double rounding);

} // namespace demlua::state
