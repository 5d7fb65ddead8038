// Forces between the corners of outlines and walls or other outlines.
//
//   c = Cn/sqrt(n)       n corners of the two that touch now
//
// Otherwise a contact as of an element with a wall (law/coulomb.hpp, wall_parts.hpp): n contacts side by side are a spring n Kn
// and a dashpot sqrt(n) Cn, which for the same mass is the same fraction of critical, so that a figure that lands on a side
// comes back as fast as one that lands on a corner. Dashpots that change take nothing but what they spend.
// No corner passes a wall unseen, for the reason given in wall_forces.hpp: moves in a step are bounded by the corners' radii too.
#pragma once

#include "engine/state/state.hpp"

namespace demlua::step {

/// Adds to the forces on walls and outlines those of each other, in the order of the rows. Throws RunError naming the first pair
/// of which one has been pressed into the other.
void outline_forces(state::State& state);

} // namespace demlua::step
