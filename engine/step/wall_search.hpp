// Which elements may touch which parts of walls.
#pragma once

#include "engine/base/cell_grid.hpp"
#include "engine/state/state.hpp"
#include "engine/step/places.hpp"

namespace demlua::step {

/// Lists every part of every wall within `skin` (m) of an element's surface; histories of those that stay are kept, what
/// the others had spent is booked. `grid` holds `places`, where the elements stand now.
void refresh_wall_contacts(state::State& state, double skin, const Places& places, const CellGrid& grid);

} // namespace demlua::step
