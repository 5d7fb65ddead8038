// dem.simulation and the words said to it.
#include "engine/model/check.hpp"
#include "engine/model/settings.hpp"
#include "scripting/grains.hpp"
#include "scripting/read.hpp"
#include "scripting/running.hpp"
#include "scripting/sandbox.hpp"
#include "scripting/signals.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace demlua::scripting {

using namespace model;

namespace {

int simulation(lua_State* L) {
    Context& context = Context::of(L);
    const Call call(L, words::simulation().name());
    if (context.simulation_said) {
        call.complain("simulation", "", "only one to a scene", "", Cause::wording);
    } else {
        context.scene.place = call.place;
        context.simulation_said = true;
        read(call, 1, words::simulation(), context.scene);
    }
    push(L, SimulationHandle{});
    return 1;
}

/// The call of a word said to the simulation, whose table is argument 2.
Call call_on_simulation(lua_State* L, const Word& word) {
    if (test<SimulationHandle>(L, 1) == nullptr) {
        throw LuaFailure("call it with a colon: " + word.call + " { ... }");
    }
    return {L, word.name()};
}

/// Reads one more row of a part of the scene; a row with mistakes stays, so that handles to it do.
template <class T>
T& add_row(const Call& call, const WordOf<T>& word, std::vector<T>& rows) {
    T fresh{};
    fresh.place = call.place;
    read(call, 2, word, fresh);
    rows.push_back(std::move(fresh));
    call.context.grown = true;
    return rows.back();
}

/// The same for rows with signals, which functions of time must find where they will stay.
template <class T>
int add_load(lua_State* L, const WordOf<T>& word, std::vector<T>& rows, LoadKind kind) {
    Call call = call_on_simulation(L, word);
    rows.emplace_back();
    rows.back().place = call.place;
    call.load = LoadHandle{kind, rows.size() - 1};
    read(call, 2, word, rows.back());
    call.context.grown = true;
    call.context.changed.push_back(*call.load);
    push(L, *call.load);
    return 1;
}

Scene& scene_of(lua_State* L) { return Context::of(L).scene; }

void refuse_once_running(const Call& call) {
    if (!call.context.runs.empty()) {
        call.complain(call.label, "", "must stand before the first sim:run", "", Cause::wording);
    }
}

int body(lua_State* L) {
    const Call call = call_on_simulation(L, words::body());
    refuse_once_running(call);
    add_row(call, words::body(), scene_of(L).bodies);
    push(L, BodyHandle{scene_of(L).bodies.size() - 1});
    return 1;
}

int grains(lua_State* L) {
    const Call call = call_on_simulation(L, words::grains());
    refuse_once_running(call);
    GrainsSaid said;
    said.place = call.place;
    read(call, 2, words::grains(), said);
    if (said.sizes.empty()) said.sizes = {{1.0, 1.0, 1.0}}; // complained of, if it was not given
    scene_of(L).bodies.push_back(body_of(said));
    call.context.grown = true;
    push(L, BodyHandle{scene_of(L).bodies.size() - 1});
    return 1;
}

/// Without a word about the ways of motion all are held; naming some that are, the others are free.
int fix(lua_State* L) {
    const Call call = call_on_simulation(L, words::fix());
    Support& support = add_row(call, words::fix(), scene_of(L).supports);
    if (lua_type(L, 2) != LUA_TTABLE) return 0;
    const std::vector<std::string> said = string_keys(L, 2);
    const std::array<std::pair<const char*, bool*>, 3> ways{
        {{"x", &support.x}, {"y", &support.y}, {"rotation", &support.rotation}}};
    const auto named = [&](const auto& way) { return std::find(said.begin(), said.end(), way.first) != said.end(); };
    const bool some = std::any_of(ways.begin(), ways.end(), [&](const auto& way) { return named(way) && *way.second; });
    for (const auto& way : ways) {
        if (some && !named(way)) *way.second = false;
    }
    return 0;
}

int move(lua_State* L) { return add_load(L, words::move(), scene_of(L).motions, LoadKind::motion); }
int force(lua_State* L) { return add_load(L, words::force(), scene_of(L).forces, LoadKind::force); }
int traction(lua_State* L) { return add_load(L, words::traction(), scene_of(L).tractions, LoadKind::traction); }

int wall(lua_State* L) {
    refuse_once_running(call_on_simulation(L, words::wall()));
    add_load(L, words::wall(), scene_of(L).walls, LoadKind::wall);
    lua_pop(L, 1);
    push(L, WallHandle{scene_of(L).walls.size() - 1});
    return 1;
}

int outline(lua_State* L) {
    const Call call = call_on_simulation(L, words::outline());
    refuse_once_running(call);
    add_row(call, words::outline(), scene_of(L).outlines);
    push(L, OutlineHandle{scene_of(L).outlines.size() - 1});
    return 1;
}

template <class T, const WordOf<T>& (*word)(), std::vector<T> Scene::*rows>
int add(lua_State* L) {
    add_row(call_on_simulation(L, word()), word(), scene_of(L).*rows);
    return 0;
}

int contact(lua_State* L) {
    const Call call = call_on_simulation(L, words::contact());
    refuse_once_running(call);
    add_row(call, words::contact(), scene_of(L).contact_rules);
    return 0;
}

// --- what a run is asked for -----------------------------------------------------------------------------------------

/// One column under its name; the value is on top of the stack.
void add_column(const Call& call, const std::string& name, History& history) {
    lua_State* const L = call.L;
    const int index = lua_gettop(L);
    if (lua_type(L, index) == LUA_TFUNCTION) {
        history.columns.push_back({name, Function(L, index), ""});
        return;
    }
    const std::string what = "history." + name;
    const std::vector<std::string> known = observe::measurable_fields();
    const std::string measure = lua_type(L, index) == LUA_TSTRING ? lua_tostring(L, index) : "";
    if (measure.empty()) {
        call.complain(what, describe(L, index), "must be a function of now or the name of an element field", "",
                      Cause::wording);
    } else if (std::find(known.begin(), known.end(), measure) == known.end()) {
        call.complain(what, describe(L, index), "is not a field of elements", did_you_mean(measure, known),
                      Cause::wording);
    } else {
        history.columns.push_back({name, {}, measure});
    }
}

/// What is asked of runs cannot be asked of the one that is going on, whose time step is fitted to its intervals.
Call call_between_runs(lua_State* L, const Word& word, const std::string& instead) {
    if (Context::of(L).watched != nullptr) {
        throw LuaFailure(word.call + " cannot be called while a run is going on" + instead);
    }
    return call_on_simulation(L, word);
}

int history(lua_State* L) {
    const Call call = call_between_runs(L, words::history(), "; call it before and change it with history:set");
    HistorySaid said;
    const bool good = read(call, 2, words::history(), said);
    const auto interval = std::make_shared<Interval>(said.every);
    push(L, HistoryHandle{interval});
    if (lua_type(L, 2) != LUA_TTABLE) return 1;
    History made{interval, {}, call.place};
    for (const std::string& name : string_keys(L, 2)) {
        if (words::history().find(name) != nullptr) continue;
        lua_pushstring(L, name.c_str());
        lua_rawget(L, 2);
        add_column(call, name, made);
        lua_pop(L, 1);
    }
    if (good) call.context.histories.push_back(std::move(made));
    return 1;
}

int output(lua_State* L) {
    OutputSaid said;
    const Call call = call_between_runs(L, words::output(), "; call it before and change it with output:set");
    const bool good = read(call, 2, words::output(), said);
    const auto interval = std::make_shared<Interval>(said.every);
    if (good) call.context.outputs.push_back(interval);
    push(L, OutputHandle{interval});
    return 1;
}

int every(lua_State* L) {
    EverySaid said;
    const Call call = call_between_runs(L, words::every(), "");
    if (!read(call, 2, words::every(), said)) return 0;
    call.context.periodics.push_back({said.interval, call.context.functions[said.act.key - 1]});
    return 0;
}

/// The function may stand alone, without a table round it.
int on_bond_break(lua_State* L) {
    const Call call = call_between_runs(L, words::on_bond_break(), "");
    if (lua_type(L, 2) == LUA_TFUNCTION) {
        lua_createtable(L, 1, 0);
        lua_insert(L, 2);
        lua_rawseti(L, 2, 1);
    }
    BondBreakSaid said;
    if (!read(call, 2, words::on_bond_break(), said)) return 0;
    call.context.on_bond_break.push_back(call.context.functions[said.act.key - 1]);
    return 0;
}

int run(lua_State* L) {
    RunSaid said;
    const Call call = call_on_simulation(L, words::run());
    read(call, 2, words::run(), said);
    model::QuasiStaticRun slowly;
    slowly.duration = said.duration;
    slowly.runs_after = said.runs_after;
    slowly.place = call.place;
    const observe::RunReport report = said.driver == Driver::quasi_static
                                          ? run_slowly_now(call.context, slowly)
                                          : run_now(call.context, said.duration, said.until_rest, call.place);
    lua_createtable(L, 0, 3);
    lua_pushstring(L, report.ending == observe::Ending::stopped ? "stopped" : "finished");
    lua_setfield(L, -2, "ending");
    lua_pushlstring(L, report.reason.data(), report.reason.size());
    lua_setfield(L, -2, "reason");
    lua_pushinteger(L, static_cast<lua_Integer>(report.steps));
    lua_setfield(L, -2, "steps");
    make_strict(L, "field of a report");
    return 1;
}

int solve_static(lua_State* L) {
    const Call call = call_on_simulation(L, words::solve_static());
    StaticSolve said;
    said.place = call.place;
    if (!lua_isnoneornil(L, 2)) read(call, 2, words::solve_static(), said);
    const observe::RunReport report = solve_now(call.context, said);
    lua_createtable(L, 0, 2);
    lua_pushinteger(L, report.solutions);
    lua_setfield(L, -2, "solutions");
    lua_pushnumber(L, report.residual);
    lua_setfield(L, -2, "residual");
    make_strict(L, "field of a report");
    return 1;
}

/// sim.now beside the words.
int simulation_index(lua_State* L) {
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : describe(L, 2);
    if (key == "now") {
        push(L, Now{});
        return 1;
    }
    lua_pushstring(L, key.c_str());
    if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 1;
    std::vector<std::string> known = string_keys(L, lua_upvalueindex(1));
    known.emplace_back("now");
    const std::string hint = did_you_mean(key, known);
    throw LuaFailure("unknown word of sim \"" + key + "\"" + (hint.empty() ? "" : "; " + hint));
}

} // namespace

