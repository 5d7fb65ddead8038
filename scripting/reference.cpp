// The manual of the scene language, for the terminal and as Markdown, from the rows of settings and readings.
#include "engine/model/check.hpp"
#include "engine/model/settings.hpp"
#include "engine/observe/fields.hpp"
#include "scripting/readings.hpp"
#include "scripting/script.hpp"

#include <fmt/format.h>

namespace demlua::scripting {

using model::Need;
using model::Setting;
using model::Word;

namespace {

std::string kind_words(const Setting& setting) {
    return setting.kind.words + (setting.unit.empty() ? "" : ", " + setting.unit);
}

std::string standing(const Setting& setting) {
    if (setting.need == Need::required) return "required";
    return setting.fallback.empty() ? "" : setting.fallback;
}

std::string rule_of(const Setting& setting) {
    return std::string(setting.range.rule).empty() ? "" : "; " + std::string(setting.range.rule);
}

std::string position_of(const Setting& setting) {
    if (setting.position == model::by_name_only) return {};
    if (setting.position == model::whole_list) return " (or as the table's list)";
    return fmt::format(" (or as item {})", setting.position);
}

std::vector<std::string> word_names() {
    std::vector<std::string> names;
    for (const Word* word : model::all_words()) names.push_back(word->name());
    return names;
}

std::string text_of_word(const Word& word) {
    std::string text = fmt::format("{}\n  {}\n", word.call, word.meaning);
    if (!word.gives.empty()) text += fmt::format("  Gives {}.\n", word.gives);
    for (const Setting& setting : word.settings) {
        const std::string state = setting.need == Need::required ? " [required]"
                                  : setting.fallback.empty()     ? ""
                                                                 : fmt::format(" [{}]", setting.fallback);
        text += fmt::format("\n  {}{}{}\n      {}\n      {}{}\n", setting.name, position_of(setting), state,
                            setting.meaning, kind_words(setting), rule_of(setting));
    }
    if (!word.others.empty()) text += fmt::format("\n  any other key\n      {}\n", word.others);
    return text + fmt::format("\n  {}\n", word.example);
}

std::string contents() {
    std::string text = "The words of the scene language; `demlua --help-scene WORD` tells more of one.\n\n";
    for (const Word* word : model::all_words()) text += fmt::format("  {:<20} {}\n", word->call, word->meaning);
    return text;
}

/// Bars would end a cell of a table.
std::string cell(std::string text) {
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, "\\");
    return text;
}

std::string markdown_of(const Word& word) {
    std::string text = fmt::format("### `{}`\n\n{}", word.call, word.meaning);
    if (!word.gives.empty()) text += fmt::format(" Gives {}.", word.gives);
    text += fmt::format("\n\n```lua\n{}\n```\n\n", word.example);
    if (!word.settings.empty()) text += "| setting | takes | default | meaning |\n|---|---|---|---|\n";
    for (const Setting& setting : word.settings) {
        text +=
            fmt::format("| `{}`{} | {} | {} | {}{} |\n", setting.name, position_of(setting), cell(kind_words(setting)),
                        cell(standing(setting)), cell(setting.meaning), rule_of(setting));
    }
    if (!word.settings.empty()) text += "\n";
    if (!word.others.empty()) text += fmt::format("Any other key: {}.\n\n", word.others);
    return text;
}

template <class Source>
std::string markdown_of(const std::string& heading, const std::vector<Reading<Source>>& readings) {
    std::string text = fmt::format("### {}\n\n| reading | unit | meaning |\n|---|---|---|\n", heading);
    for (const auto& reading : readings) {
        text += fmt::format("| `{}` | {} | {} |\n", reading.name, reading.unit, reading.meaning);
    }
    return text + "\n";
}

std::string markdown_of_fields() {
    std::string text =
        "### Element fields\n\nA field of several components is measured by one: `velocity_x`, `stress_yy`. "
        "Probes and columns give the sum of those marked so, the mean of the others.\n\n"
        "| field | components | unit | meaning |\n|---|---|---|---|\n";
    for (const observe::ElementField& field : observe::element_fields()) {
        const char* const combined = field.combine == observe::Combine::sum ? "; sum" : "";
        text += fmt::format("| `{}` | {} | {} | {}{} |\n", field.name, fmt::join(component_names(field), ", "),
                            field.unit, field.meaning, combined);
    }
    return text + "\n";
}

constexpr const char* preface = R"(# The scene language

Generated from the rows of settings in `engine/model/settings_*.cpp`; do not edit.

A scene is a Lua 5.4 file that reads like the experiment: each call is one noun or verb with one table of named settings,
in SI units. It begins with `local dem = require "dem"`. Lua's `math`, `string` and `table` are there, and of `os` the
functions `clock` and `time`; files, processes and other modules are not. Random numbers start from the same seed at every
run. Reading a variable that was never set is an error.

**Selections** are said in one way everywhere: a body (`beam`), a side of it (`beam.left`, `.right`, `.bottom`, `.top`), a
region, a function of place (`function(x, y) return x < 0.1 end`), or a table of these that must all agree:
`{ beam, within = region }`.

**Signals**, wherever a load is asked, are a number, a table of `{ time, value }` pairs (straight lines between them,
constant before and after), `dem.ramp { to = ..., over = ... }`, or a function of time. Functions are sampled when a run
begins, over the time it takes, to a millionth of their largest value.

**Regions** combine: `a + b` is their union, `a - b` what is left of `a`, `a * b` what they share. `region:contains(x, y)`
and `region:area()` can be asked.

**Handles**: `beam.radius` is the radius of a body's elements, known before they are packed; `concrete.density` and the like
read a material back. A load is changed by `load:set { ... }` with the settings it was made with, between runs or in a
callback, and its signals read as what they are worth at this instant: `pull.stress_y`. So is what `sim:output` and `sim:history` gave, by `frames:set { every = 1e-5 }`: the next is then due that long
after now; the time step stays as it was fitted to the interval first said. A body answers `beam:mean("stress_yy")`,
`beam:sum("force_y")`, `beam:field("speed")` and, like `now.body.beam`, its motion as a whole: `beam.velocity.y`.

**Bond laws**: `dem.bond_law "plateau"` gives `dem.plateau`, so that a parameter can choose: `dem.bond_law(p.law) { damping = 0.02 }`.

**Several runs**: lines after `sim:run` see what came of it and may add loads, supports and notches, or change them, before
the next. Bodies, walls and outlines must stand before the first run. `sim:history`, `sim:output`, `sim:every` and
`sim:on_bond_break` stay in force and add up.

**Including**: `dem.include "other.lua" { speed = 20 }` runs another scene, whose path is taken from the file's own folder,
with other defaults for its parameters, and gives what that file returns: `dem.include "handbook.lua" {}` gives formulas.

**Studies**: `dem.study` says which parameters `demlua study FILE.lua` varies, which result it measures and what that should
be. Each combination is a run of its own with its own folder below `FILE.study`. The varied number (or the one that `size`
names) makes the levels, coarse to fine, other varied parameters make series, and seeds give mean and scatter. The order p
of three levels with values f1, f2, f3 at sizes h1 > h2 > h3 solves (f1 - f2)/(f2 - f3) = (h1^p - h2^p)/(h2^p - h3^p); for a
constant ratio that is eq. 20 of Tavarez & Plesha (2007), and the value at size zero is then their eq. 38. Functions given as
`reference`, `size` or `tolerance` are asked with a table of the parameters of each run.

)";

} // namespace

