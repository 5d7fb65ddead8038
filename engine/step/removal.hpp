// Elements that leave the domain of the scene.
#pragma once

#include "engine/model/region.hpp"
#include "engine/state/state.hpp"

#include <cstddef>

namespace demlua::step {

/// Takes out every part (state/parts.hpp) of which no element's centre lies in the domain any more: its elements stand
/// still from now on, touch nothing and are not drawn. Their energy is booked. Returns how many elements. Elements near
/// enough to leave before the next search are found at it: none gets far beyond.
std::size_t remove_leavers(state::State& state, const model::Region& domain);

} // namespace demlua::step
