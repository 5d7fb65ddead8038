// Forces between elements and walls.
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/state.hpp"

namespace demlua::step {

/// Share of its radius that must be left between an element's centre and a wall.
///
/// No centre passes through a wall unseen: in a step an element moves at most `greatest_move` of its radius R (motion.hpp)
/// and no point of a wall more than that share of the smallest radius (wall_motion.hpp), so that the way of a centre,
/// seen from the wall, is no longer than 2 greatest_move R, and that is at most R where greatest_move is at most 1/2 (model/check_walls.hpp).
/// A centre that crosses within a step is then nearer than R/2 to where it crosses, before or after, and nearer still to
/// the wall.
inline constexpr double least_clearance = 0.5;

/// Adds the forces of walls to the elements, and those of the elements to the walls, in the order of the rows. Throws
/// RunError naming the first element that has been pressed through a wall.
void wall_forces(state::State& state, Team& team);

} // namespace demlua::step
