#include "engine/state/walls.hpp"

namespace demlua::state {

Vec2 Wall::place_of(Vec2 at_start) const {
    // A wall that has not turned keeps its coordinates to the last digit.
    return rotation == 0.0 ? at_start + offset : centre_now() + turned(at_start - centre, rotation);
}

void Wall::place() {
    points.resize(path.size());
    for (std::size_t k = 0; k < path.size(); ++k) points[k] = place_of(path[k]);
}

} // namespace demlua::state
