#include "scripting/running.hpp"

#include "engine/observe/bond_breaks.hpp"
#include "scripting/handles.hpp"
#include "scripting/read.hpp"
#include "scripting/signals.hpp"

#include <algorithm>
#include <utility>

namespace demlua::scripting {

namespace {

/// The simulation a callback looks at, for as long as it does.
class Watching {
public:
    Watching(Context& context, observe::Simulation& simulation)
        : context_(context), before_(std::exchange(context.watched, &simulation)) {}
    ~Watching() { context_.watched = before_; }
    Watching(const Watching&) = delete;
    Watching& operator=(const Watching&) = delete;
    Watching(Watching&&) = delete;
    Watching& operator=(Watching&&) = delete;

private:
    Context& context_;
    observe::Simulation* before_;
};

/// Calls a function with `now`, after the event if there is one; what it changed is passed on, what it said wrong ends the
/// run. Leaves `results` on the stack.
Interpreter& call_with_now(Context& context, observe::Simulation& simulation, const Function& function, int results,
                           const observe::BondBreak* event = nullptr) {
    const Watching watching(context, simulation);
    Interpreter& interpreter = function.push();
    if (event != nullptr) push_bond_break(interpreter.L, *event);
    push(interpreter.L, Now{});
    interpreter.call(interpreter.L, event == nullptr ? 1 : 2, results);
    if (context.fatal) std::rethrow_exception(context.fatal);
    sample_changed(context, simulation.time(), context.run_end);
    context.throw_problems();
    pass_on_changes(context);
    return interpreter;
}

double column_value(Context& context, observe::Simulation& simulation, const HistoryColumn& column,
                    const Place& place) {
    if (!column.function) return simulation.measure(column.measure, {});
    Interpreter& interpreter = call_with_now(context, simulation, column.function, 1);
    lua_State* const L = interpreter.L;
    const bool number = lua_type(L, -1) == LUA_TNUMBER;
    const std::string hint = lua_type(L, -1) == LUA_TTABLE ? "of a pair take .x or .y" : "";
    const double value = lua_tonumber(L, -1);
    const std::string given = describe(L, -1);
    lua_pop(L, 1);
    if (number) return value;
    throw SceneError(Problem{place, "history." + column.name, given, "must return a number", hint});
}

HistoryRequest request_of(Context& context, const History& history) {
    HistoryRequest request{history.interval, {}, history.place};
    for (const HistoryColumn& column : history.columns) {
        request.columns.emplace_back(column.name,
                                     [&context, column, place = history.place](observe::Simulation& simulation) {
                                         return column_value(context, simulation, column, place);
                                     });
    }
    return request;
}

/// Looks after every step; each function hears of all bonds that broke in it.
observe::Watcher break_watcher(Context& context) {
    return {0.0, [&context, watch = observe::BreakWatch{}](observe::Simulation& simulation) mutable {
                for (const observe::BondBreak& event : watch.fresh(simulation)) {
                    for (const Function& function : context.on_bond_break) {
                        call_with_now(context, simulation, function, 0, &event);
                    }
                }
            }};
}

/// How to go on: by steps of motion unless one of these is given.
struct Way {
    std::optional<model::StaticSolve> rest;
    std::optional<model::QuasiStaticRun> slowly;
    bool until_rest = false;
};

RunRequest request_of(Context& context, double duration, const Way& way, const Place& place) {
    RunRequest request{duration, way.until_rest, way.rest, way.slowly, context.outputs, {}, {}, place};
    for (const History& history : context.histories) request.histories.push_back(request_of(context, history));
    if (!context.on_bond_break.empty()) request.callbacks.push_back(break_watcher(context));
    for (const Periodic& periodic : context.periodics) {
        request.callbacks.push_back({periodic.every, [&context, act = periodic.act](observe::Simulation& simulation) {
                                         call_with_now(context, simulation, act, 0);
                                     }});
    }
    return request;
}

RunRequest without_functions(RunRequest request) {
    for (HistoryRequest& history : request.histories) {
        for (auto& column : history.columns) column.second = nullptr;
    }
    for (observe::Watcher& watcher : request.callbacks) watcher.act = nullptr;
    return request;
}

/// How long functions of time are followed, s: a static solution reads them at one instant.
double followed_for(double duration, double begin) { return duration > 0.0 ? duration : 1e-6 * std::max(begin, 1.0); }

observe::RunReport go_on(Context& context, double duration, const Way& way, const Place& place) {
    const std::string word = way.rest ? "solve_static" : "run";
    if (context.interrupted) throw LuaFailure("interrupted");
    if (context.watched != nullptr) throw LuaFailure("sim:" + word + " cannot be called while a run is going on");
    const bool first = context.runs.empty();
    const double begin = context.time();
    context.run_end = begin + duration;
    if (first && context.scene.bodies.empty()) {
        context.complain({place, word, "", "there is no body to run", ""}, Cause::value);
    }
    if (way.rest || duration > 0.0) sample_time_functions(context, begin, begin + followed_for(duration, begin));
    try_place_functions(context);
    if (first || context.simulates()) context.check_model();
    const RunRequest request = request_of(context, duration, way, place);
    if (first) context.scene_at_first_run = context.scene;
    if (!context.simulates()) {
        context.runs.push_back(without_functions(request));
        context.skipped_time += duration;
        return {};
    }
    context.throw_problems();
    pass_on_changes(context);
    context.runs.push_back(without_functions(request));
    note_assembled(context);
    observe::RunReport report = context.host->run(context.scene, request);
    if (report.ending == observe::Ending::interrupted) {
        context.interrupted = true;
        throw LuaFailure("interrupted");
    }
    return report;
}

} // namespace

observe::RunReport run_now(Context& context, double duration, bool until_rest, const Place& place) {
    return go_on(context, duration, {std::nullopt, std::nullopt, until_rest}, place);
}

observe::RunReport solve_now(Context& context, const model::StaticSolve& said) {
    return go_on(context, 0.0, {said, std::nullopt, false}, said.place);
}

observe::RunReport run_slowly_now(Context& context, const model::QuasiStaticRun& said) {
    return go_on(context, said.duration, {std::nullopt, said, false}, said.place);
}

} // namespace demlua::scripting
