// Signals as users say them: numbers, tables, ramps, functions of time.
#pragma once

#include "engine/model/setting.hpp"
#include "scripting/context.hpp"

namespace demlua::scripting {

/// The rows of the kind of load a handle points to, and the load itself.
const model::Word& word_of(LoadKind kind);
void* row_of(model::Scene& scene, const LoadHandle& load);
std::size_t count_of(const model::Scene& scene, LoadKind kind);

/// Samples every function of time over the run from `begin` to `end` (s), and marks its load changed.
void sample_time_functions(Context& context, double begin, double end);
/// The same for loads that have changed during the run.
void sample_changed(Context& context, double begin, double end);

/// Tells the simulation, when there is one, which loads have changed or been added since it last heard.
void pass_on_changes(Context& context);
/// Everything in the scene is known to the simulation now.
void note_assembled(Context& context);

} // namespace demlua::scripting
