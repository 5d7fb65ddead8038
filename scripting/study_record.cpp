#include "scripting/study_record.hpp"

#include "engine/model/check.hpp"
#include "engine/output/run_folder.hpp"
#include "engine/output/whole_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <system_error>
#include <vector>

namespace demlua::scripting {

namespace {

using Json = nlohmann::ordered_json;

/// Null when there is no such file, or no JSON in it.
Json json_in(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) return nullptr;
    Json json = Json::parse(stream, nullptr, false);
    return json.is_discarded() ? Json(nullptr) : json;
}

Json summary_in(const std::filesystem::path& folder) { return json_in(folder / output::names::summary); }

std::vector<std::string> names_of(const Json& results) {
    std::vector<std::string> names;
    for (const auto& entry : results.items()) names.push_back(entry.key());
    return names;
}

/// A result that the study needs as a number.
double result(const Json& results, const std::string& name, const StudyPlan& plan, const PlannedRun& planned,
              const std::string& setting, const std::string& hint) {
    const Place& place = plan.declaration.place;
    const std::string what = "study." + setting;
    const std::string value = setting == "measure" ? '"' + name + '"' : "";
    if (!results.contains(name)) {
        const std::vector<std::string> names = names_of(results);
        const std::string near = model::did_you_mean(name, names);
        const std::string there =
            names.empty() ? "the scene published none" : fmt::format("published were {}", fmt::join(names, ", "));
        const std::string rule = setting == "measure" ? "is no result of this scene" : "is missing";
        throw SceneError(Problem{place, what, value, rule, !hint.empty() ? hint : near.empty() ? there : near});
    }
    // What is not finite is null in a summary.
    if (!results[name].is_number()) {
        const std::string with = planned.run.name.empty() ? "" : "with " + planned.run.name;
        throw SceneError(Problem{place, what, value, "came out as no finite number", with});
    }
    return results[name].get<double>();
}

} // namespace

void write_record(const std::filesystem::path& folder, const PlannedRun& planned,
                  const std::optional<study::Cost>& cost, double peak_memory) {
    Json json{{"identity", planned.identity}, {"peak_memory", peak_memory}};
    if (cost) json["cost"] = {{"wall_time", cost->wall_time}, {"stepping", cost->stepping}};
    output::replace_file(folder / record_name, json.dump(2) + "\n");
}

void remove_record(const std::filesystem::path& folder) {
    std::error_code ignored;
    std::filesystem::remove(folder / record_name, ignored);
}

bool is_finished(const std::filesystem::path& folder, const PlannedRun& planned) {
    const Json record = json_in(folder / record_name);
    return record.is_object() && record.value("identity", "") == planned.identity && summary_in(folder).is_object();
}

double stepping_time(const std::filesystem::path& folder) {
    const Json summary = summary_in(folder);
    return summary.is_object() ? summary.at("timings").at("running").get<double>() : 0.0;
}

study::Run measured(const std::filesystem::path& folder, const StudyPlan& plan, const PlannedRun& planned) {
    const Json summary = summary_in(folder);
    const Json& results = summary.at("results");
    study::Run run = planned.run;
    run.value = result(results, plan.question.measure, plan, planned, "measure", "");
    if (plan.declaration.reference_from == ReferenceFrom::result) {
        run.reference = result(results, "reference", plan, planned, "reference",
                               "give a number, a function of the parameters or \"finest\", or publish `reference` with "
                               "dem.result");
    }
    run.elements = summary.at("elements").get<std::uint64_t>();
    run.steps = summary.at("steps").get<std::uint64_t>();
    return run;
}

study::Run finished_run(const std::filesystem::path& folder, const StudyPlan& plan, const PlannedRun& planned) {
    study::Run run = measured(folder, plan, planned);
    const Json record = json_in(folder / record_name);
    run.peak_memory = record.at("peak_memory").get<double>();
    if (record.contains("cost")) {
        run.cost = {record["cost"].at("wall_time").get<double>(), record["cost"].at("stepping").get<double>()};
    }
    return run;
}

} // namespace demlua::scripting
