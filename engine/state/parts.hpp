// What hangs together by bonds.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace demlua::state {

/// For every element the number of the part it belongs to: parts are held together by bonds that are not broken, a rigid
/// body is one part, and parts are numbered from zero by their first element.
std::vector<std::int32_t> part_of_elements(const State& state);

/// The elements of each part, rising.
std::vector<std::vector<std::size_t>> elements_of_parts(const State& state);

/// `elements 5, 6, 7 ... (40 in all) of body "plate"`.
std::string name_elements(const State& state, const std::vector<std::size_t>& elements);

/// One sentence for each body whose bonds leave several parts of more than one element.
std::vector<std::string> separate_parts(const State& state);

/// A problem for each body with elements at one place, between which no bond has a direction.
std::vector<Problem> coincident_elements(const model::Scene& scene, const State& state);

} // namespace demlua::state
