// Whether elements and walls leave each other room at the start.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

#include <vector>

namespace demlua::step {

/// A problem for each wall and body with an element that lies across the wall by more than a tenth of its radius, or
/// inside an outline, for each outline that lies across a wall or another outline, and for each that would meet its own image.
/// Reads the list of wall contacts as the search has just made it.
std::vector<Problem> elements_across_walls(const model::Scene& scene, const state::State& state);

/// A problem for each outline that would meet its own image, with which it has no contact, where the plane repeats: wider
/// than the period or, if it turns, longer.
std::vector<Problem> outlines_meeting_images(const model::Scene& scene, const state::State& state);

} // namespace demlua::step
