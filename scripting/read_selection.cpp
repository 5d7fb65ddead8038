// Which elements: a body, a side, a region, a function of place, or a table of these.
#include "engine/model/check.hpp"
#include "scripting/read.hpp"

#include <cmath>
#include <optional>

namespace demlua::scripting {

using model::Selection;

namespace {

void wrong_part(const Call& call, const std::string& what, int index) {
    static const model::Slot slot{static_cast<Selection*>(nullptr)};
    call.complain(what, describe(call.L, index), "must be " + model::kind_of(slot).words, "", Cause::wording);
}

void take_body(const Call& call, const std::string& what, std::size_t body, Selection& selection) {
    if (selection.body && *selection.body != body) {
        call.complain(what, "", "an element cannot be of two bodies", "", Cause::wording);
        return;
    }
    selection.body = body;
}

void read_part(const Call& call, const std::string& what, int index, Selection& selection) {
    lua_State* const L = call.L;
    if (const auto* body = test<BodyHandle>(L, index)) {
        take_body(call, what, body->row, selection);
    } else if (const auto* side = test<SideHandle>(L, index)) {
        take_body(call, what, side->body, selection);
        selection.side = side->side;
    } else if (const auto* region = test<model::Region>(L, index)) {
        selection.within = selection.within ? selection.within->intersected(*region) : *region;
    } else if (lua_type(L, index) == LUA_TFUNCTION) {
        selection.where = place_function(call, what, index);
    } else {
        wrong_part(call, what, index);
    }
}

/// A named part of a mixture must be of the kind its name says.
void read_named_part(const Call& call, const std::string& what, const std::string& name, int index,
                     Selection& selection) {
    const bool region = name == "within" && test<model::Region>(call.L, index) != nullptr;
    const bool function = name == "where" && lua_type(call.L, index) == LUA_TFUNCTION;
    if (region || function) {
        read_part(call, what + "." + name, index, selection);
        return;
    }
    if (name == "within" || name == "where") {
        wrong_part(call, what + "." + name, index);
        return;
    }
    call.complain(what + "." + name, describe(call.L, index), "unknown setting",
                  model::did_you_mean(name, {"within", "where"}), Cause::wording);
}

/// Calls a function of place. `take` is given the interpreter with the answer on top, and says what it is if it is right.
template <class Take>
auto ask(const Function& function, const Place& place, const std::string& what, Vec2 point, const char* rule,
         const Take& take) {
    Interpreter& interpreter = function.push();
    lua_State* const L = interpreter.L;
    lua_pushnumber(L, point.x);
    lua_pushnumber(L, point.y);
    interpreter.call(L, 2, 1);
    const auto answer = take(L);
    const std::string given = answer ? "" : describe(L, -1);
    lua_pop(L, 1);
    if (!answer) throw SceneError(Problem{place, what, given, rule, ""});
    return *answer;
}

std::optional<bool> yes_or_no(lua_State* L) {
    if (lua_type(L, -1) != LUA_TBOOLEAN) return std::nullopt;
    return lua_toboolean(L, -1) != 0;
}

std::optional<double> positive_number(lua_State* L) {
    const double number = lua_type(L, -1) == LUA_TNUMBER ? lua_tonumber(L, -1) : 0.0;
    if (!std::isfinite(number) || number <= 0.0) return std::nullopt;
    return number;
}

} // namespace

std::function<bool(Vec2)> place_function(const Call& call, const std::string& what, int index) {
    const Function function(call.L, index);
    const Place place = call.place;
    auto asked = [function, place, what](Vec2 point) {
        return ask(function, place, what, point, "must return true or false", yes_or_no);
    };
    call.context.place_functions.emplace_back(asked);
    return asked;
}

model::Spacing spacing_function(const Call& call, const std::string& what, int index) {
    const Function function(call.L, index);
    const Place place = call.place;
    return [function, place, what](Vec2 point) {
        return ask(function, place, what, point, "must return a positive number", positive_number);
    };
}

void read_selection(const Call& call, const std::string& what, int index, Selection& selection) {
    lua_State* const L = call.L;
    if (lua_type(L, index) != LUA_TTABLE) {
        read_part(call, what, index, selection);
        return;
    }
    const auto length = static_cast<lua_Integer>(lua_rawlen(L, index));
    for (lua_Integer k = 1; k <= length; ++k) {
        lua_rawgeti(L, index, k);
        read_part(call, what + "[" + std::to_string(k) + "]", lua_gettop(L), selection);
        lua_pop(L, 1);
    }
    for (const std::string& name : string_keys(L, index)) {
        lua_pushstring(L, name.c_str());
        lua_rawget(L, index);
        read_named_part(call, what, name, lua_gettop(L), selection);
        lua_pop(L, 1);
    }
}

void try_place_functions(Context& context) {
    for (const auto& function : context.place_functions) {
        for (const model::Body& body : context.scene.bodies) {
            const Box box = body.region.bounds();
            const Vec2 middle = box.empty() ? Vec2{} : 0.5 * (box.lower + box.upper);
            if (!std::isfinite(middle.x) || !std::isfinite(middle.y)) continue;
            try {
                function(middle);
            } catch (const SceneError& error) {
                for (const Problem& problem : error.problems()) context.complain(problem, Cause::value);
                break;
            }
        }
    }
    context.place_functions.clear();
}

} // namespace demlua::scripting
