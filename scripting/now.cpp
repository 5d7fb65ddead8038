// `now`: the simulation as it stands, read by callbacks and between runs. A reading of a scene that does not simulate
// gives zeros, so that the script can be followed to its end.
#include "engine/model/check.hpp"
#include "scripting/handles.hpp"
#include "scripting/read.hpp"
#include "scripting/readings.hpp"
#include "scripting/sandbox.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace demlua::scripting {

using model::Selection;
using observe::Simulation;

namespace {

template <class Source>
void push_reading(lua_State* L, const Reading<Source>& reading, const Source& source) {
    if (const auto* number = std::get_if<0>(&reading.get)) {
        const double value = (*number)(source);
        const auto whole = static_cast<lua_Integer>(std::abs(value) < 9e15 ? value : 0.0);
        // Counts read as whole numbers print as such.
        if (reading.unit.empty() && static_cast<double>(whole) == value) {
            lua_pushinteger(L, whole);
        } else {
            lua_pushnumber(L, value);
        }
    } else if (const auto* vector = std::get_if<1>(&reading.get)) {
        push_vector(L, (*vector)(source));
    } else {
        const std::string text = std::get<2>(reading.get)(source);
        lua_pushlstring(L, text.data(), text.size());
    }
}

template <class Source>
void push_all(lua_State* L, const std::vector<Reading<Source>>& readings, const Source& source, const char* what) {
    lua_createtable(L, 0, static_cast<int>(readings.size()));
    for (const auto& reading : readings) {
        push_reading(L, reading, source);
        lua_setfield(L, -2, reading.name.c_str());
    }
    make_strict(L, what);
}

/// The simulation to read, or null when none is run; throws before the first run.
Simulation* readable(lua_State* L) {
    const Context& context = Context::of(L);
    context.require_run();
    return context.simulation();
}

observe::BodyMotion motion_of(lua_State* L, std::size_t body) {
    const Simulation* const simulation = readable(L);
    return simulation == nullptr ? observe::BodyMotion{} : simulation->body_motion(body);
}

observe::WallMotion motion_of_wall(lua_State* L, std::size_t wall) {
    const Simulation* const simulation = readable(L);
    return simulation == nullptr ? observe::WallMotion{} : simulation->wall_motion(wall);
}

template <class Source>
std::vector<std::string> names_of(const std::vector<Reading<Source>>& readings) {
    std::vector<std::string> names;
    names.reserve(readings.size());
    for (const auto& reading : readings) names.push_back(reading.name);
    return names;
}

template <class Named>
std::size_t find_named(const std::vector<Named>& all, const std::string& name, const char* word) {
    std::vector<std::string> known;
    for (std::size_t row = 0; row < all.size(); ++row) {
        if (all[row].name == name) return row;
        known.push_back(all[row].name);
    }
    const std::string hint = model::did_you_mean(name, known);
    throw LuaFailure(std::string("there is no ") + word + " \"" + name + "\"" + (hint.empty() ? "" : "; " + hint));
}

int bodies_index(lua_State* L) {
    push_body_motion(L, find_named(Context::of(L).scene.bodies, asked_key(L), "body"));
    return 1;
}

struct Named {
    std::string name;
};

int walls_index(lua_State* L) {
    const model::Scene& scene = Context::of(L).scene;
    std::vector<Named> all;
    for (const model::Wall& wall : scene.walls) all.push_back({wall.name});
    for (const model::Outline& outline : scene.outlines) all.push_back({outline.name});
    push_wall_motion(L, find_named(all, asked_key(L), "wall"));
    return 1;
}

int stop(lua_State* L) {
    const Context& context = Context::of(L);
    if (test<Now>(L, 1) == nullptr) throw LuaFailure("call it with a colon: now:stop(\"reason\")");
    if (context.watched == nullptr) throw LuaFailure("now:stop is for functions called during a run");
    context.watched->stop(lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "");
    return 0;
}

int frame(lua_State* L) {
    const Context& context = Context::of(L);
    if (test<Now>(L, 1) == nullptr) throw LuaFailure("call it with a colon: now:frame()");
    if (context.watched == nullptr) throw LuaFailure("now:frame is for functions called during a run");
    context.host->frame();
    return 0;
}

bool push_method(lua_State* L, const std::string& key) {
    constexpr std::array<luaL_Reg, 5> methods{{{"mean", guarded<read_mean>},
                                               {"sum", guarded<read_sum>},
                                               {"field", guarded<read_field>},
                                               {"frame", guarded<frame>},
                                               {"stop", guarded<stop>}}};
    const auto* const found =
        std::find_if(methods.begin(), methods.end(), [&](const luaL_Reg& each) { return key == each.name; });
    if (found == methods.end()) return false;
    lua_pushcfunction(L, found->func);
    return true;
}

void push_scalar(lua_State* L, const std::string& key) {
    const auto& readings = now_readings();
    const auto found =
        std::find_if(readings.begin(), readings.end(), [&](const auto& each) { return each.name == key; });
    if (found == readings.end()) {
        std::vector<std::string> known = names_of(readings);
        for (const char* name : {"ledger", "momentum", "body", "wall", "mean", "sum", "field", "frame", "stop"}) {
            known.emplace_back(name);
        }
        unknown_field("now", key, known);
    }
    if (const Simulation* const simulation = readable(L)) {
        push_reading(L, *found, *simulation);
    } else {
        lua_pushinteger(L, 0);
    }
}

int now_index(lua_State* L) {
    const std::string key = asked_key(L);
    if (push_method(L, key)) return 1;
    if (key == "body") {
        push(L, BodiesNow{});
    } else if (key == "wall") {
        push(L, WallsNow{});
    } else if (key == "ledger") {
        const Simulation* const simulation = readable(L);
        push_all(L, ledger_readings(), simulation == nullptr ? observe::Ledger{} : simulation->ledger(),
                 "entry of the ledger");
    } else if (key == "momentum") {
        const Simulation* const simulation = readable(L);
        push_all(L, momentum_readings(), simulation == nullptr ? observe::Momentum{} : simulation->momentum(),
                 "part of the momentum");
    } else {
        push_scalar(L, key);
    }
    return 1;
}

/// The field named by argument 2 over the object the method was called on, and for `now` over argument 3, if any.
std::vector<double> field_values(lua_State* L) {
    const std::string name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    const std::vector<std::string> known = observe::measurable_fields();
    if (std::find(known.begin(), known.end(), name) == known.end()) {
        const std::string hint = model::did_you_mean(name, known);
        throw LuaFailure(describe(L, 2) + " is not a field of elements" + (hint.empty() ? "" : "; " + hint));
    }
    Selection selection;
    const Call call(L, "selection");
    const std::size_t before = call.context.complaints;
    const std::size_t functions = call.context.place_functions.size();
    const int index = test<Now>(L, 1) != nullptr ? 3 : 1;
    if (!lua_isnoneornil(L, index)) read_selection(call, "selection", index, selection);
    call.context.place_functions.resize(functions); // used at once, it needs no trial
    Simulation* const simulation = readable(L);
    if (simulation == nullptr || call.context.complaints != before) return {0.0};
    return simulation->field(name, selection);
}

double total(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

} // namespace

void push_vector(lua_State* L, Vec2 vector) {
    lua_createtable(L, 0, 2);
    lua_pushnumber(L, vector.x);
    lua_setfield(L, -2, "x");
    lua_pushnumber(L, vector.y);
    lua_setfield(L, -2, "y");
    make_strict(L, "component");
}

void push_body_motion(lua_State* L, std::size_t body) {
    push_all(L, body_readings(), motion_of(L, body), "reading of a body");
}

bool push_body_field(lua_State* L, std::size_t body, const std::string& field) {
    for (const auto& reading : body_readings()) {
        if (reading.name != field) continue;
        push_reading(L, reading, motion_of(L, body));
        return true;
    }
    return false;
}

void push_bond_break(lua_State* L, const observe::BondBreak& event) {
    push_all(L, break_readings(), event, "reading of an event");
}

std::vector<std::string> body_field_names() { return names_of(body_readings()); }

void push_wall_motion(lua_State* L, std::size_t wall) {
    push_all(L, wall_readings(), motion_of_wall(L, wall), "reading of a wall");
}

bool push_wall_field(lua_State* L, std::size_t wall, const std::string& field) {
    for (const auto& reading : wall_readings()) {
        if (reading.name != field) continue;
        push_reading(L, reading, motion_of_wall(L, wall));
        return true;
    }
    return false;
}

std::vector<std::string> wall_field_names() { return names_of(wall_readings()); }

int read_mean(lua_State* L) {
    const std::vector<double> values = field_values(L);
    lua_pushnumber(L, values.empty() ? 0.0 : total(values) / static_cast<double>(values.size()));
    return 1;
}

int read_sum(lua_State* L) {
    lua_pushnumber(L, total(field_values(L)));
    return 1;
}

int read_field(lua_State* L) {
    const std::vector<double> values = field_values(L);
    lua_createtable(L, static_cast<int>(values.size()), 0);
    lua_Integer item = 0;
    for (const double value : values) {
        lua_pushnumber(L, value);
        lua_rawseti(L, -2, ++item);
    }
    return 1;
}

void add_now(lua_State* L) {
    define<Now>(L, guarded<now_index>);
    define<BodiesNow>(L, guarded<bodies_index>);
    define<WallsNow>(L, guarded<walls_index>);
}

} // namespace demlua::scripting