void add_simulation(lua_State* L) {
    lua_pushcfunction(L, guarded<simulation>);
    lua_setfield(L, -2, "simulation");
    define<SimulationHandle>(L, nullptr);
    luaL_getmetatable(L, object_name<SimulationHandle>);
    lua_createtable(L, 0, 19);
    constexpr std::array<luaL_Reg, 20> methods{
        {{"body", guarded<body>},
         {"grains", guarded<grains>},
         {"fix", guarded<fix>},
         {"move", guarded<move>},
         {"force", guarded<force>},
         {"traction", guarded<traction>},
         {"wall", guarded<wall>},
         {"outline", guarded<outline>},
         {"contact", guarded<contact>},
         {"notch", guarded<add<Notch, words::notch, &Scene::notches>>},
         {"damping", guarded<add<Damping, words::damping, &Scene::dampings>>},
         {"probe", guarded<add<Probe, words::probe, &Scene::probes>>},
         {"bond_probe", guarded<add<BondProbe, words::bond_probe, &Scene::bond_probes>>},
         {"history", guarded<history>},
         {"output", guarded<output>},
         {"every", guarded<every>},
         {"on_bond_break", guarded<on_bond_break>},
         {"run", guarded<run>},
         {"solve_static", guarded<solve_static>},
         {nullptr, nullptr}}};
    luaL_setfuncs(L, methods.data(), 0);
    lua_pushcclosure(L, guarded<simulation_index>, 1);
    lua_setfield(L, -2, "__index");
    lua_pop(L, 1);
}

} // namespace demlua::scripting
