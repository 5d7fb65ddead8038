#include "scripting/script.hpp"

#include "scripting/context.hpp"
#include "scripting/parameters.hpp"
#include "scripting/study_word.hpp"

#include <utility>

namespace demlua::scripting {

namespace {

/// Runs the scene's file to its end. What stopped it early is among the problems, unless it may only have stopped because
/// there were no results to read.
void read_to_the_end(Context& context, const std::filesystem::path& file) {
    try {
        try {
            context.run_file(file, {});
            complain_of_leftovers(context);
            context.read_to_end = true;
        } catch (const SceneError&) {
            if (!context.fatal) throw;
            std::rethrow_exception(context.fatal); // what stopped an included file, rather than its echo in this one
        }
    } catch (const SceneError& error) {
        for (const Problem& problem : error.problems()) context.complain(problem, Cause::value);
    }
    if (context.problems.empty()) finish_study(context);
}

} // namespace

SceneSummary check_scene(const std::filesystem::path& file, const Overrides& overrides) {
    Context context(overrides, nullptr);
    read_to_the_end(context, file);
    if (context.runs.empty()) {
        if (context.problems.empty() && !context.simulation_said) {
            context.complain({{file.string(), 0}, "dem.simulation", "", "is missing", ""}, Cause::value);
        }
        context.check_model();
        context.scene_at_first_run = context.scene;
    }
    context.throw_problems();
    return {std::move(context.scene_at_first_run),
            std::move(context.parameters),
            std::move(context.runs),
            std::move(context.files),
            std::move(context.study),
            context.read_to_end};
}

void run_scene(const std::filesystem::path& file, const Overrides& overrides, Host& host) {
    Context context(overrides, &host);
    try {
        context.run_file(file, {});
    } catch (const SceneError&) {
        // An interruption travels as a Lua error too, but is none; an exception of ours is more than its text.
        if (context.interrupted) return;
        if (context.fatal) std::rethrow_exception(context.fatal);
        if (context.problems.empty()) throw;
    }
    if (context.interrupted) return;
    if (context.fatal) std::rethrow_exception(context.fatal);
    context.throw_problems();
}

} // namespace demlua::scripting
