// Tables of the user's, read by the rows of the words they were given to.
#pragma once

#include "engine/model/setting.hpp"
#include "scripting/context.hpp"

#include <optional>
#include <string>

namespace demlua::scripting {

/// One call of a word.
struct Call {
    Context& context;
    lua_State* L;
    Place place;
    std::string label;                   ///< how problems call the word
    std::optional<LoadHandle> load = {}; ///< the row being read, where signals may be functions of time
    bool may_lack = false;               ///< a change: required settings need not be there

    Call(lua_State* state, std::string name)
        : context(Context::of(state)), L(state), place(user_place(state)), label(std::move(name)) {}

    void complain(const std::string& what, const std::string& value, const std::string& rule, const std::string& hint,
                  Cause cause) const;
};

/// Reads the table at `table` into `object` by the rows of `word`. What is wrong is complained of and left as it was.
/// Returns whether nothing was.
bool read_rows(const Call& call, int table, const model::Word& word, void* object);

template <class T>
bool read(const Call& call, int table, const model::WordOf<T>& word, T& object) {
    return read_rows(call, table, word, &object);
}

/// The same for the first argument of a function of dem.
template <class T>
bool read(lua_State* L, const model::WordOf<T>& word, T& object) {
    return read(Call(L, word.name()), 1, word, object);
}

/// One value on its way into a slot. `index` is absolute.
struct Value {
    const Call& call;
    const model::Setting& setting;
    std::string what; ///< `material.density`
    int index;

    void wrong_type(const model::Slot& slot) const;
    void out_of_range(const std::string& rule) const;
    /// A finite number that keeps to the setting's range.
    [[nodiscard]] std::optional<double> number(int at, const model::Slot& slot) const;
};

void read_value(const Value& value, const model::Slot& slot);

/// Each item of a list as a value of its own, called `what[k]`.
template <class Act>
void for_each_item(const Value& value, const model::Slot& slot, const Act& act) {
    lua_State* const L = value.call.L;
    if (lua_type(L, value.index) != LUA_TTABLE) {
        value.wrong_type(slot);
        return;
    }
    const auto length = static_cast<lua_Integer>(lua_rawlen(L, value.index));
    for (lua_Integer k = 1; k <= length; ++k) {
        lua_rawgeti(L, value.index, k);
        act(Value{value.call, value.setting, value.what + "[" + std::to_string(k) + "]", lua_gettop(L)});
        lua_pop(L, 1);
    }
}

// Slots that take more than a line to fill.
void read_signal(const Value& value, const model::Slot& slot, int at, int component, Signal& signal,
                 const void* target);
void read_signal_pair(const Value& value, const model::SignalPairSlot& pair);

/// Reads a selection in any of its forms, adding to what `selection` holds. `label` is how problems call it.
void read_selection(const Call& call, const std::string& what, int index, model::Selection& selection);
/// The yes-or-no function at `index` as the engine will ask it.
std::function<bool(Vec2)> place_function(const Call& call, const std::string& what, int index);
/// The function at `index` that gives a positive number, as the engine will ask it.
model::Spacing spacing_function(const Call& call, const std::string& what, int index);
/// Asks every yes-or-no function of place of the scene once, so that a wrong one is found before the run.
void try_place_functions(Context& context);

} // namespace demlua::scripting
