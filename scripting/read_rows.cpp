// Which settings a table holds: names, unknown names, missing ones, items without name.
#include "engine/model/check.hpp"
#include "scripting/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace demlua::scripting {

using model::Need;
using model::Setting;
using model::Word;

void Call::complain(const std::string& what, const std::string& value, const std::string& rule, const std::string& hint,
                    Cause cause) const {
    context.complain({place, what, value, rule, hint}, cause);
}

namespace {

std::string list_of(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// Complains of names that are no settings. Returns the settings that may have been meant.
std::set<std::string> check_names(const Call& call, int table, const Word& word) {
    std::set<std::string> meant;
    if (!word.others.empty()) return meant;
    const std::vector<std::string> known = word.setting_names();
    for (const std::string& key : string_keys(call.L, table)) {
        if (word.find(key) != nullptr) continue;
        lua_pushstring(call.L, key.c_str());
        lua_rawget(call.L, table);
        const std::string near = model::did_you_mean(key, known);
        call.complain(call.label + "." + key, describe(call.L, -1), "unknown setting",
                      near.empty() ? "known are " + list_of(known) : near, Cause::wording);
        lua_pop(call.L, 1);
        meant.insert(nearest_word(key, known));
    }
    return meant;
}

bool takes_item(const Word& word, lua_Integer item) {
    return std::any_of(word.settings.begin(), word.settings.end(), [&](const Setting& setting) {
        return setting.position == model::whole_list || setting.position == item;
    });
}

/// Items of the list part, and keys that are neither names nor items.
void check_items(const Call& call, int table, const Word& word) {
    for (lua_pushnil(call.L); lua_next(call.L, table) != 0; lua_pop(call.L, 1)) {
        if (lua_type(call.L, -2) == LUA_TSTRING) continue;
        const bool whole = lua_isinteger(call.L, -2) != 0;
        if (whole && takes_item(word, lua_tointeger(call.L, -2))) continue;
        call.complain(fmt::format("{}[{}]", call.label, describe(call.L, -2)), describe(call.L, -1),
                      "is not expected here; settings have names", "", Cause::wording);
    }
}

std::string wanted(const Setting& setting, const model::Slot& slot) {
    return model::kind_of(slot).words + (setting.unit.empty() ? "" : " in " + setting.unit);
}

/// Puts the setting's value on the stack and says how it is called there; empty when it is not in the table.
std::string find_value(const Call& call, int table, const Setting& setting) {
    lua_pushstring(call.L, setting.name.c_str());
    if (lua_rawget(call.L, table) != LUA_TNIL) return call.label + "." + setting.name;
    lua_pop(call.L, 1);
    if (setting.position == model::whole_list && lua_rawlen(call.L, table) > 0) {
        lua_pushvalue(call.L, table);
        return call.label;
    }
    if (setting.position > 0 && lua_rawgeti(call.L, table, setting.position) != LUA_TNIL) {
        return fmt::format("{}[{}]", call.label, setting.position);
    }
    if (setting.position > 0) lua_pop(call.L, 1);
    return {};
}

} // namespace

bool read_rows(const Call& call, int table, const Word& word, void* object) {
    const std::size_t before = call.context.complaints;
    if (lua_type(call.L, table) != LUA_TTABLE) {
        call.complain(call.label, lua_isnoneornil(call.L, table) ? "" : describe(call.L, table),
                      "must be given one table of settings", "as in " + word.example, Cause::wording);
        return false;
    }
    const std::set<std::string> meant = check_names(call, table, word);
    check_items(call, table, word);
    for (const Setting& setting : word.settings) {
        const model::Slot slot = setting.slot(object);
        const std::string what = find_value(call, table, setting);
        if (!what.empty()) {
            read_value({call, setting, what, lua_gettop(call.L)}, slot);
            lua_pop(call.L, 1);
        } else if (setting.need == Need::required && !call.may_lack && meant.count(setting.name) == 0) {
            call.complain(call.label + "." + setting.name, "", "is missing; it must be " + wanted(setting, slot), "",
                          Cause::value);
        }
    }
    return call.context.complaints == before;
}

void Value::wrong_type(const model::Slot& slot) const {
    std::string hint;
    if (const auto* choice = std::get_if<model::ChoiceSlot>(&slot);
        choice != nullptr && lua_type(call.L, index) == LUA_TSTRING) {
        hint = model::did_you_mean(lua_tostring(call.L, index), *choice->names);
    }
    call.complain(what, describe(call.L, index), "must be " + wanted(setting, slot), hint, Cause::wording);
}

void Value::out_of_range(const std::string& rule) const {
    call.complain(what, describe(call.L, index), rule, "", Cause::value);
}

} // namespace demlua::scripting
