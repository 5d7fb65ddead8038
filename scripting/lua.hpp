// The Lua state of a scene and the border between Lua and C++. Lua leaves a function by longjmp, which skips
// destructors, and C++ exceptions must not pass through Lua's C frames. So each function Lua calls is `guarded`: its body
// may throw but calls nothing in Lua that raises; the frame around it holds nothing to destroy and raises for it.
#pragma once

#include "engine/base/problems.hpp"

#include <lua.hpp>

#include <memory>
#include <stdexcept>
#include <string>

namespace demlua::scripting {

struct Context;

/// Thrown in a guarded body to become a Lua error at the user's line.
class LuaFailure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Where and why Lua code failed.
struct LuaError {
    Place place;
    std::string message; ///< without the place
    std::string traceback;

    [[nodiscard]] Problem problem() const;
};

class Interpreter {
public:
    explicit Interpreter(Context& context);
    ~Interpreter();
    Interpreter(const Interpreter&) = delete;
    Interpreter& operator=(const Interpreter&) = delete;
    Interpreter(Interpreter&&) = delete;
    Interpreter& operator=(Interpreter&&) = delete;

    static Interpreter& of(lua_State* L);

    /// Calls the function below its `arguments` on the stack; both are gone afterwards. Throws SceneError.
    void call(lua_State* L, int arguments, int results);
    /// Compiles `text` as the file named `file` and leaves it on the stack. Throws SceneError.
    void load(lua_State* L, const std::string& text, const std::string& file);

    lua_State* L = nullptr;
    Context* context = nullptr; ///< null once the scene has been read
    std::string pending;        ///< message on its way from a guarded body to its frame
    LuaError error;             ///< of the latest failure
    bool in_body = false;       ///< C++ with destructors is on top of the C stack
};

/// A function of the user's, kept as long as a copy of this is.
class Function {
public:
    Function() = default;
    /// The function at `index` of the stack.
    Function(lua_State* L, int index);

    /// Puts the function on the stack of its interpreter, which is returned.
    [[nodiscard]] Interpreter& push() const;
    explicit operator bool() const { return reference_ != nullptr; }

private:
    struct Reference;
    std::shared_ptr<Reference> reference_;
};

/// Runs a body that may throw. Returns its number of results, or -1 with the message in Interpreter::pending.
int shielded(lua_State* L, int (*body)(lua_State*)) noexcept;
/// Raises Interpreter::pending as a Lua error at the user's line.
int raise_pending(lua_State* L);

template <int (*body)(lua_State*)>
int guarded(lua_State* L) {
    luaL_checkstack(L, 64, "too many values");
    const int results = shielded(L, body);
    return results >= 0 ? results : raise_pending(L);
}

/// The user's line that is running, as file (as the user typed it) and line.
Place user_place(lua_State* L);

/// A value for a message: `-5`, `"text"`, `{ 0, 1 }`, `a function`.
std::string describe(lua_State* L, int index);

/// Keys of the table at `index`, sorted, since Lua's own order changes from run to run.
std::vector<std::string> string_keys(lua_State* L, int index);

/// Makes reading an absent key of the table on top of the stack an error that suggests one of its keys; `what` says what
/// the keys are.
void make_strict(lua_State* L, const char* what);

} // namespace demlua::scripting
