// What materials mean for elements, alone and in pairs.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

namespace demlua::state {

/// Fills materials and the rules of contacts between any two of them: springs in series, the smaller friction and rolling
/// friction, the mean fraction of critical damping, or what the scene says of the pair.
void lay_out_materials(const model::Scene& scene, State& state);

} // namespace demlua::state
