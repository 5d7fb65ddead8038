// What no single setting shows: rules between the settings of a word, and between words.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/model/scene.hpp"

#include <string>
#include <vector>

namespace demlua::model {

/// Every problem of a scene that can be seen without packing it. `measurable` are the fields a probe can read.
std::vector<Problem> check(const Scene& scene, const std::vector<std::string>& measurable);

/// Why these cannot be the corners of a polygon, as a rule; empty when they can.
std::string polygon_fault(const std::vector<Vec2>& corners);

/// `did you mean "..."?` for the nearest of `known`; empty when none is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

} // namespace demlua::model
