// Signals as users say them: numbers, tables, ramps, functions of time.
#pragma once

#include "engine/model/setting.hpp"
#include "scripting/context.hpp"

#include <optional>
#include <string>
#include <vector>

namespace demlua::scripting {

/// The rows of the kind of load a handle points to, and the load itself.
const model::Word& word_of(LoadKind kind);
void* row_of(model::Scene& scene, const LoadHandle& load);
/// Functions of time said for a row no longer count.
void forget_functions(Context& context, const LoadHandle& load);

std::size_t count_of(const model::Scene& scene, LoadKind kind);

/// What one signal of a load is worth at the present instant; nothing when the load was not given it.
struct PresentValue {
    std::string setting;
    std::optional<double> value;
};
/// One for each setting of the load that takes a signal.
std::vector<PresentValue> present_values(Context& context, const LoadHandle& load);

/// Samples every function of time over the run from `begin` to `end` (s), and marks its load changed.
void sample_time_functions(Context& context, double begin, double end);
/// The same for loads that have changed during the run.
void sample_changed(Context& context, double begin, double end);

/// Tells the simulation, when there is one, which loads have changed or been added since it last heard.
void pass_on_changes(Context& context);
/// Everything in the scene is known to the simulation now.
void note_assembled(Context& context);

} // namespace demlua::scripting
