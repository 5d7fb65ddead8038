#include "engine/model/setting.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace demlua::model {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string pair_text(Vec2 v) { return fmt::format("{{ {}, {} }}", v.x, v.y); }

std::string signal_text(const Signal& signal) {
    return signal.values.size() == 1 ? text_of(signal.values.front()) : std::string{};
}

constexpr const char* signal_words = "a number, a table of { time, value } pairs or a function of time";
constexpr const char* signal_lua = "number|number[][]|dem.signal|fun(t: number): number";
constexpr const char* region_words = "a region, such as dem.rectangle { ... }";

Kind kind(const double* /*v*/) { return {"a number", "number"}; }
Kind kind(const std::optional<double>* /*v*/) { return {"a number", "number"}; }
Kind kind(const bool* /*v*/) { return {"true or false", "boolean"}; }
Kind kind(const int* /*v*/) { return {"a whole number", "integer"}; }
Kind kind(const std::uint64_t* /*v*/) { return {"a whole number", "integer"}; }
Kind kind(const std::string* /*v*/) { return {"a text in quotes", "string"}; }
Kind kind(const Vec2* /*v*/) { return {"two numbers { x, y }", "number[]"}; }
Kind kind(const std::optional<Vec2>* /*v*/) { return {"two numbers { x, y }", "number[]"}; }
Kind kind(const std::optional<IdPair>* /*v*/) { return {"numbers of two elements { i, j }", "integer[]"}; }
Kind kind(const Signal* /*v*/) { return {signal_words, signal_lua}; }
Kind kind(const std::optional<Signal>* /*v*/) { return {signal_words, signal_lua}; }
Kind kind(const SignalPairSlot& /*v*/) { return {std::string("{ x, y }, each ") + signal_words, "table"}; }
Kind kind(const std::vector<Vec2>* /*v*/) { return {"a list of points { x, y }", "number[][]"}; }
Kind kind(const std::vector<Disk>* /*v*/) { return {"a list of disks { x, y, radius }", "table[]"}; }
Kind kind(const ListedDisks* /*v*/) {
    return {"a list of disks { x, y, radius }, or { x, y, radius, cluster }", "table[]"};
}
Kind kind(const std::vector<SizeClass>* /*v*/) {
    return {"a number, two numbers { least, greatest } or a list of { radius, share }", "number|number[]|table[]"};
}
Kind kind(const Cluster* /*v*/) { return {"a cluster made with dem.cluster", "dem.cluster_handle"}; }
Kind kind(const Region* /*v*/) { return {region_words, "dem.region"}; }
Kind kind(const WithinSlot& /*v*/) { return {region_words, "dem.region"}; }
Kind kind(const WhereSlot& /*v*/) {
    return {"a function of x and y that gives true or false", "fun(x: number, y: number): boolean"};
}
Kind kind(const Spacing* /*v*/) {
    return {"a function of x and y that gives a positive number", "fun(x: number, y: number): number"};
}
Kind kind(const PackingChoice* /*v*/) {
    return {"a packing: dem.close_packed, dem.consolidated, dem.relaxed or dem.disks", "dem.packing"};
}
Kind kind(const BondChoice* /*v*/) { return {"a bond law, such as dem.plateau {}", "dem.bonds"}; }
Kind kind(const std::optional<Servo>* /*v*/) {
    return {"a table such as { stress_y = 100e3 }", "dem.wall_servo_settings"};
}
Kind kind(const Selection* /*v*/) {
    return {"a body, a side of a body, a region, a function of place, or a table of these such as "
            "{ beam, within = region }",
            "dem.selection"};
}
Kind kind(const MaterialSlot& /*v*/) { return {"a material made with dem.material", "dem.material_handle"}; }
Kind kind(const BodySlot& /*v*/) { return {"a body made with sim:body", "dem.body"}; }
Kind kind(const OwnSlot& own) { return {own.words, own.lua}; }
Kind kind(const Callback* /*v*/) { return {"a function", "fun(now: dem.now)"}; }
Kind kind(const ChoiceSlot& choice) {
    Kind made;
    const Names& names = *choice.names;
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (k > 0) {
            made.words += k + 1 == names.size() ? " or " : ", ";
            made.lua += "|";
        }
        made.words += quoted(names[k]);
        made.lua += quoted(names[k]);
    }
    return made;
}

} // namespace

std::string Word::name() const {
    const std::size_t mark = call.find_first_of(".:");
    return mark == std::string::npos ? call : call.substr(mark + 1);
}

std::vector<std::string> Word::setting_names() const {
    std::vector<std::string> names;
    for (const Setting& setting : settings) names.push_back(setting.name);
    return names;
}

const Setting* Word::find(const std::string& setting) const {
    const auto found =
        std::find_if(settings.begin(), settings.end(), [&](const Setting& each) { return each.name == setting; });
    return found == settings.end() ? nullptr : &*found;
}

std::string text_of(double number) { return fmt::format("{}", number); }

std::string text_of(const IdPair& ids) { return fmt::format("{{ {}, {} }}", ids[0], ids[1]); }

std::string text_of(const Slot& slot) {
    return std::visit(Overloaded{
                          [](double* v) { return text_of(*v); },
                          [](std::optional<double>* v) { return *v ? text_of(**v) : std::string{}; },
                          [](bool* v) { return std::string(*v ? "true" : "false"); },
                          [](int* v) { return std::to_string(*v); },
                          [](std::uint64_t* v) { return std::to_string(*v); },
                          [](std::string* v) { return v->empty() ? std::string{} : quoted(*v); },
                          [](Vec2* v) { return pair_text(*v); },
                          [](std::optional<Vec2>* v) { return *v ? pair_text(**v) : std::string{}; },
                          [](std::optional<IdPair>* v) { return *v ? text_of(**v) : std::string{}; },
                          [](Signal* v) { return signal_text(*v); },
                          [](std::optional<Signal>* v) { return *v ? signal_text(**v) : std::string{}; },
                          [](const ChoiceSlot& v) { return quoted((*v.names)[v.get(v.value)]); },
                          [](const auto& /*others*/) { return std::string{}; },
                      },
                      slot);
}

Kind kind_of(const Slot& slot) {
    return std::visit([](const auto& each) { return kind(each); }, slot);
}

} // namespace demlua::model
