#include "scripting/study_word.hpp"

#include "engine/model/check.hpp"
#include "scripting/read.hpp"
#include "scripting/sandbox.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace demlua::scripting {

using model::did_you_mean;

namespace {

constexpr double most_seeds = 1000.0;

/// Puts the setting `key` of the study's table on the stack; false, and nothing there, when it is not said.
bool push_setting(const Call& call, const char* key) {
    lua_pushstring(call.L, key);
    if (lua_rawget(call.L, 1) != LUA_TNIL) return true;
    lua_pop(call.L, 1);
    return false;
}

void refuse(const Call& call, const std::string& what, int index, const std::string& rule) {
    call.complain(what, describe(call.L, index), rule, "", Cause::wording);
}

// --- reading ---------------------------------------------------------------------------------------------------------

bool is_among(const std::vector<Plain>& values, const Plain& value) {
    return std::any_of(values.begin(), values.end(), [&](const Plain& each) { return each.value == value.value; });
}

/// The list on top of the stack, each item a value that --set could give.
std::vector<Plain> list_of_values(const Call& call, const std::string& what) {
    lua_State* const L = call.L;
    const int list = lua_gettop(L);
    std::vector<Plain> values;
    if (lua_type(L, list) != LUA_TTABLE || lua_rawlen(L, list) == 0) {
        refuse(call, what, list, "must be a list of at least one value");
        return values;
    }
    const auto length = static_cast<lua_Integer>(lua_rawlen(L, list));
    for (lua_Integer k = 1; k <= length; ++k) {
        lua_rawgeti(L, list, k);
        const std::string item = fmt::format("{}[{}]", what, k);
        const std::optional<Plain> value = plain_at(L, -1);
        if (!value || !finite(*value)) {
            refuse(call, item, -1, "must be a finite number, a text, true or false");
        } else if (is_among(values, *value)) {
            refuse(call, item, -1, "is in the list already");
        } else {
            values.push_back(*value);
        }
        lua_pop(L, 1);
    }
    return values;
}

void read_vary(const Call& call, StudyDeclaration& study) {
    if (!push_setting(call, "vary")) return;
    lua_State* const L = call.L;
    const int table = lua_gettop(L);
    const std::vector<std::string> names =
        lua_type(L, table) == LUA_TTABLE ? string_keys(L, table) : std::vector<std::string>{};
    if (names.empty()) {
        refuse(call, "study.vary", table, "must be lists of values by parameter, as in { radius = { 4e-3, 2e-3 } }");
    }
    for (const std::string& name : names) {
        lua_pushstring(L, name.c_str());
        lua_rawget(L, table);
        if (name == seed_parameter) {
            refuse(call, "study.vary.seed", -1, "seeds are given as study.seeds");
        } else {
            study.vary.push_back({name, list_of_values(call, "study.vary." + name)});
        }
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
}

bool whole(double number) { return number == std::floor(number); }

void read_seeds(const Call& call, StudyDeclaration& study) {
    if (!push_setting(call, "seeds")) return;
    lua_State* const L = call.L;
    if (lua_type(L, -1) == LUA_TNUMBER) {
        const double count = lua_tonumber(L, -1);
        if (!whole(count) || count < 1.0 || count > most_seeds) {
            refuse(call, "study.seeds", -1, fmt::format("must be a whole number from 1 to {}", most_seeds));
        } else {
            for (int k = 1; k <= static_cast<int>(count); ++k) {
                Plain& seed = study.seeds.emplace_back();
                seed.value = static_cast<double>(k);
                seed.integer = true;
            }
        }
    } else {
        study.seeds = list_of_values(call, "study.seeds");
        for (const Plain& seed : study.seeds) {
            const auto* number = std::get_if<double>(&seed.value);
            if (number != nullptr && whole(*number)) continue;
            refuse(call, "study.seeds", -1, "must be whole numbers");
            break;
        }
    }
    lua_pop(L, 1);
}

/// A number or a function of the parameters.
void read_number(const Call& call, const char* key, std::optional<double>& number, Function& function) {
    if (!push_setting(call, key)) return;
    lua_State* const L = call.L;
    if (lua_type(L, -1) == LUA_TFUNCTION) {
        function = Function(L, -1);
    } else if (lua_type(L, -1) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, -1))) {
        number = lua_tonumber(L, -1);
    } else {
        refuse(call, std::string("study.") + key, -1,
               std::string("must be ") + model::kind_of(model::words::study().find(key)->slot(nullptr)).words);
    }
    lua_pop(L, 1);
}

void read_reference(const Call& call, StudyDeclaration& study, StudyFunctions& functions) {
    if (!push_setting(call, "reference")) return;
    const bool finest = lua_type(call.L, -1) == LUA_TSTRING && std::string(lua_tostring(call.L, -1)) == "finest";
    lua_pop(call.L, 1);
    study.reference_from = finest ? ReferenceFrom::finest : ReferenceFrom::study;
    if (!finest) read_number(call, "reference", study.reference, functions.reference);
}

void read_size(const Call& call, StudyDeclaration& study, StudyFunctions& functions) {
    if (!push_setting(call, "size")) return;
    if (lua_type(call.L, -1) == LUA_TSTRING) {
        study.levels = lua_tostring(call.L, -1);
    } else if (lua_type(call.L, -1) == LUA_TFUNCTION) {
        functions.size = Function(call.L, -1);
        study.size_is_function = true;
    } else {
        refuse(call, "study.size", -1, "must be the name of a varied parameter or a function of the parameters");
    }
    lua_pop(call.L, 1);
}

