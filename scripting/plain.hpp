// Values that parameters and results can be.
#pragma once

#include "scripting/lua.hpp"

#include <optional>
#include <string>
#include <variant>

namespace demlua::scripting {

/// A number, truth or text, remembering whether Lua counts the number as an integer.
struct Plain {
    std::variant<double, bool, std::string> value;
    bool integer = false;
};

/// The value at `index` of the stack; nothing when it is of another kind.
std::optional<Plain> plain_at(lua_State* L, int index);
void push_plain(lua_State* L, const Plain& plain);

/// Whether it is no number or a finite one.
bool finite(const Plain& plain);
/// "a number", "true or false", "a text".
const char* kind_of(const Plain& plain);
/// As `--set` takes it; numbers without loss.
std::string text_of(const Plain& plain);

} // namespace demlua::scripting
