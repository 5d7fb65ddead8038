// Where a search looks for elements.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/state/state.hpp"

#include <cstddef>
#include <vector>

namespace demlua::step {

/// Where elements stand, and whose each place is. In a plane that repeats, elements near the left edge stand once more
/// beyond the right one. Elements taken out stand nowhere.
struct Places {
    std::vector<Vec2> at; ///< m
    std::vector<Index> element;
    std::size_t first_image = 0; ///< row from which on places are images
};

/// With images of all that stand within `reach` (m) of the left edge.
Places places_of(const state::State& state, double reach);

} // namespace demlua::step
