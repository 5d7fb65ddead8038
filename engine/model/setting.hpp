// A setting of the scene language declared once, as data: what reads it, checks it, explains it and completes it in an
// editor all follow from its row.
#pragma once

#include "engine/base/signal.hpp"
#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"
#include "engine/model/region.hpp"
#include "engine/model/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace demlua::model {

/// A function of the user's, kept by whoever reads the scene under `key`; 0 for none.
struct Callback {
    std::size_t key = 0;
};

using Names = std::vector<std::string>;

// Places for a value that its type alone would not tell apart.
struct MaterialSlot {
    std::size_t* row;
};
struct BodySlot {
    std::size_t* row;
};
struct WithinSlot {
    Selection* selection;
};
struct WhereSlot {
    Selection* selection;
};
/// Two signals given together as { x, y }.
struct SignalPairSlot {
    std::optional<Signal>* x;
    std::optional<Signal>* y;
};
/// One of a few names.
struct ChoiceSlot {
    void* value;
    const Names* names;
    std::size_t (*get)(const void*);
    void (*set)(void*, std::size_t);
};

/// A value of several kinds that the word reads by itself; what it may be, in words.
struct OwnSlot {
    const char* words;
    const char* lua;
};

/// Where a value goes; which alternative it is says what the value may be.
using Slot = std::variant<double*, std::optional<double>*, bool*, int*, std::uint64_t*, std::string*, Vec2*,
                          std::optional<Vec2>*, std::optional<IdPair>*, Signal*, std::optional<Signal>*, SignalPairSlot,
                          std::vector<Vec2>*, std::vector<Disk>*, ListedDisks*, std::vector<SizeClass>*, Cluster*,
                          Region*, Spacing*, PackingChoice*, BondChoice*, std::optional<Servo>*, Selection*, WithinSlot,
                          WhereSlot, MaterialSlot, BodySlot, ChoiceSlot, OwnSlot, Callback*>;

/// What a slot takes, in words for people and for lua-language-server.
struct Kind {
    std::string words; ///< "a number", "two numbers { x, y }", ...
    std::string lua;   ///< "number", "number[]", ...
};

/// What a finite number must keep to, and how that is said.
struct Range {
    const char* rule;
    bool (*holds)(double);
};

enum class Need { optional, required };

/// `position` n: the value may be given without its name as item n of the table; `whole_list`: the table's list is it.
inline constexpr int by_name_only = 0;
inline constexpr int whole_list = -1;

struct Setting {
    std::string name;
    Slot (*slot)(void* object);
    std::string unit; ///< SI, empty for pure numbers and for what is no number
    Need need;
    Range range;
    std::string meaning;
    int position = by_name_only;
    // From the struct's own initialisers, when the word is made:
    Kind kind = {};
    std::string fallback = {}; ///< the value without the setting, as text; empty where there is none
};

/// A noun or verb of the scene language: one call with one table of settings.
struct Word {
    std::string call; ///< as it is written: `dem.material`, `sim:fix`
    std::string meaning;
    std::string gives;   ///< what the call gives back, empty for nothing
    std::string others;  ///< what any key that is no setting stands for; empty: such keys are errors
    std::string example; ///< one line of Lua
    std::vector<Setting> settings;

    /// The word as problems name it: `call` without what stands before its dot or colon.
    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::vector<std::string> setting_names() const;
    [[nodiscard]] const Setting* find(const std::string& setting) const;
};

/// A word whose settings go into a T.
template <class T>
struct WordOf : Word {};

/// What stands in a slot, as a user would write it; empty when nothing stands there.
std::string text_of(const Slot& slot);
/// A number as short as it can be written without loss.
std::string text_of(double number);
std::string text_of(const IdPair& ids);
/// What a slot takes.
Kind kind_of(const Slot& slot);

} // namespace demlua::model
