#include "scripting/sandbox.hpp"

#include "scripting/context.hpp"

#include <array>
#include <string>

namespace demlua::scripting {

namespace {

constexpr const char* module_key = "demlua.dem";

int require_module(lua_State* L) {
    if (lua_type(L, 1) != LUA_TSTRING || std::string(lua_tostring(L, 1)) != "dem") {
        throw LuaFailure("require knows \"dem\" only, not " + describe(L, 1) +
                         "; another scene is run with dem.include \"file\" { ... }");
    }
    lua_getfield(L, LUA_REGISTRYINDEX, module_key);
    return 1;
}

/// Puts arguments together as Lua's own print does, without calling user code. Numbers and texts are what scenes print.
int print_line(lua_State* L) {
    Host* const host = Context::of(L).host;
    if (host == nullptr) return 0;
    std::string line;
    for (int k = 1; k <= lua_gettop(L); ++k) {
        if (k > 1) line += '\t';
        line += lua_type(L, k) == LUA_TSTRING ? lua_tostring(L, k) : describe(L, k);
    }
    host->print(line);
    return 0;
}

void open_library(lua_State* L, const char* name, lua_CFunction open) {
    luaL_requiref(L, name, open, 1);
    lua_pop(L, 1);
}

void forget(lua_State* L, const char* library, const char* function) {
    lua_getglobal(L, library);
    lua_pushnil(L);
    lua_setfield(L, -2, function);
    lua_pop(L, 1);
}

/// Leaves os.clock and os.time.
void open_clock(lua_State* L) {
    luaL_requiref(L, "os", luaopen_os, 0);
    lua_createtable(L, 0, 2);
    for (const char* name : {"clock", "time"}) {
        lua_getfield(L, -2, name);
        lua_setfield(L, -2, name);
    }
    lua_setglobal(L, "os");
    lua_pop(L, 1);
    luaL_getsubtable(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
    lua_pushnil(L);
    lua_setfield(L, -2, "os");
    lua_pop(L, 1);
}

/// Lua seeds its random numbers from the clock; a scene must be the same at every run.
void seed_random(lua_State* L) {
    lua_getglobal(L, "math");
    lua_getfield(L, -1, "randomseed");
    lua_pushinteger(L, 1);
    lua_call(L, 1, 0);
    lua_pop(L, 1);
}

} // namespace

void open_sandbox(lua_State* L) {
    open_library(L, LUA_GNAME, luaopen_base);
    open_library(L, LUA_MATHLIBNAME, luaopen_math);
    open_library(L, LUA_STRLIBNAME, luaopen_string);
    open_library(L, LUA_TABLIBNAME, luaopen_table);
    open_clock(L);
    seed_random(L);
    for (const char* name : {"load", "loadfile", "dofile", "collectgarbage"}) forget(L, LUA_GNAME, name);
    forget(L, LUA_STRLIBNAME, "dump");
    lua_register(L, "require", guarded<require_module>);
    lua_register(L, "print", guarded<print_line>);

    lua_createtable(L, 0, 32);
    add_values(L);
    add_bond_laws(L);
    add_simulation(L);
    add_handles(L);
    add_now(L);
    add_parameters(L);
    add_study(L);
    make_strict(L, "word of dem");
    lua_setfield(L, LUA_REGISTRYINDEX, module_key);

    // A misspelt variable would else be nil, and a setting given nil is a setting not given.
    lua_pushglobaltable(L);
    make_strict(L, "variable");
    lua_pop(L, 1);
}

} // namespace demlua::scripting
