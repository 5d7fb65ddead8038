#include "engine/study/table.hpp"

#include <nlohmann/json.hpp>

namespace demlua::study {

namespace {

using Json = nlohmann::ordered_json;

Json number_json(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json json_of(const Run& run) {
    Json json{{"name", run.name},           {"value", run.value},       {"reference", run.reference},
              {"tolerance", run.tolerance}, {"elements", run.elements}, {"steps", run.steps}};
    if (run.cost) {
        json["wall_time"] = run.cost->wall_time;
        json["stepping"] = run.cost->stepping;
    }
    json["peak_memory"] = run.peak_memory;
    return json;
}

Json json_of(const Level& level) {
    Json json{{"name", level.name},
              {"size", level.size},
              {"elements", level.runs.front().elements},
              {"steps", level.runs.front().steps},
              {"value", level.value},
              {"scatter", number_json(level.scatter)},
              {"reference", level.reference},
              {"error", number_json(level.error)},
              {"error_scatter", number_json(level.error_scatter)},
              {"tolerance", level.runs.front().tolerance},
              {"order_of_error", number_json(level.order_of_error)},
              {"order", number_json(level.order)},
              {"extrapolated", number_json(level.extrapolated)},
              {"wall_time", number_json(level.wall_time)},
              {"seconds_per_element_step", number_json(level.cost)},
              {"peak_memory", level.peak_memory}};
    Json& runs = json["runs"] = Json::array();
    for (const Run& run : level.runs) runs.push_back(json_of(run));
    return json;
}

Json json_of(const Series& series) {
    Json json{{"name", series.name}, {"even_ratio", series.even_ratio}, {"scaled", series.scaled}};
    json["slope"] = series.slope ? Json(series.slope->exponent) : Json(nullptr);
    Json& levels = json["levels"] = Json::array();
    for (const Level& level : series.levels) levels.push_back(json_of(level));
    return json;
}

} // namespace

std::string json_of(const Study& study, const std::string& version) {
    const Question& question = study.question;
    Json json{{"scene", question.scene},   {"title", question.title},    {"measure", question.measure},
              {"unit", question.unit},     {"levels", question.levels},  {"levels_unit", question.levels_unit},
              {"source", question.source}, {"because", question.because}};
    json["expected_order"] = question.order ? Json(*question.order) : Json(nullptr);
    json["against_finest"] = question.against_finest;
    json["quick"] = question.quick;
    const std::optional<bool> within = within_tolerance(study);
    json["within_tolerance"] = within ? Json(*within) : Json(nullptr);
    json["notes"] = notes_on(study);
    Json& series = json["series"] = Json::array();
    for (const Series& each : study.series) series.push_back(json_of(each));
    json["version"] = version;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace demlua::study
