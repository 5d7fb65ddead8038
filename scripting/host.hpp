// What a running script asks of the program around it, so that reading a scene knows nothing of files or terminals.
#pragma once

#include "engine/model/comparison.hpp"
#include "engine/model/scene.hpp"
#include "engine/observe/simulation.hpp"
#include "scripting/interval.hpp"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace demlua::scripting {

/// A declared scene parameter with the value it has in this run.
struct Parameter {
    std::string name;
    std::variant<double, bool, std::string> value;
    std::variant<double, bool, std::string> fallback; ///< the value written in the scene
    std::string unit;
    std::string help;
};

/// Extra columns of the history, read beside the standing ones.
struct HistoryRequest {
    SharedInterval interval;
    std::vector<std::pair<std::string, std::function<double(observe::Simulation&)>>> columns;
    Place place = {}; ///< of the sim:history
};

/// One call of sim:run, or of sim:solve_static.
struct RunRequest {
    double duration = 0.0;                       ///< s
    bool until_rest = false;                     ///< whether the run ends when all is at rest
    std::optional<model::StaticSolve> rest;      ///< then no time passes but that of one step
    std::optional<model::QuasiStaticRun> slowly; ///< then from rest to rest
    std::vector<SharedInterval> frames;          ///< one entry per sim:output in force
    std::vector<HistoryRequest> histories;
    std::vector<observe::Watcher> callbacks;
    Place place;
};

/// A value a scene publishes with dem.result, as number or text.
using Result = std::pair<std::string, std::variant<double, bool, std::string>>;

class Host {
public:
    Host() = default;
    virtual ~Host() = default;
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;
    Host(Host&&) = delete;
    Host& operator=(Host&&) = delete;

    /// Runs the scene as it stands; the first call assembles it. Throws SceneError or RunError.
    virtual observe::RunReport run(const model::Scene& scene, const RunRequest& request) = 0;
    /// Writes a frame of this instant, if there is none yet; only during a run.
    virtual void frame() = 0;
    /// The simulation once it has been assembled, else null.
    virtual observe::Simulation* simulation() = 0;
    virtual void result(const Result& result) = 0;
    /// A value beside what it should be, from dem.compare.
    virtual void compare(const model::Comparison& /*comparison*/) {}
    /// What the script prints.
    virtual void print(const std::string& line) = 0;
};

} // namespace demlua::scripting
