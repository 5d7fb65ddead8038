// Where elements stand to the parts of a wall.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/state/walls.hpp"

#include <cstddef>

namespace demlua::step {

/// Where an element stands to a part of a wall: the unit normal from the wall to its centre and the distance, m.
struct WallGap {
    bool meets = false; ///< whether this part, and not a neighbour, is the nearest
    Vec2 normal;        ///< zero where the distance is
    double distance = 0.0;
};

/// `part` as in WallContacts; `centre` in m.
WallGap wall_gap(const state::Wall& wall, std::size_t part, Vec2 centre);

/// m, whether or not another part is nearer.
double distance_to_part(const state::Wall& wall, std::size_t part, Vec2 centre);

} // namespace demlua::step
