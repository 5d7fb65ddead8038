#include "engine/output/summary.hpp"

#include "engine/output/vtu.hpp"

#include "demlua/version.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <type_traits>

namespace demlua::output {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Value& value) {
    return std::visit([](const auto& held) { return Json(held); }, value);
}

Json parameters_json(const std::vector<SummaryParameter>& parameters) {
    Json json = Json::object();
    for (const auto& parameter : parameters) {
        Json& entry = json[parameter.name];
        entry["value"] = json_of(parameter.value);
        entry["fallback"] = json_of(parameter.fallback);
        if (!parameter.unit.empty()) entry["unit"] = parameter.unit;
        if (!parameter.help.empty()) entry["help"] = parameter.help;
    }
    return json;
}

template <class Pairs>
Json pairs_json(const Pairs& pairs) {
    Json json = Json::object();
    for (const auto& [name, value] : pairs) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Value>) {
            json[name] = json_of(value);
        } else {
            json[name] = value;
        }
    }
    return json;
}

Json comparisons_json(const std::vector<model::Comparison>& comparisons) {
    Json json = Json::array();
    for (const auto& each : comparisons) {
        json.push_back({{"what", each.what},
                        {"unit", each.unit},
                        {"value", each.value},
                        {"reference", each.reference},
                        {"tolerance", each.tolerance ? Json(*each.tolerance) : Json(nullptr)},
                        {"because", each.because},
                        {"source", each.source}});
    }
    return json;
}

Json versions_json() {
    return {{"demlua", version},
            {"revision", revision},
            {"compiler", compiler},
            {"build_type", build_type},
            {"vtk", vtk_version()}};
}

Json timings_json(const SummaryTimings& timings, const observe::Simulation& simulation) {
    Json json{{"reading", timings.reading},
              {"assembly", timings.assembly},
              {"running", timings.running},
              {"writing", timings.writing}};
    Json& stages = json["stages"] = Json::object();
    for (const auto& stage : simulation.stage_times()) stages[stage.stage] = stage.seconds;
    return json;
}

} // namespace

std::string summary_json(const Summary& summary, const observe::Simulation& simulation) {
    Json json;
    json["scene"] = summary.scene_file;
    json["ending"] = {{"state", summary.ending.state}, {"reason", summary.ending.reason}};
    json["time"] = simulation.time();
    json["steps"] = simulation.step();
    json["time_step"] = {{"seconds", simulation.time_step()}, {"reason", simulation.time_step_reason()}};
    json["results"] = pairs_json(summary.results);
    if (!summary.comparisons.empty()) json["comparisons"] = comparisons_json(summary.comparisons);
    json["figures"] = pairs_json(summary.figures);
    json["hash"] = fmt::format("{:016x}", simulation.hash());
    json["parameters"] = parameters_json(summary.parameters);
    json["inputs"] = Json::parse(summary.inputs);
    json["elements"] = simulation.element_count();
    json["bonds"] = simulation.bond_count();
    json["schedule"] = simulation.schedule();
    json["notes"] = simulation.notes();
    json["frames"] = summary.frames;
    json["threads"] = summary.threads;
    json["timings"] = timings_json(summary.timings, simulation);
    json["versions"] = versions_json();
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace demlua::output
