// Forces in contacts between elements.
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/state.hpp"

namespace demlua::step {

/// Fills fx .. moment_j of the contacts of one share. Lever arms are the distance shared in proportion to the radii, so
/// that a contact exchanges linear and angular momentum exactly.
void contact_forces(state::Contacts& contacts, const state::Elements& elements, Period period, double dt, Share part);

} // namespace demlua::step
