// Where elements stand to the parts of a wall.
#pragma once

#include "engine/base/period.hpp"
#include "engine/base/vec2.hpp"
#include "engine/state/walls.hpp"

#include <cstddef>
#include <vector>

namespace demlua::step {

/// Where an element stands to a part of a wall: the unit normal from the wall to its centre and the distance, m.
struct WallGap {
    bool meets = false; ///< whether this part, and not a neighbour, is the nearest
    Vec2 normal;        ///< zero where the distance is
    double distance = 0.0;
};

/// Where an element at `centre` stands as this part of the wall sees it: in a plane that repeats, the image nearest to the
/// part's middle, m.
Vec2 seen_from(const state::Wall& wall, std::size_t part, Vec2 centre, Period period);

/// By what to move a place so that it lies near another, `between` away from it: to its nearest image and, where the plane
/// repeats, to those on both sides of that, m.
std::vector<Vec2> shifts_to_images(Vec2 between, Period period);

/// `part` as in WallContacts; `centre` in m, as seen from the part.
WallGap wall_gap(const state::Wall& wall, std::size_t part, Vec2 centre);

/// Whether what slides along a wall can come from one of two parts to the other, by way of at most one between.
bool are_neighbours(const state::Wall& wall, std::size_t part, std::size_t other);

/// Whether a ray along x from the point crosses a closed path an odd number of times.
bool is_inside(const state::Wall& outline, Vec2 point);

/// m, whether or not another part is nearer.
double distance_to_part(const state::Wall& wall, std::size_t part, Vec2 centre);

} // namespace demlua::step
