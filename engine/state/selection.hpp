// From what a user selects to rows of elements.
#pragma once

#include "engine/base/column.hpp"
#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

namespace demlua::state {

/// Rows of the elements that agree with every part of the selection, rising. A side of a body is every element whose disk
/// comes within half a radius of the body's extreme on that side. Throws SceneError when a function of place fails.
Column<Index> selected(const model::Selection& selection, const State& state);

} // namespace demlua::state
