// Which corners of outlines may touch which walls and other outlines.
#pragma once

#include "engine/state/state.hpp"

#include <cstddef>
#include <vector>

namespace demlua::step {

/// Lists every part of every wall and outline within `skin` (m) of a corner of an outline, where at least one of the two moves
/// freely; histories of those that stay are kept, what the others had spent is booked.
void refresh_outline_contacts(state::State& state, double skin);

/// A wall or outline, and an outline that lies across it or in it, as rows of State::walls.
struct Crossing {
    std::size_t wall = 0;
    std::size_t outline = 0;
    Vec2 place; ///< where, m
};

/// All such pairs of which one moves freely. An outline counts without its corners, so that what presses does not cross.
std::vector<Crossing> crossing_outlines(const state::State& state);

/// All such pairs of which none does: their motion is given, so they carry no contact and pass through each other.
std::vector<Crossing> passing_outlines(const state::State& state);

} // namespace demlua::step
