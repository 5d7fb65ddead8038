// Words that make values: materials, regions, packings, signals; those of bond laws have their own file.
#include "engine/model/check.hpp"
#include "engine/model/check_grains.hpp"
#include "engine/model/figure.hpp"
#include "engine/model/settings.hpp"
#include "scripting/read.hpp"
#include "scripting/sandbox.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace demlua::scripting {

using namespace model;

namespace {

int material(lua_State* L) {
    Context& context = Context::of(L);
    const Call call(L, words::material().name());
    Material made;
    made.place = call.place;
    if (!read(call, 1, words::material(), made)) {
        // So that a misspelt strength is complained of once, and not again by every body that needs it or finds its
        // elements too large.
        made.tensile_strength = made.tensile_strength.value_or(1.0);
        if (!made.fracture_energy) made.fracture_toughness = made.fracture_toughness.value_or(HUGE_VAL);
    }
    context.scene.materials.push_back(std::move(made));
    push(L, MaterialHandle{context.scene.materials.size() - 1});
    return 1;
}

// --- regions ---------------------------------------------------------------------------------------------------------

/// What stands in for a region that was not well said, so that reading can go on.
Region stand_in() { return Region::rectangle({0.0, 0.0}, {1.0, 1.0}); }

int rectangle(lua_State* L) {
    RectangleSaid said;
    const bool good = read(L, words::rectangle(), said);
    push(L, good ? Region::rectangle(said.at, said.size) : stand_in());
    return 1;
}

int disc(lua_State* L) {
    DiscSaid said;
    const bool good = read(L, words::disc(), said);
    push(L, good ? Region::disc(said.centre, said.radius) : stand_in());
    return 1;
}

int polygon(lua_State* L) {
    const Call call(L, words::polygon().name());
    PolygonSaid said;
    bool good = read(call, 1, words::polygon(), said);
    const std::string fault = good ? polygon_fault(said.corners) : "";
    if (!fault.empty()) {
        call.complain("polygon", "", fault, "", Cause::value);
        good = false;
    }
    push(L, good ? Region::polygon(said.corners) : stand_in());
    return 1;
}

int half_plane(lua_State* L) {
    const Call call(L, words::half_plane().name());
    HalfPlaneSaid said;
    bool good = read(call, 1, words::half_plane(), said);
    if (good && said.outward == Vec2{}) {
        call.complain("half_plane.outward", "{ 0, 0 }", "must not be zero", "", Cause::value);
        good = false;
    }
    push(L, good ? Region::half_plane(said.point, said.outward) : stand_in());
    return 1;
}

const Region& region_at(lua_State* L, int index, const char* how) {
    if (const auto* region = test<Region>(L, index)) return *region;
    throw LuaFailure(std::string(how) + ", not " + describe(L, index));
}

int region_union(lua_State* L) {
    constexpr const char* how = "a + b joins two regions";
    push(L, region_at(L, 1, how).united(region_at(L, 2, how)));
    return 1;
}

int region_difference(lua_State* L) {
    constexpr const char* how = "a - b takes a region from a region";
    push(L, region_at(L, 1, how).without(region_at(L, 2, how)));
    return 1;
}

int region_intersection(lua_State* L) {
    constexpr const char* how = "a * b is what two regions have in common";
    push(L, region_at(L, 1, how).intersected(region_at(L, 2, how)));
    return 1;
}

int region_translated(lua_State* L) {
    const Region& region = region_at(L, 1, "region:translated { x, y } is called on a region");
    ShiftSaid said;
    read(Call(L, words::translated().name()), 2, words::translated(), said);
    push(L, region.translated({said.x, said.y}));
    return 1;
}

int region_rotated(lua_State* L) {
    const Region& region = region_at(L, 1, "region:rotated { angle = ... } is called on a region");
    TurnSaid said;
    read(Call(L, words::rotated().name()), 2, words::rotated(), said);
    push(L, region.rotated(said.angle, said.about));
    return 1;
}

int region_contains(lua_State* L) {
    const Region& region = region_at(L, 1, "region:contains(x, y) is called on a region");
    if (lua_type(L, 2) != LUA_TNUMBER || lua_type(L, 3) != LUA_TNUMBER) {
        throw LuaFailure("region:contains(x, y) takes two numbers");
    }
    lua_pushboolean(L, region.contains({lua_tonumber(L, 2), lua_tonumber(L, 3)}) ? 1 : 0);
    return 1;
}

int region_area(lua_State* L) {
    lua_pushnumber(L, region_at(L, 1, "region:area() is called on a region").area());
    return 1;
}

// --- packings --------------------------------------------------------------------------------------------------------

template <class T, const WordOf<T>& (*word)()>
int packing(lua_State* L) {
    T said;
    read(L, word(), said);
    push(L, PackingChoice{std::move(said)});
    return 1;
}

int cluster(lua_State* L) {
    const Call call(L, words::cluster().name());
    Cluster said;
    if (read(call, 1, words::cluster(), said)) {
        const std::vector<Problem> problems = cluster_problems(said);
        for (const Problem& each : problems) call.complain(each.what, each.value, each.rule, each.hint, Cause::value);
        if (!problems.empty()) said = {1, {}, {}, false};
    }
    push(L, std::move(said));
    return 1;
}

// --- signals ---------------------------------------------------------------------------------------------------------

int ramp(lua_State* L) {
    RampSaid said;
    said.over = 1.0;
    read(L, words::ramp(), said);
    const double start = said.start.value_or(Context::of(L).time());
    push(L, Signal{{start, start + said.over}, {said.from, said.to}});
    return 1;
}

// --- paths -----------------------------------------------------------------------------------------------------------

int sawtooth(lua_State* L) {
    const Call call(L, words::sawtooth().name());
    SawtoothSaid said;
    bool good = read(call, 1, words::sawtooth(), said);
    if (good && said.from == said.to) {
        call.complain("sawtooth.to", "", "must differ from from", "", Cause::value);
        good = false;
    }
    const std::vector<Vec2> points =
        good ? model::sawtooth(said.from, said.to, said.height, said.pitch) : std::vector<Vec2>{{0, 0}, {1, 0}};
    lua_createtable(L, static_cast<int>(points.size()), 0);
    lua_Integer item = 0;
    for (const Vec2 point : points) {
        lua_createtable(L, 2, 0);
        lua_pushnumber(L, point.x);
        lua_rawseti(L, -2, 1);
        lua_pushnumber(L, point.y);
        lua_rawseti(L, -2, 2);
        lua_rawseti(L, -2, ++item);
    }
    return 1;
}

void add_region(lua_State* L) {
    define<Region>(L, nullptr);
    luaL_getmetatable(L, object_name<Region>);
    constexpr std::array<luaL_Reg, 4> operators{{{"__add", guarded<region_union>},
                                                 {"__sub", guarded<region_difference>},
                                                 {"__mul", guarded<region_intersection>},
                                                 {nullptr, nullptr}}};
    luaL_setfuncs(L, operators.data(), 0);
    lua_createtable(L, 0, 4);
    constexpr std::array<luaL_Reg, 5> methods{{{"translated", guarded<region_translated>},
                                               {"rotated", guarded<region_rotated>},
                                               {"contains", guarded<region_contains>},
                                               {"area", guarded<region_area>},
                                               {nullptr, nullptr}}};
    luaL_setfuncs(L, methods.data(), 0);
    make_strict(L, "method of a region");
    lua_setfield(L, -2, "__index");
    lua_pop(L, 1);
}

} // namespace

void add_values(lua_State* L) {
    add_region(L);
    define<PackingChoice>(L, nullptr);
    define<Signal>(L, nullptr);
    define<Cluster>(L, nullptr);
    constexpr std::array<luaL_Reg, 13> functions{
        {{"material", guarded<material>},
         {"rectangle", guarded<rectangle>},
         {"disc", guarded<disc>},
         {"polygon", guarded<polygon>},
         {"half_plane", guarded<half_plane>},
         {"close_packed", guarded<packing<ClosePacking, words::close_packed>>},
         {"consolidated", guarded<packing<Consolidation, words::consolidated>>},
         {"relaxed", guarded<packing<Relaxation, words::relaxed>>},
         {"disks", guarded<packing<ListedDisks, words::disks>>},
         {"cluster", guarded<cluster>},
         {"ramp", guarded<ramp>},
         {"sawtooth", guarded<sawtooth>},
         {nullptr, nullptr}}};
    luaL_setfuncs(L, functions.data(), 0);
}

} // namespace demlua::scripting
