// sim:run, sim:solve_static and the user's functions that run between steps.
#pragma once

#include "scripting/context.hpp"

namespace demlua::scripting {

/// Runs the scene as it stands for `duration` (s), less if it is to end at rest, or, when nothing is simulated, notes that it would. Throws SceneError
/// and RunError.
observe::RunReport run_now(Context& context, double duration, bool until_rest, const Place& place);

/// The same from rest to rest.
observe::RunReport run_slowly_now(Context& context, const model::QuasiStaticRun& said);

/// The same for a static solution.
observe::RunReport solve_now(Context& context, const model::StaticSolve& said);

} // namespace demlua::scripting
