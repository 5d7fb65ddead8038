// Forces in contacts between elements.
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/state.hpp"
#include "engine/step/kernels.hpp"

namespace demlua::step {

/// Where the columns of contacts, and of the elements they ask for, begin.
ContactRows rows_of(state::Contacts& contacts);
PlaceRows rows_of_places(const state::Elements& elements);

/// Fills fx .. moment_j of all contacts and adds their forces to the elements. `records` is room for the elements' records.
void contact_forces(state::State& state, Column<double>& records, const Kernels& kernels, Team& team);

} // namespace demlua::step
