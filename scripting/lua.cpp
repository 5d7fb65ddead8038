#include "scripting/lua.hpp"

#include "scripting/context.hpp"

#include "engine/model/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

namespace demlua::scripting {

namespace {

/// Lua raises when memory runs out, which it must not do while C++ frames would be skipped; there the program ends.
void* allocate(void* user, void* block, std::size_t /*old_size*/, std::size_t size) {
    if (size == 0) {
        std::free(block);
        return nullptr;
    }
    void* const grown = std::realloc(block, size);
    if (grown == nullptr && static_cast<Interpreter*>(user)->in_body) {
        std::fputs("demlua: out of memory\n", stderr);
        std::abort();
    }
    return grown;
}

/// The file a chunk was loaded under; Lua's own short form cuts long names.
std::string file_of(const lua_Debug& frame) { return frame.source[0] == '@' ? frame.source + 1 : frame.source; }

/// Finds the frame the message speaks of, or else the innermost one with a line, and takes its prefix off. Returns how
/// many frames of the user's there are.
int locate(lua_State* L, LuaError& error) {
    lua_Debug frame;
    bool found = false;
    int frames = 0;
    for (int level = 1; lua_getstack(L, level, &frame) == 1; ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline <= 0) continue;
        const std::string prefix = fmt::format("{}:{}: ", frame.short_src, frame.currentline);
        const bool named = !found && error.message.compare(0, prefix.size(), prefix) == 0;
        if (frames++ == 0 || named) error.place = {file_of(frame), frame.currentline};
        if (named) error.message = error.message.substr(prefix.size());
        found = found || named;
    }
    return frames;
}

/// Message handler of every protected call: runs where the error happened, before the stack is unwound.
int on_error(lua_State* L) {
    LuaError& error = Interpreter::of(L).error;
    error = {};
    error.message = lua_type(L, 1) == LUA_TSTRING ? lua_tostring(L, 1) : "error with " + describe(L, 1);
    if (locate(L, error) < 2) return 1; // a traceback would only repeat the place
    luaL_traceback(L, L, nullptr, 1);
    error.traceback = lua_tostring(L, -1);
    return 1;
}

} // namespace

Problem LuaError::problem() const { return {place, message + (traceback.empty() ? "" : "\n" + traceback), "", "", ""}; }

Interpreter::Interpreter(Context& owner) : L(lua_newstate(allocate, this)), context(&owner) {
    if (L == nullptr) throw std::bad_alloc();
    *static_cast<Interpreter**>(lua_getextraspace(L)) = this;
}

Interpreter::~Interpreter() { lua_close(L); }

Interpreter& Interpreter::of(lua_State* L) { return **static_cast<Interpreter**>(lua_getextraspace(L)); }

void Interpreter::call(lua_State* on, int arguments, int results) {
    const int handler = lua_gettop(on) - arguments;
    lua_pushcfunction(on, on_error);
    lua_insert(on, handler);
    const bool was_in_body = std::exchange(in_body, false);
    const int status = lua_pcall(on, arguments, results, handler);
    in_body = was_in_body;
    lua_remove(on, handler);
    if (status == LUA_OK) return;
    lua_pop(on, 1);
    if (status == LUA_ERRMEM) { // the one failure the handler is not called for
        error = LuaError();
        error.message = "not enough memory";
    }
    throw SceneError(error.problem());
}

void Interpreter::load(lua_State* on, const std::string& text, const std::string& file) {
    const std::string chunk = "@" + file;
    if (luaL_loadbufferx(on, text.data(), text.size(), chunk.c_str(), "t") == LUA_OK) return;
    std::string message = lua_tostring(on, -1);
    lua_pop(on, 1);
    Place place{file, 0};
    // The message reads `short name:line: what`; a text that is no Lua source at all carries no line.
    const std::size_t mark = message.find(": ");
    const std::size_t colon = mark == std::string::npos ? mark : message.rfind(':', mark - 1);
    if (colon != std::string::npos) {
        place.line = std::atoi(message.c_str() + colon + 1);
        message = message.substr(mark + 2);
    }
    throw SceneError(Problem{place, "syntax error", "", message, ""});
}

struct Function::Reference {
    std::shared_ptr<Interpreter> interpreter;
    int key;

    Reference(std::shared_ptr<Interpreter> owner, int in_registry) : interpreter(std::move(owner)), key(in_registry) {}
    ~Reference() { luaL_unref(interpreter->L, LUA_REGISTRYINDEX, key); }
    Reference(const Reference&) = delete;
    Reference& operator=(const Reference&) = delete;
    Reference(Reference&&) = delete;
    Reference& operator=(Reference&&) = delete;
};

