// Loads on elements and given motions, with the work they do.
#pragma once

#include "engine/state/state.hpp"

namespace demlua::step {

/// Adds the loads of the present instant to the forces.
void add_loads(state::State& state);

/// Replaces, on every driven degree of freedom, the force by the one that brings about the velocity asked for half a
/// step from now. Later drives prevail.
void apply_drives(state::State& state);

/// Books half a step's work of loads and drives with the velocities as they are: called just before and just after the
/// kick, so that the work counted up to any instant is the mean of the forces at the ends of each step times its
/// displacement.
void book_work(state::State& state);

} // namespace demlua::step
