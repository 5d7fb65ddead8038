// What a scene holds in its variables: values and handles, each of its own Lua type.
#pragma once

#include "engine/base/signal.hpp"
#include "engine/model/packings.hpp"
#include "engine/model/region.hpp"
#include "engine/model/scene.hpp"
#include "scripting/interval.hpp"
#include "scripting/lua.hpp"

#include <cstddef>
#include <new>
#include <utility>

namespace demlua::scripting {

struct MaterialHandle {
    std::size_t row = 0;
};
struct BodyHandle {
    std::size_t row = 0;
};
struct SideHandle {
    std::size_t body = 0;
    model::Side side = model::Side::left;
};
enum class LoadKind { motion, force, traction, wall, servo, outline };
/// A row of the scene whose signals may be functions of time.
struct LoadHandle {
    LoadKind kind = LoadKind::force;
    std::size_t row = 0;

    friend bool operator==(const LoadHandle&, const LoadHandle&) = default;
};
struct WallHandle {
    std::size_t row = 0;
};
struct OutlineHandle {
    std::size_t row = 0;
};
/// What is written at an interval that can be changed.
struct OutputHandle {
    SharedInterval interval;
};
struct HistoryHandle {
    SharedInterval interval;
};
struct SimulationHandle {};
/// The simulation as it stands, as callbacks see it.
struct Now {};
/// now.body and now.wall (outlines too), asked for a name.
struct BodiesNow {};
struct WallsNow {};

/// How messages call a type of object: "a " + name.
template <class T>
inline constexpr const char* object_name = nullptr;
template <>
inline constexpr const char* object_name<model::Region> = "region";
template <>
inline constexpr const char* object_name<model::PackingChoice> = "packing";
template <>
inline constexpr const char* object_name<model::Cluster> = "cluster";
template <>
inline constexpr const char* object_name<model::BondChoice> = "bond law";
template <>
inline constexpr const char* object_name<Signal> = "signal";
template <>
inline constexpr const char* object_name<MaterialHandle> = "material";
template <>
inline constexpr const char* object_name<BodyHandle> = "body";
template <>
inline constexpr const char* object_name<SideHandle> = "side of a body";
template <>
inline constexpr const char* object_name<LoadHandle> = "load";
template <>
inline constexpr const char* object_name<WallHandle> = "wall";
template <>
inline constexpr const char* object_name<OutlineHandle> = "outline";
template <>
inline constexpr const char* object_name<OutputHandle> = "output";
template <>
inline constexpr const char* object_name<HistoryHandle> = "history";
template <>
inline constexpr const char* object_name<SimulationHandle> = "simulation";
template <>
inline constexpr const char* object_name<Now> = "view of the simulation";
template <>
inline constexpr const char* object_name<BodiesNow> = "table of bodies";
template <>
inline constexpr const char* object_name<WallsNow> = "table of walls";

template <class T>
void push(lua_State* L, T value) {
    new (lua_newuserdatauv(L, sizeof(T), 0)) T(std::move(value));
    luaL_setmetatable(L, object_name<T>);
}

/// The object at `index`, or null when something else is there.
template <class T>
T* test(lua_State* L, int index) {
    return static_cast<T*>(luaL_testudata(L, index, object_name<T>));
}

template <class T>
int destroy(lua_State* L) {
    static_cast<T*>(lua_touserdata(L, 1))->~T();
    return 0;
}

/// Declares the Lua type of T. `index` answers `object.key` and may be null.
template <class T>
void define(lua_State* L, lua_CFunction index) {
    luaL_newmetatable(L, object_name<T>);
    lua_pushcfunction(L, destroy<T>);
    lua_setfield(L, -2, "__gc");
    lua_pushboolean(L, 0); // what getmetatable shows the user
    lua_setfield(L, -2, "__metatable");
    if (index != nullptr) {
        lua_pushcfunction(L, index);
        lua_setfield(L, -2, "__index");
    }
    lua_pop(L, 1);
}

} // namespace demlua::scripting
