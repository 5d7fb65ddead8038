// Elements that lie in one another across the edge of a box that repeats.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

#include <vector>

namespace demlua::state {

/// A problem for each two bodies, or body by itself, that lie in one another across the edge by more than a hundredth of a
/// diameter: they would start with forces nobody asked for.
std::vector<Problem> overlaps_across_edge(const model::Scene& scene, const State& state);

} // namespace demlua::state
