// Whether everything has come to rest.
#pragma once

#include "engine/state/state.hpp"

namespace demlua::observe {

/// Whether what moves has next to no motion and next to no force left on it: kinetic energy below `share` of what is stored
/// in bonds and contacts, and the mean force left on what is free to move below `share` of the mean force in contacts
/// and bonds. Elements in free flight are not at rest; where nothing presses, only standing still is.
bool at_rest(const state::State& state, double share);

} // namespace demlua::observe
