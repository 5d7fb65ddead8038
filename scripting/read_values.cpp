// One value into one slot: its type, its finiteness, its range.
#include "engine/model/settings.hpp"
#include "scripting/grains.hpp"
#include "scripting/read.hpp"
#include "scripting/signals.hpp"

#include <algorithm>
#include <cmath>

namespace demlua::scripting {

using namespace model;

std::optional<double> Value::number(int at, const Slot& slot) const {
    if (lua_type(call.L, at) != LUA_TNUMBER) {
        wrong_type(slot);
        return std::nullopt;
    }
    const double said = lua_tonumber(call.L, at);
    if (!std::isfinite(said)) {
        out_of_range("must be finite");
        return std::nullopt;
    }
    if (!setting.range.holds(said)) {
        out_of_range(setting.range.rule);
        return std::nullopt;
    }
    return said;
}

namespace {

/// Leaves the two members of a vector, { a, b } or { x = a, y = b }, on the stack. False, and nothing left, when the value
/// is no such table.
bool push_pair(lua_State* L, int index) {
    if (lua_type(L, index) != LUA_TTABLE) return false;
    const bool named = lua_rawlen(L, index) == 0;
    std::size_t keys = 0;
    for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) ++keys;
    for (int k = 1; k <= 2; ++k) {
        if (named) {
            lua_pushstring(L, k == 1 ? "x" : "y");
            lua_rawget(L, index);
        } else {
            lua_rawgeti(L, index, k);
        }
    }
    if (keys == 2 && !lua_isnil(L, -1) && !lua_isnil(L, -2)) return true;
    lua_pop(L, 2);
    return false;
}

std::optional<Vec2> vector(const Value& value, int at, const Slot& slot) {
    lua_State* const L = value.call.L;
    if (!push_pair(L, at)) {
        value.wrong_type(slot);
        return std::nullopt;
    }
    const int top = lua_gettop(L);
    const std::optional<double> x = value.number(top - 1, slot);
    const std::optional<double> y = x ? value.number(top, slot) : std::nullopt;
    lua_pop(L, 2);
    if (!x || !y) return std::nullopt;
    return Vec2{*x, *y};
}

std::optional<double> whole_number(const Value& value, const Slot& slot) {
    const std::optional<double> said = value.number(value.index, slot);
    if (said && *said != std::floor(*said)) {
        value.out_of_range("must be a whole number");
        return std::nullopt;
    }
    return said;
}

/// The types of values that are objects of their own, and the slots they go into.
template <class T>
void take_object(const Value& value, const Slot& slot, T& into) {
    if (const T* const object = test<T>(value.call.L, value.index)) {
        into = *object;
    } else {
        value.wrong_type(slot);
    }
}

template <class Handle>
void take_row(const Value& value, const Slot& slot, std::size_t& row) {
    if (const Handle* const handle = test<Handle>(value.call.L, value.index)) {
        row = handle->row;
    } else {
        value.wrong_type(slot);
    }
}

/// Fills a slot according to its kind; one overload for each.
struct Filler {
    const Value& value;
    const Slot& slot;

    [[nodiscard]] lua_State* L() const { return value.call.L; }
    [[nodiscard]] int index() const { return value.index; }

