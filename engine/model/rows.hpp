// Builders for rows of settings: a member of a struct, with its name, unit and rules, becomes a Setting.
#pragma once

#include "engine/model/setting.hpp"

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace demlua::model::rows {

inline constexpr Range any{"", [](double /*v*/) { return true; }};
inline constexpr Range positive{"must be positive", [](double v) { return v > 0.0; }};
inline constexpr Range non_negative{"must not be negative", [](double v) { return v >= 0.0; }};
inline constexpr Range lost_share{"must be at least 0 and below 1", [](double v) { return v >= 0.0 && v < 1.0; }};
inline constexpr Range share{"must be above 0 and at most 1", [](double v) { return v > 0.0 && v <= 1.0; }};

inline constexpr Need required = Need::required;
inline constexpr Need optional = Need::optional;

/// A setting of a T, so that rows cannot stray into another struct's word.
template <class T>
struct Row {
    Setting setting;

    /// The value may also be given as item `position` of the table, or be its whole list.
    Row at(int position) && {
        setting.position = position;
        return std::move(*this);
    }
};

template <class M>
struct MemberOf;
template <class T, class M>
struct MemberOf<M T::*> {
    using Owner = T;
    using Type = M;
};
template <auto member>
using OwnerOf = typename MemberOf<decltype(member)>::Owner;
template <auto member>
using TypeOf = typename MemberOf<decltype(member)>::Type;

/// In a T, which may have inherited the member.
template <auto member, class T = OwnerOf<member>>
TypeOf<member>* address(void* object) {
    return &(static_cast<T*>(object)->*member);
}

/// A number of a T.
template <class T, auto member>
Row<T> row_of(std::string name, std::string unit, Need need, Range range, std::string meaning) {
    return {{std::move(name), [](void* object) -> Slot { return address<member, T>(object); }, std::move(unit), need,
             range, std::move(meaning), by_name_only}};
}

template <auto member>
Row<OwnerOf<member>> row(std::string name, std::string unit, Need need, Range range, std::string meaning) {
    return row_of<OwnerOf<member>, member>(std::move(name), std::move(unit), need, range, std::move(meaning));
}

/// A value that is no number, or whose type does not say what it is and needs the slot `As`.
template <auto member, class As = TypeOf<member>*>
Row<OwnerOf<member>> row(std::string name, Need need, std::string meaning) {
    return {{std::move(name),
             [](void* object) -> Slot { return As{address<member>(object)}; },
             {},
             need,
             any,
             std::move(meaning),
             by_name_only}};
}

/// Two signals under one name.
template <auto x, auto y>
Row<OwnerOf<x>> pair(std::string name, std::string unit, std::string meaning) {
    return {{std::move(name),
             [](void* object) -> Slot {
                 return SignalPairSlot{address<x>(object), address<y>(object)};
             },
             std::move(unit), optional, any, std::move(meaning), by_name_only}};
}

/// One of `names`, in the order of the enumeration (or false, true), of a T.
template <class T, auto member, const Names& (*names)()>
Row<T> choice_of(std::string name, std::string meaning) {
    using Type = TypeOf<member>;
    return {{std::move(name),
             [](void* object) -> Slot {
                 return ChoiceSlot{
                     address<member, T>(object), &names(),
                     [](const void* value) { return static_cast<std::size_t>(*static_cast<const Type*>(value)); },
                     [](void* value, std::size_t n) { *static_cast<Type*>(value) = static_cast<Type>(n); }};
             },
             {},
             optional,
             any,
             std::move(meaning),
             by_name_only}};
}

template <auto member, const Names& (*names)()>
Row<OwnerOf<member>> choice(std::string name, std::string meaning) {
    return choice_of<OwnerOf<member>, member, names>(std::move(name), std::move(meaning));
}

/// The default of a setting is what stands in its slot of a fresh struct, unless its own range forbids it: such a value
/// only says that nothing was said.
inline std::string fallback_of(const Setting& setting, const Slot& fresh) {
    if (setting.need == required) return {};
    if (const auto* number = std::get_if<double*>(&fresh)) {
        if (!std::isfinite(**number) || !setting.range.holds(**number)) return {};
    }
    if (const auto* count = std::get_if<std::uint64_t*>(&fresh)) {
        if (!setting.range.holds(static_cast<double>(**count))) return {};
    }
    return text_of(fresh);
}

template <class T>
WordOf<T> word(std::string call, std::string meaning, std::string gives, std::string example, std::vector<Row<T>> table,
               std::string others = {}) {
    WordOf<T> made;
    made.call = std::move(call);
    made.meaning = std::move(meaning);
    made.gives = std::move(gives);
    made.others = std::move(others);
    made.example = std::move(example);
    T fresh{};
    for (Row<T>& each : table) {
        const Slot slot = each.setting.slot(&fresh);
        each.setting.kind = kind_of(slot);
        each.setting.fallback = fallback_of(each.setting, slot);
        made.settings.push_back(std::move(each.setting));
    }
    return made;
}

} // namespace demlua::model::rows