std::string words_as_text(const std::string& word) {
    if (word.empty()) return contents();
    std::string text;
    for (const Word* each : model::all_words()) {
        if (each->name() == word || each->call == word) text += (text.empty() ? "" : "\n") + text_of_word(*each);
    }
    if (!text.empty()) return text;
    const std::string near = model::did_you_mean(word, word_names());
    return fmt::format("unknown word \"{}\"{}\n", word, near.empty() ? "" : "; " + near);
}

std::string words_as_markdown() {
    std::string text = preface;
    text += "## Words\n\n";
    for (const Word* word : model::all_words()) text += markdown_of(*word);
    text += "## Readings\n\n`now` is what history functions, `sim:every` and `sim:on_bond_break` are given, and "
            "`sim.now` is the "
            "same between runs. `now:mean(field, selection)`, `now:sum(field, selection)` and `now:field(name, "
            "selection)` read fields "
            "of elements; `now:frame()` writes a frame of this very instant; `now:stop(\"reason\")` ends a run.\n\n";
    text += markdown_of("`now`", now_readings());
    text += markdown_of("`now.body.NAME`", body_readings());
    text += markdown_of("`now.wall.NAME`, of outlines too", wall_readings());
    text += markdown_of("`now.momentum`", momentum_readings());
    text += markdown_of("`now.ledger`", ledger_readings());
    text += markdown_of("The event of `sim:on_bond_break`", break_readings());
    text += markdown_of_fields();
    text.pop_back();
    return text;
}

} // namespace demlua::scripting
