// Scenes written for one test, read or run without writing anything.
#pragma once

#include "engine/observe/simulation.hpp"
#include "scripting/script.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <unistd.h>

namespace demlua::test {

using namespace scripting;

inline const std::filesystem::path source_folder = DEMLUA_SOURCE_DIR;

inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Tests run side by side, each in a process of its own.
inline const std::string scene_name = "scene_" + std::to_string(getpid()) + ".lua";

/// A scene written for one test, gone afterwards.
class SceneFile {
public:
    explicit SceneFile(const std::string& text) : path_(scene_name) {
        std::ofstream(path_) << "local dem = require \"dem\"\n" << text;
    }
    ~SceneFile() { std::filesystem::remove(path_); }
    SceneFile(const SceneFile&) = delete;
    SceneFile& operator=(const SceneFile&) = delete;
    SceneFile(SceneFile&&) = delete;
    SceneFile& operator=(SceneFile&&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

inline SceneSummary checked(const std::string& text, const Overrides& overrides = {}) {
    return check_scene(SceneFile(text).path(), overrides);
}

/// Runs scenes without writing anything.
class BareHost : public Host {
public:
    observe::RunReport run(const model::Scene& scene, const RunRequest& request) override {
        if (simulation_ == nullptr) {
            simulation_ = std::make_unique<observe::Simulation>(scene, 1);
        } else {
            simulation_->take_in(scene);
        }
        std::vector<observe::Watcher> watchers = request.callbacks;
        for (const HistoryRequest& history : request.histories) {
            watchers.push_back({history.interval->said(), [&](observe::Simulation& simulation) {
                                    for (const auto& [name, read] : history.columns) {
                                        columns[name].push_back(read(simulation));
                                    }
                                }});
        }
        if (request.rest) return simulation_->solve_static(*request.rest, watchers);
        return simulation_->run(request.duration, watchers);
    }
    void frame() override { ++frames; }
    observe::Simulation* simulation() override { return simulation_.get(); }
    void result(const Result& result) override { results[result.first] = result.second; }
    void print(const std::string& line) override { printed.push_back(line); }

    [[nodiscard]] double number(const std::string& name) const { return std::get<double>(results.at(name)); }

    std::map<std::string, std::variant<double, bool, std::string>> results;
    std::map<std::string, std::vector<double>> columns;
    std::vector<std::string> printed;
    std::size_t frames = 0;

private:
    std::unique_ptr<observe::Simulation> simulation_;
};

inline void run(const std::string& text, BareHost& host) { run_scene(SceneFile(text).path(), {}, host); }

/// The problems of what `work` throws, one message each.
template <class Work>
std::vector<std::string> problems_of(const Work& work) {
    std::vector<std::string> messages;
    try {
        work();
    } catch (const SceneError& error) {
        for (const Problem& problem : error.problems()) messages.push_back(problem.message());
    }
    return messages;
}

/// Lines `-->:LINE: message` of a wrong scene, with the file's name before them.
inline std::vector<std::string> expected_problems(const std::filesystem::path& file) {
    std::vector<std::string> messages;
    std::istringstream lines(text_of(file));
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("-->", 0) == 0) messages.push_back(file.string() + line.substr(3));
    }
    return messages;
}

inline const std::string rock =
    R"(local rock = dem.material { name = "rock", youngs_modulus = 1e9, poissons_ratio = 0.2, density = 2000 }
)";
/// One disk in free flight.
inline const std::string stone = rock + R"(local sim = dem.simulation { title = "stone", gravity = { 0, -10 } }
local stone = sim:body { name = "stone", material = rock, packing = dem.disks { { 0, 0, 0.1 } }, velocity = { 3, 0 } }
)";
inline const std::string block = rock + R"(local sim = dem.simulation {}
local block = sim:body { name = "block", material = rock, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 } }
)";

} // namespace demlua::test