    void operator()(double* into) const {
        if (const auto said = value.number(index(), slot)) *into = *said;
    }
    void operator()(std::optional<double>* into) const {
        if (const auto said = value.number(index(), slot)) *into = *said;
    }
    void operator()(bool* into) const {
        if (lua_type(L(), index()) != LUA_TBOOLEAN) return value.wrong_type(slot);
        *into = lua_toboolean(L(), index()) != 0;
    }
    void operator()(int* into) const {
        constexpr double most = 1e9;
        const auto said = whole_number(value, slot);
        if (said && std::abs(*said) > most) return value.out_of_range("is too large");
        if (said) *into = static_cast<int>(*said);
    }
    void operator()(std::uint64_t* into) const {
        constexpr double most = 9007199254740992.0; // 2^53: beyond it a Lua float is no longer exact
        const auto said = whole_number(value, slot);
        if (said && *said > most) return value.out_of_range("is too large");
        if (said) *into = static_cast<std::uint64_t>(*said);
    }
    void operator()(std::string* into) const {
        if (lua_type(L(), index()) != LUA_TSTRING) return value.wrong_type(slot);
        *into = lua_tostring(L(), index());
        if (into->empty() && value.setting.need == Need::required) value.out_of_range("must not be empty");
    }
    void operator()(Vec2* into) const {
        if (const auto said = vector(value, index(), slot)) *into = *said;
    }
    void operator()(std::optional<Vec2>* into) const {
        if (const auto said = vector(value, index(), slot)) *into = *said;
    }
    void operator()(std::optional<IdPair>* into) const {
        const auto said = vector(value, index(), slot);
        if (!said) return;
        constexpr double most = 4294967295.0; // rows are counted in 32 bits
        for (const double id : {said->x, said->y}) {
            if (id != std::floor(id) || id < 0.0 || id > most)
                return value.out_of_range("must be whole numbers from 0 on");
        }
        *into = {static_cast<std::uint64_t>(said->x), static_cast<std::uint64_t>(said->y)};
    }
    void operator()(Signal* into) const { read_signal(value, slot, index(), 0, *into, into); }
    void operator()(std::optional<Signal>* into) const {
        if (!*into) into->emplace();
        read_signal(value, slot, index(), 0, **into, into);
    }
    void operator()(const SignalPairSlot& pair) const { read_signal_pair(value, pair); }
    void operator()(std::vector<Vec2>* into) const {
        into->clear();
        static const Slot point{static_cast<Vec2*>(nullptr)}; // items complain as points do
        for_each_item(value, slot, [&](const Value& item) {
            if (const auto said = vector(item, item.index, point)) into->push_back(*said);
        });
    }
    void operator()(std::vector<Disk>* into) const {
        into->clear();
        for_each_item(value, slot, [&](const Value& item) {
            Call call = item.call;
            call.label = item.what;
            DiskSaid said;
            if (!read(call, item.index, words::disk(), said)) return;
            if (said.cluster) call.complain(item.what, "", "is of one cluster already", "", Cause::wording);
            into->push_back({{said.x, said.y}, said.radius});
        });
    }
    void operator()(ListedDisks* into) const { read_listed(value, slot, *into); }
    void operator()(std::vector<SizeClass>* into) const { read_sizes(value, slot, *into); }
    void operator()(Cluster* into) const { take_object(value, slot, *into); }
    void operator()(Region* into) const { take_object(value, slot, *into); }
    void operator()(Spacing* into) const {
        if (lua_type(L(), index()) != LUA_TFUNCTION) return value.wrong_type(slot);
        *into = spacing_function(value.call, value.what, index());
    }
    void operator()(PackingChoice* into) const { take_object(value, slot, *into); }
    void operator()(BondChoice* into) const { take_object(value, slot, *into); }
    void operator()(std::optional<Servo>* into) const {
        Call call = value.call;
        call.label = value.what;
        call.load = LoadHandle{LoadKind::servo, value.call.load->row};
        forget_functions(call.context, *call.load);
        into->emplace();
        read(call, index(), words::servo(), **into);
    }
    void operator()(Selection* into) const { read_selection(value.call, value.what, index(), *into); }
    void operator()(const WithinSlot& within) const {
        if (test<Region>(L(), index()) == nullptr) return value.wrong_type(slot);
        read_selection(value.call, value.what, index(), *within.selection);
    }
    void operator()(const WhereSlot& where) const {
        if (lua_type(L(), index()) != LUA_TFUNCTION) return value.wrong_type(slot);
        where.selection->where = place_function(value.call, value.what, index());
    }
    void operator()(const MaterialSlot& material) const { take_row<MaterialHandle>(value, slot, *material.row); }
    void operator()(const BodySlot& body) const { take_row<BodyHandle>(value, slot, *body.row); }
    void operator()(const ChoiceSlot& choice) const {
        const std::string said = lua_type(L(), index()) == LUA_TSTRING ? lua_tostring(L(), index()) : "";
        const auto found = std::find(choice.names->begin(), choice.names->end(), said);
        if (found == choice.names->end()) return value.wrong_type(slot);
        choice.set(choice.value, static_cast<std::size_t>(found - choice.names->begin()));
    }
    void operator()(const OwnSlot& /*read by the word*/) const {}
    void operator()(Callback* into) const {
        if (lua_type(L(), index()) != LUA_TFUNCTION) return value.wrong_type(slot);
        value.call.context.functions.emplace_back(L(), index());
        into->key = value.call.context.functions.size();
    }
};

} // namespace

void read_value(const Value& value, const Slot& slot) { std::visit(Filler{value, slot}, slot); }

void read_signal_pair(const Value& value, const SignalPairSlot& pair) {
    lua_State* const L = value.call.L;
    if (!push_pair(L, value.index)) return value.wrong_type(pair);
    const int top = lua_gettop(L);
    for (int component = 0; component < 2; ++component) {
        std::optional<Signal>& signal = component == 0 ? *pair.x : *pair.y;
        if (!signal) signal.emplace();
        read_signal(value, pair, top - 1 + component, component, *signal, &signal);
    }
    lua_pop(L, 2);
}

} // namespace demlua::scripting
