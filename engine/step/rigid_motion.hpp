// Elements that move as one: whole bodies, or clusters (Tavarez & Plesha 2007, section 3).
//
//   M v' = sum f + M g,   J w' = sum (m + (x - X) x f)        over the elements of the rigid body
//   x = X + Q (x0 - X0),  theta = w                           Q the turn since the start
//
// The forces within are not known: nothing inside can yield or break.
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/state.hpp"
#include "engine/step/motion.hpp"

#include <cstddef>

namespace demlua::step {

/// Sums the forces on the elements of each rigid body, and its weight.
void gather_rigid(state::State& state, Team& team);

/// Kicks rigid bodies, moves them, and lets their elements follow, the forces on them cleared: velocities are those of the
/// chord, so that contacts see the displacement there is.
Drift move_rigid(state::State& state, double greatest_move, Team& team);

/// Lets element `k` go from its rigid body, which carries on with what is left of mass, momentum and moment of momentum. Of
/// two elements both go; a rigid body without elements has neither mass nor motion.
void let_go_of_rigid(state::State& state, std::size_t k);

} // namespace demlua::step
