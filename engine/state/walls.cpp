#include "engine/state/walls.hpp"

namespace demlua::state {

void Wall::place() {
    points.resize(path.size());
    for (std::size_t k = 0; k < path.size(); ++k) {
        // A wall that has not turned keeps its coordinates to the last digit.
        points[k] = rotation == 0.0 ? path[k] + offset : centre_now() + turned(path[k] - centre, rotation);
    }
}

} // namespace demlua::state
