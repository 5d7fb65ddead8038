// How walls move: as they are told, by a servo, or, with matter, freely.
#pragma once

#include "engine/state/state.hpp"
#include "engine/step/motion.hpp"

namespace demlua::step {

/// Books half a step's work of what gives walls their motion, from forces and velocities as they are.
void book_wall_work(state::State& state);

/// Gives walls their velocities, books the work of the first half of the step and moves them through it. Returns the
/// farthest any point of a wall has moved, m. Throws RunError naming a wall that moves more than the limit's share of the
/// smallest radius in a step (wall_forces.hpp says why), or whose servo has met nothing over its travel.
double move_walls(state::State& state, const TravelLimit& limit);

} // namespace demlua::step
