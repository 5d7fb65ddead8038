// The world a scene file sees: Lua's pure libraries and `require "dem"`.
#pragma once

#include <lua.hpp>

namespace demlua::scripting {

/// Opens the libraries and the `dem` module in a fresh state.
void open_sandbox(lua_State* L);

// Parts of the module, each adding its words to the table on top of the stack, and its object types to the state.
void add_values(lua_State* L);     ///< materials, regions, packings, signals
void add_bond_laws(lua_State* L);  ///< elastic, plateau, ..., bond_law
void add_simulation(lua_State* L); ///< dem.simulation and the words said to it
void add_handles(lua_State* L);    ///< what bodies, sides, walls, loads and materials answer
void add_now(lua_State* L);        ///< readings
void add_parameters(lua_State* L); ///< param, result, compare, include
void add_study(lua_State* L);      ///< study

} // namespace demlua::scripting
