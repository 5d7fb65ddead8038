// From walls and outlines as said to walls of a state.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

namespace demlua::state {

/// Walls in the scene's order, then outlines. Needs the materials and elements of the state.
void lay_out_walls(const model::Scene& scene, State& state);

/// Gives a wall the motion said. The side on which it presses is that of the middle of all elements now.
void set_motion(const model::Wall& said, const State& state, Wall& wall);
/// Gives an outline the motion said.
void set_motion(const model::Outline& said, Wall& outline);

} // namespace demlua::state
