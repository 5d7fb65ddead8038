// A plane that repeats along x.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/base/vec2.hpp"

#include <cmath>

namespace demlua {

/// What stands at x stands at x + length too. Without a length nothing repeats.
struct Period {
    double left = 0.0;   ///< m
    double length = 0.0; ///< m

    [[nodiscard]] bool repeats() const { return length > 0.0; }
    /// The shortest of all vectors along which `between` leads.
    template <class T>
    [[nodiscard]] Vector2<T> shortest(Vector2<T> between) const {
        return {between.x - length * nearest_whole(between.x / T{length}), between.y};
    }
    /// By how much to shift `x` to bring it between the edges, m.
    [[nodiscard]] double shift_inside(double x) const { return -length * std::floor((x - left) / length); }
};

} // namespace demlua
