// Forces in contacts between elements.
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/state.hpp"
#include "engine/step/kernels.hpp"

namespace demlua::step {

/// Where the columns of contacts, and of the elements they ask for, begin.
ContactRows rows_of(state::Contacts& contacts);
PlaceRows places_of(const state::Elements& elements);

/// Fills overlap .. moment_j of all contacts and adds their forces to the elements.
void contact_forces(state::State& state, const Kernels& kernels, Team& team);

} // namespace demlua::step
