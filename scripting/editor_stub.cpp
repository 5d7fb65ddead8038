// The words of the scene language as annotations for lua-language-server, from the rows of settings and readings.
#include "engine/model/settings.hpp"
#include "scripting/readings.hpp"
#include "scripting/script.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

namespace demlua::scripting {

using model::Need;
using model::Setting;
using model::Word;

namespace {

/// What stands before the dot or colon of a word: `dem`, `sim`, `region`, ...
std::string holder_of(const Word& word) { return word.call.substr(0, word.call.find_first_of(".:")); }

std::string settings_class(const Word& word) { return fmt::format("dem.{}_{}_settings", holder_of(word), word.name()); }

const std::string& class_given(const Word& word) {
    static const std::map<std::string, std::string> classes{{"", ""},
                                                            {"a simulation", "dem.sim"},
                                                            {"a material", "dem.material_handle"},
                                                            {"a region", "dem.region"},
                                                            {"a packing", "dem.packing"},
                                                            {"a bond law", "dem.bonds"},
                                                            {"a cluster", "dem.cluster_handle"},
                                                            {"a body", "dem.body"},
                                                            {"a load", "dem.load"},
                                                            {"a wall", "dem.wall"},
                                                            {"an outline", "dem.outline"},
                                                            {"a list of points", "number[][]"},
                                                            {"an output", "dem.output"},
                                                            {"a history", "dem.history"},
                                                            {"a signal", "dem.signal"}};
    static const std::string any = "table";
    const auto found = classes.find(word.gives);
    return found == classes.end() ? any : found->second;
}

std::string field(const Setting& setting) {
    const std::string unit = setting.unit.empty() ? "" : fmt::format(" ({})", setting.unit);
    if (setting.position > 0) {
        return fmt::format("---@field [{}]? {} {}{}\n---@field {}? {} {}{}\n", setting.position, setting.kind.lua,
                           setting.meaning, unit, setting.name, setting.kind.lua, setting.meaning, unit);
    }
    const bool required = setting.need == Need::required && setting.position == model::by_name_only;
    return fmt::format("---@field {}{} {} {}{}\n", setting.name, required ? "" : "?", setting.kind.lua, setting.meaning,
                       unit);
}

std::string stub_of(const Word& word) {
    std::string text = fmt::format("---@class {}\n", settings_class(word));
    for (const Setting& setting : word.settings) text += field(setting);
    if (!word.others.empty()) text += "---@field [string] any\n";
    // A table within another word's is no function.
    if (holder_of(word) != "dem" && word.call.find(':') == std::string::npos) return text + "\n";
    text += fmt::format("\n---{}\n---\n---    {}\n---@param settings {}\n", word.meaning, word.example,
                        settings_class(word));
    if (!word.gives.empty()) text += fmt::format("---@return {}\n", class_given(word));
    return text + fmt::format("function {}(settings) end\n\n", word.call);
}

template <class Source>
std::string fields(const std::vector<Reading<Source>>& readings) {
    std::string text;
    for (const auto& reading : readings) {
        constexpr std::array kinds{"number", "dem.vector", "string"}; // as the alternatives of Reading::get
        text += fmt::format("---@field {} {} {}\n", reading.name, kinds.at(reading.get.index()), reading.meaning);
    }
    return text;
}

constexpr const char* objects = R"(---@meta dem

---@class dem.vector
---@field x number
---@field y number

---@class dem.packing
---@class dem.bonds
---@class dem.cluster_handle
---@class dem.signal
---@class dem.material_handle
---@class dem.side
---@alias dem.selection dem.body|dem.side|dem.region|fun(x: number, y: number): boolean|table

---@class dem.region
---@operator add(dem.region): dem.region
---@operator sub(dem.region): dem.region
---@operator mul(dem.region): dem.region
local region = {}
---@param x number
---@param y number
---@return boolean
function region:contains(x, y) end
---@return number
function region:area() end

---@class dem.load
local load = {}
---@param settings table
function load:set(settings) end

---@class dem.output
local output = {}
---@param settings { every: number }
function output:set(settings) end

---@class dem.history
local history = {}
---@param settings { every: number }
function history:set(settings) end

)";

constexpr const char* readers = R"(---@param name string
---@return number
function body:mean(name) end
---@param name string
---@return number
function body:sum(name) end
---@param name string
---@return number[]
function body:field(name) end

---@class dem.now
---@field ledger dem.ledger
---@field momentum dem.momentum
---@field body table<string, dem.body_motion>
---@field wall table<string, dem.wall_motion>
)";

constexpr const char* now_methods = R"(local now = {}
---@param name string
---@param selection? dem.selection
---@return number
function now:mean(name, selection) end
---@param name string
---@param selection? dem.selection
---@return number
function now:sum(name, selection) end
---@param name string
---@param selection? dem.selection
---@return number[]
function now:field(name, selection) end
function now:frame() end
---@param reason string
function now:stop(reason) end

---@class dem.sim
---@field now dem.now
local sim = {}

---@class dem
local dem = {}
---@param file string
---@return fun(parameters: table): any
function dem.include(file) end
---@param law string
---@return fun(settings: table): dem.bonds
function dem.bond_law(law) end

)";

} // namespace

std::string words_as_editor_stub() {
    std::string text = objects;
    text += "---@class dem.body_motion\n" + fields(body_readings()) + "\n";
    text += "---@class dem.wall_motion\n" + fields(wall_readings()) + "\n";
    for (const char* kind : {"wall", "outline"}) {
        text += fmt::format("---@class dem.{0}: dem.wall_motion\n---@field name string\nlocal {0} = {{}}\n\n", kind);
    }
    text += "---@class dem.ledger\n" + fields(ledger_readings()) + "\n";
    text += "---@class dem.momentum\n" + fields(momentum_readings()) + "\n";
    text += "---@class dem.bond_break\n" + fields(break_readings()) + "\n";
    text += "---@class dem.body: dem.body_motion\n---@field name string\n---@field radius number\n";
    for (const char* side : {"left", "right", "bottom", "top"}) text += fmt::format("---@field {} dem.side\n", side);
    text += "local body = {}\n";
    text += readers + fields(now_readings()) + now_methods;
    for (const Word* word : model::all_words()) text += stub_of(*word);
    return text + "return dem\n";
}

} // namespace demlua::scripting
