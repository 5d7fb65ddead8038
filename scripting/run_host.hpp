// The program's side of a running scene: assembles it, runs it, and has written what it shows.
#pragma once

#include "engine/output/run_folder.hpp"
#include "engine/output/summary.hpp"
#include "engine/output/writer.hpp"
#include "scripting/host.hpp"
#include "scripting/progress.hpp"
#include "scripting/report.hpp"
#include "scripting/terminal.hpp"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace demlua::scripting {

/// What the program knows before the scene runs.
struct RunSettings {
    output::RunFolder folder;
    std::string scene_file;
    std::string scene_text;
    std::vector<Parameter> parameters;
    int threads = 0;                                           ///< 0: as many as there are processors and work for
    double reading_time = 0.0;                                 ///< s
    std::shared_ptr<const packing::PackStore> packs = nullptr; ///< kept from run to run, or none
    std::filesystem::path progress = {};                       ///< file that tells the time reached; empty for none
    bool profile = false;                                      ///< whether to say what each stage took
};

class RunHost : public Host {
public:
    /// `interrupted` is polled while running; all references outlive the host.
    RunHost(RunSettings settings, Terminal& terminal, const std::atomic<bool>& interrupted);
    ~RunHost() override;
    RunHost(const RunHost&) = delete;
    RunHost& operator=(const RunHost&) = delete;
    RunHost(RunHost&&) = delete;
    RunHost& operator=(RunHost&&) = delete;

    /// After an interruption further runs come back at once, so that the script can end.
    observe::RunReport run(const model::Scene& scene, const RunRequest& request) override;
    void frame() override;
    observe::Simulation* simulation() override { return simulation_.get(); }
    void result(const Result& result) override;
    void compare(const model::Comparison& comparison) override { comparisons_.push_back(comparison); }
    void print(const std::string& line) override { terminal_.print(line); }

    /// Whether a run has begun, and with it the folder.
    [[nodiscard]] bool started() const { return writer_ != nullptr; }

    /// Has everything written, the summary last, and tells what came out. `failure` is why the scene ended before its
    /// time, empty when it did not. Returns how the run ended, which is a failure too when it could not be written.
    output::SummaryEnding finish(const std::string& failure);

private:
    void start(const model::Scene& scene, const RunRequest& request);
    void begin_run(const model::Scene& scene, const RunRequest& request);
    [[nodiscard]] std::vector<observe::Watcher> watchers(const RunRequest& request, Progress& progress);
    void take_frame();
    void take_row(const std::vector<HistoryRequest>& extra);
    [[nodiscard]] output::SummaryEnding ending(const std::string& failure) const;
    void tell_result(const output::SummaryEnding& ending);
    [[nodiscard]] std::string files_to_open() const;
    [[nodiscard]] output::Summary summary(const output::SummaryEnding& ending) const;

    RunSettings settings_;
    Terminal& terminal_;
    const std::atomic<bool>& interrupted_;
    std::unique_ptr<observe::Simulation> simulation_;
    std::unique_ptr<output::Writer> writer_;
    std::string inputs_;
    std::vector<Result> results_;
    std::vector<model::Comparison> comparisons_;
    observe::HistoryRow last_row_;
    bool row_for_each_frame_ = false;
    std::optional<std::uint64_t> last_row_step_;
    std::optional<std::uint64_t> last_frame_step_;
    observe::RunReport last_report_;
    Effort effort_;
    double assembly_time_ = 0.0;
};

} // namespace demlua::scripting
