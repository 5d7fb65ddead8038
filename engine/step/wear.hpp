// Elements that sliding takes out of their clusters (state/wear.hpp).
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/state.hpp"
#include "engine/step/search.hpp"

namespace demlua::step {

/// W_i of every element at this instant, J.
Column<double> sliding_work(const state::State& state, Team& team);

/// Sums what sliding has spent on each element up to the last instant, and takes those beyond their limit out of their
/// clusters, lowest number first: they leave their rigid body, or their bonds are marked to break at the coming computation
/// of forces. Between former mates of a rigid cluster contacts begin without force. Returns whether bonds were marked.
/// To be called with positions moved on and forces cleared.
bool wear_out(state::State& state, Search& search, Team& team);

} // namespace demlua::step
