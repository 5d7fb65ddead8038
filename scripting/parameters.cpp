// dem.param, dem.result, dem.compare and dem.include: what goes into a scene and comes out of it beside the model.
#include "scripting/parameters.hpp"
#include "engine/model/check.hpp"
#include "engine/model/settings.hpp"
#include "scripting/read.hpp"
#include "scripting/sandbox.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace demlua::scripting {

using model::did_you_mean;

namespace {

/// A text from the command line as a value of the same kind as `like`, if it can be one.
std::optional<Plain> from_text(lua_State* L, const std::string& text, const Plain& like) {
    if (std::holds_alternative<std::string>(like.value)) return Plain{text, false};
    if (std::holds_alternative<bool>(like.value)) {
        if (text == "true" || text == "false") return Plain{text == "true", false};
        return std::nullopt;
    }
    if (lua_stringtonumber(L, text.c_str()) != text.size() + 1) return std::nullopt;
    const std::optional<Plain> number = plain_at(L, -1);
    lua_pop(L, 1);
    return finite(*number) ? number : std::nullopt;
}

/// What is wrong with an override; it stands in no file.
Problem wrong_override(const std::string& name, const std::string& text, const std::string& rule,
                       const std::string& hint = {}) {
    Problem problem;
    problem.what = "--set " + name;
    problem.value = text;
    problem.rule = rule;
    problem.hint = hint;
    return problem;
}

// --- dem.param -------------------------------------------------------------------------------------------------------

/// What the table of parameters says of one of them.
struct Declared {
    Plain fallback;
    std::string unit;
    std::string help;
};

std::string text_item(const Call& call, int table, const char* key, int item, const std::string& what) {
    lua_State* const L = call.L;
    lua_pushstring(L, key);
    if (lua_rawget(L, table) == LUA_TNIL && item > 0) {
        lua_pop(L, 1);
        lua_rawgeti(L, table, item);
    }
    std::string text;
    if (lua_type(L, -1) == LUA_TSTRING) {
        text = lua_tostring(L, -1);
    } else if (!lua_isnil(L, -1)) {
        call.complain(what + "." + key, describe(L, -1), "must be a text in quotes", "", Cause::wording);
    }
    lua_pop(L, 1);
    return text;
}

/// { default, unit, help = text }, or the default alone; on top of the stack.
std::optional<Declared> declaration(const Call& call, const std::string& name) {
    lua_State* const L = call.L;
    const int index = lua_gettop(L);
    const std::string what = "param." + name;
    Declared made;
    const bool table = lua_type(L, index) == LUA_TTABLE;
    if (table) {
        for (const std::string& key : string_keys(L, index)) {
            if (key == "unit" || key == "help") continue;
            call.complain(fmt::format("{}.{}", what, key), "", "unknown setting", did_you_mean(key, {"unit", "help"}),
                          Cause::wording);
        }
        made.unit = text_item(call, index, "unit", 2, what);
        made.help = text_item(call, index, "help", 0, what);
        lua_rawgeti(L, index, 1);
    } else {
        lua_pushvalue(L, index);
    }
    const std::optional<Plain> fallback = plain_at(L, -1);
    const std::string given = describe(L, -1);
    lua_pop(L, 1);
    if (!fallback || !finite(*fallback)) {
        call.complain(what, given, "must have a finite number, a text, true or false as default", "", Cause::wording);
        return std::nullopt;
    }
    made.fallback = *fallback;
    return made;
}

/// The default as an including scene wants it.
Plain included(const Call& call, const std::string& name, const Plain& fallback) {
    const auto& values = call.context.inclusions.back().values;
    const auto found = values.find(name);
    if (found == values.end()) return fallback;
    if (found->second.value.index() == fallback.value.index()) return found->second;
    call.complain("include." + name, "", std::string("must be ") + kind_of(fallback), "", Cause::wording);
    return fallback;
}

/// The value that `--set` gives, or else the default.
Plain overridden(const Call& call, const std::string& name, const Declared& declared) {
    Plain value = declared.fallback;
    for (const auto& [key, text] : call.context.overrides) {
        if (key != name) continue;
        if (const std::optional<Plain> said = from_text(call.L, text, declared.fallback)) {
            value = *said;
            continue;
        }
        const std::string unit = declared.unit.empty() ? "" : " in " + declared.unit;
        call.context.complain(wrong_override(name, text, std::string("must be ") + kind_of(declared.fallback) + unit),
                              Cause::wording);
    }
    return value;
}

int param(lua_State* L) {
    Context& context = Context::of(L);
    const Call call(L, "param");
    model::Nothing nothing;
    const bool good = read(call, 1, model::words::param(), nothing);
    lua_createtable(L, 0, 8);
    const int values = lua_gettop(L);
    const std::vector<std::string> names = good ? string_keys(L, 1) : std::vector<std::string>{};
    for (const std::string& name : names) {
        lua_pushstring(L, name.c_str());
        lua_rawget(L, 1);
        std::optional<Declared> declared = declaration(call, name);
        lua_pop(L, 1);
        if (!declared) continue;
        const bool again = std::any_of(context.parameters.begin(), context.parameters.end(),
                                       [&](const Parameter& each) { return each.name == name; });
        if (again) call.complain("param." + name, "", "is declared already", "", Cause::wording);
        declared->fallback = included(call, name, declared->fallback);
        const Plain value = overridden(call, name, *declared);
        context.parameters.push_back({name, value.value, declared->fallback.value, declared->unit, declared->help});
        push_plain(L, value);
        lua_setfield(L, values, name.c_str());
    }
    make_strict(L, "parameter");
    return 1;
}

// --- dem.result ------------------------------------------------------------------------------------------------------

int result(lua_State* L) {
    const Call call(L, "result");
    model::Nothing nothing;
    if (!read(call, 1, model::words::result(), nothing)) return 0;
    for (const std::string& name : string_keys(L, 1)) {
        call.context.result_names.push_back(name);
        lua_pushstring(L, name.c_str());
        lua_rawget(L, 1);
        const std::optional<Plain> value = plain_at(L, -1);
        if (!value) {
            call.complain("result." + name, describe(L, -1), "must be a number, a text, true or false", "",
                          Cause::value);
        } else if (call.context.simulates()) {
            call.context.host->result({name, value->value});
        }
        lua_pop(L, 1);
    }
    return 0;
}

int compare(lua_State* L) {
    model::Comparison comparison;
    const Call call(L, "compare");
    const bool good = read(call, 1, model::words::compare(), comparison);
    if (good && call.context.simulates()) call.context.host->compare(comparison);
    return 0;
}

// --- dem.include -----------------------------------------------------------------------------------------------------

std::map<std::string, Plain> values_of(const Call& call, int table) {
    std::map<std::string, Plain> values;
    if (lua_type(call.L, table) != LUA_TTABLE) {
        call.complain("include", "", "must be given one table of parameters",
                      R"(as in dem.include "file.lua" { speed = 2 })", Cause::wording);
        return values;
    }
    for (const std::string& name : string_keys(call.L, table)) {
        lua_pushstring(call.L, name.c_str());
        lua_rawget(call.L, table);
        if (const std::optional<Plain> value = plain_at(call.L, -1); value && finite(*value)) {
            values[name] = *value;
        } else {
            call.complain("include." + name, describe(call.L, -1), "must be a finite number, a text, true or false", "",
                          Cause::wording);
        }
        lua_pop(call.L, 1);
    }
    return values;
}

/// dem.include "file" gives this function, which takes the table of parameters and gives what the file returns.
int included_with(lua_State* L) {
    Context& context = Context::of(L);
    const Call call(L, "include");
    const std::string file = lua_tostring(L, lua_upvalueindex(1));
    context.open_inclusions.pop_back();
    const std::map<std::string, Plain> values = values_of(call, 1);
    const std::size_t before = context.parameters.size();
    const std::filesystem::path path = context.inclusions.back().file.parent_path() / file;
    if (!std::filesystem::exists(path)) {
        call.complain("include", '"' + file + '"', "no such file", "", Cause::wording);
        return 0;
    }
    context.run_file(path, values, 1);
    std::vector<std::string> declared;
    for (std::size_t k = before; k < context.parameters.size(); ++k) declared.push_back(context.parameters[k].name);
    for (const auto& [name, value] : values) {
        if (std::find(declared.begin(), declared.end(), name) != declared.end()) continue;
        call.complain("include." + name, "", "is not a parameter of " + file, did_you_mean(name, declared),
                      Cause::wording);
    }
    return 1;
}

int include(lua_State* L) {
    if (lua_type(L, 1) != LUA_TSTRING) throw LuaFailure("dem.include takes the name of a file, not " + describe(L, 1));
    Context::of(L).open_inclusions.push_back(user_place(L));
    lua_pushvalue(L, 1);
    lua_pushcclosure(L, guarded<included_with>, 1);
    return 1;
}

} // namespace

void complain_of_leftovers(Context& context) {
    std::vector<std::string> known;
    for (const Parameter& parameter : context.parameters) known.push_back(parameter.name);
    for (const auto& [name, text] : context.overrides) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const std::string near = did_you_mean(name, known);
        context.complain(wrong_override(name, text, "no such parameter in this scene", near), Cause::wording);
    }
    for (const Place& place : context.open_inclusions) {
        context.complain({place, "include", "", "must be given one table of parameters",
                          R"(as in dem.include "file.lua" { speed = 2 })"},
                         Cause::wording);
    }
}

void add_parameters(lua_State* L) {
    lua_pushcfunction(L, guarded<param>);
    lua_setfield(L, -2, "param");
    lua_pushcfunction(L, guarded<result>);
    lua_setfield(L, -2, "result");
    lua_pushcfunction(L, guarded<compare>);
    lua_setfield(L, -2, "compare");
    lua_pushcfunction(L, guarded<include>);
    lua_setfield(L, -2, "include");
}

} // namespace demlua::scripting
