#include "scripting/plain.hpp"

#include <fmt/format.h>

#include <cmath>

namespace demlua::scripting {

std::optional<Plain> plain_at(lua_State* L, int index) {
    switch (lua_type(L, index)) {
    case LUA_TNUMBER:
        return Plain{lua_tonumber(L, index), lua_isinteger(L, index) != 0};
    case LUA_TBOOLEAN:
        return Plain{lua_toboolean(L, index) != 0, false};
    case LUA_TSTRING:
        return Plain{std::string(lua_tostring(L, index)), false};
    default:
        return std::nullopt;
    }
}

void push_plain(lua_State* L, const Plain& plain) {
    if (const auto* number = std::get_if<double>(&plain.value)) {
        plain.integer ? lua_pushinteger(L, static_cast<lua_Integer>(*number)) : lua_pushnumber(L, *number);
    } else if (const auto* truth = std::get_if<bool>(&plain.value)) {
        lua_pushboolean(L, *truth ? 1 : 0);
    } else {
        lua_pushstring(L, std::get<std::string>(plain.value).c_str());
    }
}

bool finite(const Plain& plain) {
    const auto* number = std::get_if<double>(&plain.value);
    return number == nullptr || std::isfinite(*number);
}

const char* kind_of(const Plain& plain) {
    constexpr const char* kinds[] = {"a number", "true or false", "a text"};
    return kinds[plain.value.index()];
}

std::string text_of(const Plain& plain) {
    if (const auto* number = std::get_if<double>(&plain.value)) return fmt::format("{}", *number);
    if (const auto* truth = std::get_if<bool>(&plain.value)) return *truth ? "true" : "false";
    return std::get<std::string>(plain.value);
}

} // namespace demlua::scripting