int study(lua_State* L) {
    Context& context = Context::of(L);
    const Call call(L, "study");
    if (context.study) {
        call.complain("study", "", "only one to a scene", "", Cause::wording);
        return 0;
    }
    StudyDeclaration& said = context.study.emplace();
    said.place = call.place;
    read(call, 1, model::words::study(), said.said);
    if (lua_type(L, 1) != LUA_TTABLE) return 0;
    read_vary(call, said);
    read_seeds(call, said);
    read_reference(call, said, context.study_functions);
    read_number(call, "tolerance", said.tolerance, context.study_functions.tolerance);
    read_size(call, said, context.study_functions);
    return 0;
}

// --- what it says of the parameters -----------------------------------------------------------------------------------

/// The study while its end is being read.
struct Finish {
    Context& context;
    StudyDeclaration& study;

    void complain(const std::string& what, const std::string& value, const std::string& rule,
                  const std::string& hint = {}) const {
        context.complain({study.place, what, value, rule, hint}, Cause::wording);
    }
    [[nodiscard]] const Parameter* parameter(const std::string& name) const {
        const auto found = std::find_if(context.parameters.begin(), context.parameters.end(),
                                        [&](const Parameter& each) { return each.name == name; });
        return found == context.parameters.end() ? nullptr : &*found;
    }
};

std::string in_message(const Plain& plain) {
    return std::holds_alternative<std::string>(plain.value) ? '"' + text_of(plain) + '"' : text_of(plain);
}

void check_values(const Finish& finish, const std::string& what, const std::string& name,
                  const std::vector<Plain>& values) {
    const Parameter* const parameter = finish.parameter(name);
    if (parameter == nullptr) {
        std::vector<std::string> known;
        for (const Parameter& each : finish.context.parameters) known.push_back(each.name);
        const bool seeds = what == "study.seeds";
        finish.complain(what, "",
                        seeds ? "there is no parameter \"seed\" in this scene" : "no such parameter in this scene",
                        did_you_mean(name, known));
        return;
    }
    const std::string wanted = kind_of({parameter->value, false});
    for (const Plain& value : values) {
        if (value.value.index() == parameter->value.index()) continue;
        finish.complain(what, in_message(value), "must be " + wanted + ", as the parameter is");
    }
}

std::string list_of(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

/// Which parameter makes the levels.
void find_levels(const Finish& finish) {
    StudyDeclaration& study = finish.study;
    std::vector<std::string> numbers;
    for (const Varied& varied : study.vary) {
        if (std::holds_alternative<double>(varied.values.front().value)) numbers.push_back(varied.parameter);
    }
    if (study.levels.empty()) {
        if (numbers.size() == 1) study.levels = numbers.front();
        if (numbers.size() > 1) {
            finish.complain("study.size", "", "must name the one of " + list_of(numbers) + " that is the element size");
        }
    } else if (std::find(numbers.begin(), numbers.end(), study.levels) == numbers.end()) {
        const std::string near = did_you_mean(study.levels, numbers);
        finish.complain("study.size", '"' + study.levels + '"', "is no number that study.vary varies", near);
    }
}

/// What a function of the parameters gives; a number, or a problem.
std::optional<double> ask(const Finish& finish, const std::string& what, const Function& function) {
    Interpreter& interpreter = function.push();
    lua_State* const L = interpreter.L;
    lua_createtable(L, 0, 8);
    for (const Parameter& parameter : finish.context.parameters) {
        push_plain(L, {parameter.value, false});
        lua_setfield(L, -2, parameter.name.c_str());
    }
    make_strict(L, "parameter");
    try {
        interpreter.call(L, 1, 1);
    } catch (const SceneError& error) {
        for (const Problem& problem : error.problems()) finish.context.complain(problem, Cause::wording);
        return std::nullopt;
    }
    const bool number = lua_type(L, -1) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, -1));
    const double value = lua_tonumber(L, -1);
    const std::string given = describe(L, -1);
    lua_pop(L, 1);
    if (number) return value;
    finish.complain(what, given, "must give a finite number");
    return std::nullopt;
}

void find_size(const Finish& finish) {
    StudyDeclaration& study = finish.study;
    if (study.levels.empty()) return;
    const Function& function = finish.context.study_functions.size;
    study.size =
        function ? ask(finish, "study.size", function) : std::get<double>(finish.parameter(study.levels)->value);
    if (study.size && !(*study.size > 0.0)) {
        finish.complain("study.size", model::text_of(*study.size), "must be positive");
    }
}

void check_reference(const Finish& finish) {
    if (finish.study.reference_from != ReferenceFrom::result || !finish.context.read_to_end) return;
    const auto& names = finish.context.result_names;
    if (std::find(names.begin(), names.end(), "reference") != names.end()) return;
    finish.complain(
        "study.reference", "", "is missing",
        "give a number, a function of the parameters or \"finest\", or publish `reference` with dem.result");
}

} // namespace

void finish_study(Context& context) {
    if (!context.study) return;
    const Finish finish{context, *context.study};
    StudyDeclaration& study = finish.study;
    for (const Varied& varied : study.vary) {
        check_values(finish, "study.vary." + varied.parameter, varied.parameter, varied.values);
    }
    if (!study.seeds.empty()) check_values(finish, "study.seeds", seed_parameter, study.seeds);
    if (context.problems.empty()) find_levels(finish);
    if (!context.problems.empty()) return;
    const StudyFunctions& functions = context.study_functions;
    find_size(finish);
    if (functions.reference) study.reference = ask(finish, "study.reference", functions.reference);
    if (functions.tolerance) study.tolerance = ask(finish, "study.tolerance", functions.tolerance);
    check_reference(finish);
}

void add_study(lua_State* L) {
    lua_pushcfunction(L, guarded<study>);
    lua_setfield(L, -2, "study");
}

} // namespace demlua::scripting
