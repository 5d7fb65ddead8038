// What of a snapshot is to be seen, and where.
#pragma once

#include "engine/observe/snapshot.hpp"
#include "engine/state/state.hpp"

namespace demlua::observe {

/// In a plane that repeats, moves every part that hangs together back between the edges, as a whole, by its first element; of parts
/// bonded across the edge every element by itself, and bonds that then reach across are left out. Cracks are moved by their
/// middles.
void bring_inside(Snapshot& snapshot, const state::State& state);

/// Takes elements that left the domain out of the snapshot, and bonds with them.
void leave_out_gone(Snapshot& snapshot, const state::State& state);

} // namespace demlua::observe