Function::Function(lua_State* L, int index) {
    lua_pushvalue(L, index);
    const int key = luaL_ref(L, LUA_REGISTRYINDEX);
    reference_ = std::make_shared<Reference>(Interpreter::of(L).context->interpreter, key);
}

Interpreter& Function::push() const {
    Interpreter& interpreter = *reference_->interpreter;
    if (lua_checkstack(interpreter.L, 16) == 0) throw LuaFailure("too many calls within calls");
    lua_rawgeti(interpreter.L, LUA_REGISTRYINDEX, reference_->key);
    return interpreter;
}

int shielded(lua_State* L, int (*body)(lua_State*)) noexcept {
    Interpreter& interpreter = Interpreter::of(L);
    const bool was_in_body = std::exchange(interpreter.in_body, true);
    int results = -1;
    try {
        if (interpreter.context == nullptr) throw LuaFailure("the scene has been read; its words are gone");
        results = body(L);
    } catch (const LuaFailure& failure) {
        interpreter.pending = failure.what();
    } catch (const std::exception& failure) {
        // Kept whole, so that the caller of the scene meets the very exception even if the user's code hides it.
        if (!interpreter.context->fatal) interpreter.context->fatal = std::current_exception();
        interpreter.pending = failure.what();
    }
    interpreter.in_body = was_in_body;
    return results;
}

int raise_pending(lua_State* L) {
    const std::string& message = Interpreter::of(L).pending;
    luaL_where(L, 1);
    lua_pushlstring(L, message.data(), message.size());
    lua_concat(L, 2);
    return lua_error(L);
}

Place user_place(lua_State* L) {
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame) == 1; ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline > 0) return {file_of(frame), frame.currentline};
    }
    return {};
}

namespace {

std::string describe_number(lua_State* L, int index) {
    if (lua_isinteger(L, index) != 0) return std::to_string(lua_tointeger(L, index));
    const double number = lua_tonumber(L, index);
    return std::isnan(number) ? "nan" : fmt::format("{:.14g}", number);
}

/// Short lists of plain values are shown, other tables only named.
std::string describe_table(lua_State* L, int index) {
    constexpr lua_Unsigned most = 4;
    const lua_Unsigned length = lua_rawlen(L, index);
    if (length == 0 || length > most) return "a table";
    std::string text = "{ ";
    for (lua_Unsigned k = 1; k <= length; ++k) {
        lua_rawgeti(L, index, static_cast<lua_Integer>(k));
        const bool plain = lua_type(L, -1) != LUA_TTABLE;
        if (plain) text += (k > 1 ? ", " : "") + describe(L, -1);
        lua_pop(L, 1);
        if (!plain) return "a table";
    }
    return text + " }";
}

} // namespace

std::string describe(lua_State* L, int index) {
    switch (lua_type(L, index)) {
    case LUA_TNIL:
        return "nil";
    case LUA_TBOOLEAN:
        return lua_toboolean(L, index) != 0 ? "true" : "false";
    case LUA_TNUMBER:
        return describe_number(L, index);
    case LUA_TSTRING: {
        const std::string text = lua_tostring(L, index);
        return '"' + (text.size() > 40 ? text.substr(0, 37) + "..." : text) + '"';
    }
    case LUA_TTABLE:
        return describe_table(L, lua_absindex(L, index));
    case LUA_TFUNCTION:
        return "a function";
    default:
        break;
    }
    if (lua_getmetatable(L, index) == 0) return "an object";
    lua_pushliteral(L, "__name");
    lua_rawget(L, -2);
    std::string text = lua_type(L, -1) == LUA_TSTRING ? "a " + std::string(lua_tostring(L, -1)) : "an object";
    lua_pop(L, 2);
    return text;
}

std::vector<std::string> string_keys(lua_State* L, int index) {
    std::vector<std::string> keys;
    const int table = lua_absindex(L, index);
    for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
        if (lua_type(L, -2) == LUA_TSTRING) keys.emplace_back(lua_tostring(L, -2));
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

namespace {

/// __index of strict tables: (table, key), reached only for keys that are not there.
int absent_key(lua_State* L) {
    const std::string what = lua_tostring(L, lua_upvalueindex(1));
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : describe(L, 2);
    const std::string hint = model::did_you_mean(key, string_keys(L, 1));
    throw LuaFailure("unknown " + what + " \"" + key + "\"" + (hint.empty() ? "" : "; " + hint));
}

} // namespace

void make_strict(lua_State* L, const char* what) {
    lua_createtable(L, 0, 2);
    lua_pushstring(L, what);
    lua_pushcclosure(L, guarded<absent_key>, 1);
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
}

} // namespace demlua::scripting
