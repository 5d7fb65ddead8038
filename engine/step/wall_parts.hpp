// Elements against rigid lines.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/state/state.hpp"

namespace demlua::step {

/// Where an element stands to a part of a wall: the unit normal from the wall to its centre and the distance, m.
struct WallGap {
    bool meets = false; ///< whether this part, and not a neighbour, is the nearest
    Vec2 normal;
    double distance = 0.0;
};

/// `part` as in WallContacts; `centre` in m.
WallGap wall_gap(const state::Wall& wall, std::size_t part, Vec2 centre);

/// Lists every part of every wall within `skin` of an element's surface; histories of those that stay are kept.
void refresh_wall_contacts(state::State& state, double skin);

/// Adds the forces of walls to the elements, and those of the elements to the walls; books the walls' work.
void wall_forces(state::State& state);

/// Books the second half of the walls' work after a kick and moves them through the step.
void move_walls(state::State& state);

} // namespace demlua::step
