// Shared answers of handles and of `now`.
#pragma once

#include "engine/observe/bond_breaks.hpp"
#include "scripting/context.hpp"

#include <cstddef>
#include <string>

namespace demlua::scripting {

/// The key asked for in an __index function, as text.
std::string asked_key(lua_State* L);
/// Throws the LuaFailure of an unknown field, suggesting one of `known`.
[[noreturn]] void unknown_field(const std::string& of, const std::string& key, const std::vector<std::string>& known);

/// Motion of a body as a strict table; or one field of it, when there is such a field (else pushes nothing).
void push_body_motion(lua_State* L, std::size_t body);
bool push_body_field(lua_State* L, std::size_t body, const std::string& field);
std::vector<std::string> body_field_names();

/// What a function of sim:on_bond_break is told, as a strict table.
void push_bond_break(lua_State* L, const observe::BondBreak& event);

/// The same of a wall; outlines come after the walls.
void push_wall_motion(lua_State* L, std::size_t wall);
bool push_wall_field(lua_State* L, std::size_t wall, const std::string& field);
std::vector<std::string> wall_field_names();

void push_vector(lua_State* L, Vec2 vector);

/// object:mean(field), object:sum(field), object:field(field) of a body or side; now:mean(field, selection), ...
int read_mean(lua_State* L);
int read_sum(lua_State* L);
int read_field(lua_State* L);

} // namespace demlua::scripting
