// Whether elements and walls leave each other room at the start.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

#include <vector>

namespace demlua::step {

/// A problem for each wall and body with an element that lies across the wall by more than a tenth of its radius, or
/// inside an outline, and for each outline that lies across a wall or another outline. Reads the list of wall contacts as the search has just made it.
std::vector<Problem> elements_across_walls(const model::Scene& scene, const state::State& state);

} // namespace demlua::step
