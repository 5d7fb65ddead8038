// What the objects in a scene's variables answer: beam.radius, beam.top, concrete.density, load:set, wall:move, ...
#include "scripting/handles.hpp"

#include "engine/model/check.hpp"
#include "engine/model/settings.hpp"
#include "engine/packing/grains.hpp"
#include "engine/packing/packing.hpp"
#include "scripting/read.hpp"
#include "scripting/sandbox.hpp"
#include "scripting/signals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace demlua::scripting {

using namespace model;

std::string asked_key(lua_State* L) {
    return lua_type(L, 2) == LUA_TSTRING ? std::string(lua_tostring(L, 2)) : describe(L, 2);
}

void unknown_field(const std::string& of, const std::string& key, const std::vector<std::string>& known) {
    const std::string hint = did_you_mean(key, known);
    throw LuaFailure("unknown field \"" + key + "\" of " + of + (hint.empty() ? "" : "; " + hint));
}

namespace {

/// The object a method was called on, which a dot in place of the colon would leave out.
template <class T>
T& self(lua_State* L, const std::string& call) {
    if (T* const object = test<T>(L, 1)) return *object;
    throw LuaFailure("call it with a colon: " + call);
}

// --- materials -------------------------------------------------------------------------------------------------------

int material_index(lua_State* L) {
    const std::string key = asked_key(L);
    const Setting* const setting = words::material().find(key);
    if (setting == nullptr) unknown_field("a material", key, words::material().setting_names());
    const Slot slot = setting->slot(&Context::of(L).scene.materials[test<MaterialHandle>(L, 1)->row]);
    if (const auto* const* text = std::get_if<std::string*>(&slot)) {
        lua_pushstring(L, (*text)->c_str());
    } else if (const auto* const* number = std::get_if<double*>(&slot)) {
        lua_pushnumber(L, **number);
    } else if (const auto& maybe = *std::get<std::optional<double>*>(slot)) {
        lua_pushnumber(L, *maybe);
    } else {
        lua_pushnil(L);
    }
    return 1;
}

// --- bodies and their sides ------------------------------------------------------------------------------------------

constexpr std::array<std::pair<const char*, Side>, 4> sides{
    {{"left", Side::left}, {"right", Side::right}, {"bottom", Side::bottom}, {"top", Side::top}}};

/// The radius of a body's elements before they are packed, of a relaxed pack or of grains the mean. A body that was not well said has the radius 1.
double element_radius(const Body& body) {
    if (const auto* close = std::get_if<ClosePacking>(&body.packing)) return close->radius > 0.0 ? close->radius : 1.0;
    if (const auto* listed = std::get_if<ListedDisks>(&body.packing)) {
        const auto& disks = listed->disks;
        const bool equal = !disks.empty() && std::all_of(disks.begin(), disks.end(), [&](const Disk& disk) {
            return disk.radius == disks.front().radius;
        });
        if (!equal) throw LuaFailure("the disks of body \"" + body.name + "\" have no radius in common");
        return disks.front().radius;
    }
    if (const auto* pressed = std::get_if<Consolidation>(&body.packing)) {
        if (pressed->radius > 0.0) return pressed->radius;
        if (pressed->count > 0 && !body.region.bounds().empty()) {
            return packing::consolidated_radius(body.region, *pressed);
        }
    }
    if (const auto* loose = std::get_if<GrainPacking>(&body.packing)) return packing::mean_radius(*loose);
    if (const auto* even = std::get_if<Relaxation>(&body.packing)) {
        const bool well_said = even->count > 0 || even->spacing > 0.0 || even->size;
        if (well_said && !body.region.bounds().empty()) return packing::relaxed_radius(body.region, *even);
    }
    return 1.0;
}

int set_velocity(lua_State* L) {
    const std::size_t row = self<BodyHandle>(L, "body:set_velocity { x, y }").row;
    Context& context = Context::of(L);
    ShiftSaid said;
    if (!read(Call(L, words::set_velocity().name()), 2, words::set_velocity(), said)) return 0;
    const Vec2 velocity{said.x, said.y};
    if (observe::Simulation* const simulation = context.simulation()) {
        Selection whole;
        whole.body = row;
        simulation->set_velocity(whole, velocity);
    } else {
        context.scene.bodies[row].velocity = velocity;
    }
    return 0;
}

std::vector<std::string> body_words() {
    std::vector<std::string> known = body_field_names();
    for (const char* name :
         {"name", "radius", "left", "right", "bottom", "top", "mean", "sum", "field", "set_velocity"}) {
        known.emplace_back(name);
    }
    return known;
}

/// mean, sum and field, which everything that can be selected has.
bool push_reader(lua_State* L, const std::string& key) {
    if (key == "mean") {
        lua_pushcfunction(L, guarded<read_mean>);
    } else if (key == "sum") {
        lua_pushcfunction(L, guarded<read_sum>);
    } else if (key == "field") {
        lua_pushcfunction(L, guarded<read_field>);
    } else {
        return false;
    }
    return true;
}

int body_index(lua_State* L) {
    const std::size_t row = test<BodyHandle>(L, 1)->row;
    const Body& body = Context::of(L).scene.bodies[row];
    const std::string key = asked_key(L);
    for (const auto& [name, side] : sides) {
        if (key != name) continue;
        push(L, SideHandle{row, side});
        return 1;
    }
    if (key == "name") {
        lua_pushstring(L, body.name.c_str());
    } else if (key == "radius") {
        lua_pushnumber(L, element_radius(body));
    } else if (key == "set_velocity") {
        lua_pushcfunction(L, guarded<set_velocity>);
    } else if (!push_reader(L, key) && !push_body_field(L, row, key)) {
        unknown_field("a body", key, body_words());
    }
    return 1;
}

int side_index(lua_State* L) {
    const std::string key = asked_key(L);
    if (!push_reader(L, key)) unknown_field("a side of a body", key, {"mean", "sum", "field"});
    return 1;
}

// --- loads and walls -------------------------------------------------------------------------------------------------

/// Reads what a load shall be from now on over what it was.
void change(lua_State* L, const LoadHandle& load, const Word& word) {
    Context& context = Context::of(L);
    Call call(L, word.name());
    call.load = load;
    call.may_lack = true;
    read_rows(call, 2, word, row_of(context.scene, load));
    context.changed.push_back(load);
}

int load_set(lua_State* L) {
    const LoadHandle load = self<LoadHandle>(L, "load:set { ... }");
    change(L, load, word_of(load.kind));
    return 0;
}

/// `set`, or a signal's setting, which reads as the value it has at this instant.
int load_index(lua_State* L) {
    const std::string key = asked_key(L);
    if (key == "set") {
        lua_pushcfunction(L, guarded<load_set>);
        return 1;
    }
    Context& context = Context::of(L);
    std::vector<std::string> known{"set"};
    for (const PresentValue& present : present_values(context, *test<LoadHandle>(L, 1))) {
        known.push_back(present.setting);
        if (present.setting != key) continue;
        context.require_run();
        present.value ? lua_pushnumber(L, *present.value) : lua_pushnil(L);
        return 1;
    }
    unknown_field("a load", key, known);
}

bool says(lua_State* L, const char* setting) {
    if (lua_type(L, 2) != LUA_TTABLE) return false;
    lua_pushstring(L, setting);
    lua_rawget(L, 2);
    const bool said = lua_toboolean(L, -1) != 0;
    lua_pop(L, 1);
    return said;
}

int wall_move(lua_State* L) {
    const std::size_t row = self<WallHandle>(L, "wall:move { ... }").row;
    Context& context = Context::of(L);
    if (says(L, "stop")) {
        forget_functions(context, {LoadKind::wall, row});
        forget_functions(context, {LoadKind::servo, row});
        Wall& wall = context.scene.walls[row];
        wall.velocity_x.reset();
        wall.velocity_y.reset();
        wall.spin.reset();
        wall.servo.reset();
    }
    change(L, {LoadKind::wall, row}, words::wall_move());
    return 0;
}

int outline_move(lua_State* L) {
    const std::size_t row = self<OutlineHandle>(L, "outline:move { ... }").row;
    Context& context = Context::of(L);
    if (says(L, "free")) {
        forget_functions(context, {LoadKind::outline, row});
        Outline& outline = context.scene.outlines[row];
        outline.given_x.reset();
        outline.given_y.reset();
        outline.given_spin.reset();
    }
    change(L, {LoadKind::outline, row}, words::outline_move());
    return 0;
}

/// `row` as Simulation::wall_motion counts.
int push_wall_answer(lua_State* L, const std::string& name, lua_CFunction move, std::size_t row) {
    const std::string key = asked_key(L);
    if (key == "name") {
        lua_pushstring(L, name.c_str());
    } else if (key == "move") {
        lua_pushcfunction(L, move);
    } else if (!push_wall_field(L, row, key)) {
        std::vector<std::string> known = wall_field_names();
        known.insert(known.end(), {"name", "move"});
        unknown_field("a wall", key, known);
    }
    return 1;
}

int wall_index(lua_State* L) {
    const std::size_t row = test<WallHandle>(L, 1)->row;
    return push_wall_answer(L, Context::of(L).scene.walls[row].name, guarded<wall_move>, row);
}

int outline_index(lua_State* L) {
    const std::size_t row = test<OutlineHandle>(L, 1)->row;
    const Scene& scene = Context::of(L).scene;
    return push_wall_answer(L, scene.outlines[row].name, guarded<outline_move>, scene.walls.size() + row);
}

// --- what is written -------------------------------------------------------------------------------------------------

/// output:set and history:set: both take the one setting that can be changed, `every`.
template <class Handle>
int interval_set(lua_State* L) {
    const std::string name = object_name<Handle>;
    const SharedInterval interval = self<Handle>(L, name + ":set { ... }").interval;
    OutputSaid said;
    const Call call(L, name);
    if (read(call, 2, words::output(), said)) interval->change(said.every, call.context.time());
    return 0;
}

template <class Handle>
int interval_index(lua_State* L) {
    const std::string key = asked_key(L);
    if (key != "set") unknown_field(object_name<Handle>, key, {"set"});
    lua_pushcfunction(L, guarded<interval_set<Handle>>);
    return 1;
}

} // namespace

void add_handles(lua_State* L) {
    define<MaterialHandle>(L, guarded<material_index>);
    define<BodyHandle>(L, guarded<body_index>);
    define<SideHandle>(L, guarded<side_index>);
    define<LoadHandle>(L, guarded<load_index>);
    define<WallHandle>(L, guarded<wall_index>);
    define<OutlineHandle>(L, guarded<outline_index>);
    define<OutputHandle>(L, guarded<interval_index<OutputHandle>>);
    define<HistoryHandle>(L, guarded<interval_index<HistoryHandle>>);
}

} // namespace demlua::scripting
