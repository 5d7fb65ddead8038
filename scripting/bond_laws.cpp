// dem.elastic, dem.plateau, ... and dem.bond_law, which gives any of them by its name.
#include "engine/model/check.hpp"
#include "engine/model/derived_law.hpp"
#include "engine/model/settings.hpp"
#include "scripting/read.hpp"
#include "scripting/sandbox.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace demlua::scripting {

using namespace model;

namespace {

template <class T, const WordOf<T>& (*word)()>
int bonds(lua_State* L) {
    T said;
    read(L, word(), said);
    push(L, BondChoice{std::move(said)});
    return 1;
}

template <class T, const WordOf<T>& (*word)()>
constexpr luaL_Reg law_word{LawOf<T>::name, guarded<bonds<T, word>>};

constexpr std::array law_words{
    law_word<ElasticBonds, words::elastic>,
    law_word<PlateauBonds, words::plateau>,
    law_word<SofteningBonds, words::softening>,
    law_word<BrittleTensileBonds, words::brittle_tensile>,
    law_word<BrittleToughnessBonds, words::brittle_toughness>,
    law_word<CohesiveBonds, words::cohesive>,
};

/// dem.bond_law "plateau" is dem.plateau.
int bond_law(lua_State* L) {
    if (lua_type(L, 1) != LUA_TSTRING) {
        throw LuaFailure("dem.bond_law takes the name of a bond law, not " + describe(L, 1));
    }
    const std::string name = lua_tostring(L, 1);
    std::vector<std::string> known;
    for (const luaL_Reg& word : law_words) {
        if (name == word.name) {
            lua_pushcfunction(L, word.func);
            return 1;
        }
        known.emplace_back(word.name);
    }
    std::string hint = did_you_mean(name, known);
    if (hint.empty()) {
        hint = "known are";
        for (const std::string& each : known) hint += (each == known.front() ? " " : ", ") + each;
    }
    throw LuaFailure("unknown bond law \"" + name + "\"; " + hint);
}

} // namespace

void add_bond_laws(lua_State* L) {
    define<BondChoice>(L, nullptr);
    for (const luaL_Reg& word : law_words) {
        lua_pushcfunction(L, word.func);
        lua_setfield(L, -2, word.name);
    }
    lua_pushcfunction(L, guarded<bond_law>);
    lua_setfield(L, -2, "bond_law");
}

} // namespace demlua::scripting
