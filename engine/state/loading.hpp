// From supports, given motions, forces and tractions as said to drives and loads on rows of elements.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

#include <vector>

namespace demlua::state {

/// Each throws SceneError at the statement's place when its selection holds no element.
std::vector<Drive> drives_of(const model::Support& support, const State& state);
Column<Index> rows_of(const model::Motion& motion, const State& state);
Load load_of(const model::Force& force, const State& state);

/// Each element on the side takes the length of side nearest to its centre, up to the ends of the body's region (or of its
/// disks, if that is less). `body` is the body as said, for its region.
Load load_of(const model::Traction& traction, const model::Body& body, const State& state);

/// The drives of a motion for rows selected before, so that changing the motion does not change whom it moves.
std::vector<Drive> drives_of(const model::Motion& motion, const Column<Index>& rows, const State& state);

/// The drives that keep the elements of a traction from turning, when it asks for that.
std::vector<Drive> drives_of(const model::Traction& traction, const State& state);

} // namespace demlua::state
