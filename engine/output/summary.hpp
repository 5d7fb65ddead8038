// What a run was and what came of it, as JSON for scripts that compare runs.
#pragma once

#include "engine/model/comparison.hpp"
#include "engine/model/scene.hpp"
#include "engine/observe/simulation.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace demlua::output {

/// A number, a yes or no, or a text: what parameters and results can be.
using Value = std::variant<double, bool, std::string>;

struct SummaryParameter {
    std::string name;
    Value value;
    Value fallback; ///< the value written in the scene
    std::string unit;
    std::string help;
};

/// How a run ended: "finished", "stopped", "interrupted" or "failed", and why.
struct SummaryEnding {
    std::string state = "finished";
    std::string reason;
};

/// Wall time, s.
struct SummaryTimings {
    double reading = 0.0;  ///< the scene file
    double assembly = 0.0; ///< packing, bonding, checks
    double running = 0.0;  ///< steps, and what looks at them
    double writing = 0.0;  ///< processor time of the thread that writes
};

struct Summary {
    std::string scene_file;
    std::string inputs; ///< from inputs_json
    SummaryEnding ending;
    int threads = 1;
    std::vector<SummaryParameter> parameters;
    std::vector<std::pair<std::string, Value>> results;
    std::vector<model::Comparison> comparisons;
    observe::HistoryRow figures; ///< the last row of the history
    std::size_t frames = 0;
    SummaryTimings timings;
};

/// What the scene says, as a JSON object: materials, bodies with their element counts, seeds. Text, so that it can be
/// kept when the scene and the functions in it are gone.
std::string inputs_json(const model::Scene& scene, const observe::Simulation& simulation);

/// The text of summary.json. Numbers that are not finite appear as null.
std::string summary_json(const Summary& summary, const observe::Simulation& simulation);

} // namespace demlua::output
