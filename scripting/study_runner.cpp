#include "scripting/study_runner.hpp"

#include "engine/base/problems.hpp"
#include "engine/output/run_folder.hpp"
#include "scripting/number_text.hpp"
#include "scripting/progress.hpp"
#include "scripting/study_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

namespace demlua::scripting {

namespace {

namespace fs = std::filesystem;

constexpr const char* complaints_name = "study_run.err";
constexpr const char* progress_name = "study_run.time";
constexpr std::chrono::milliseconds glance{50};

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::string text_in(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string name_of(const PlannedRun& planned) { return planned.run.name.empty() ? "the run" : planned.run.name; }

/// What a run that failed said, without the program's name before it.
std::string complaint(const fs::path& folder, int code) {
    std::string text = text_in(folder / complaints_name);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    if (code > 128)
        text += fmt::format("{}ended by signal {} ({})", text.empty() ? "" : "\n", code - 128, strsignal(code - 128));
    for (const char* prefix : {"demlua: run failed: ", "demlua: "}) {
        if (text.rfind(prefix, 0) == 0) text = text.substr(std::strlen(prefix));
    }
    return text.empty() ? fmt::format("exit code {}", code) : text;
}

/// Simulated time that the run in the folder has reached, s. 0 while it has not begun.
double time_reached(const fs::path& folder) {
    double time = 0.0;
    std::ifstream(folder / progress_name) >> time;
    return time;
}

} // namespace

StudyRunner::StudyRunner(const StudyPlan& plan, const StudySettings& settings, Terminal& terminal,
                         const std::atomic<bool>& interrupted)
    : plan_(plan), settings_(settings), terminal_(terminal), interrupted_(interrupted) {}

fs::path StudyRunner::folder_of(const PlannedRun& planned) const { return settings_.folder / planned.folder; }

StudyEnding StudyRunner::run() {
    for (std::size_t k = plan_.runs.size(); k-- > 0;) {
        if (is_finished(folder_of(plan_.runs[k]), plan_.runs[k])) {
            ++finished_;
        } else {
            waiting_.push_back(k);
        }
    }
    if (finished_ > 0) {
        terminal_.say(fmt::format("{} of {} finished earlier", finished_, counted(plan_.runs.size(), "run")));
    }
    std::vector<Lane> lanes(std::min(waiting_.size(), static_cast<std::size_t>(settings_.jobs)));
    working_ = lanes.size();
    std::vector<std::jthread> threads;
    threads.reserve(lanes.size());
    for (Lane& lane : lanes) threads.emplace_back([this, &lane] { work(lane); });
    watch(lanes);
    for (std::jthread& thread : threads) thread.join();
    tell(lanes);
    terminal_.clear_passing();
    if (interrupted_) return StudyEnding::interrupted;
    return failure_.empty() ? StudyEnding::done : StudyEnding::failed;
}

// --- in a lane's own thread ------------------------------------------------------------------------------------------

bool StudyRunner::stopping() const { return interrupted_ || !failure_.empty(); }

void StudyRunner::work(Lane& lane) {
    std::unique_lock lock(mutex_);
    while (!waiting_.empty() && !stopping()) {
        const PlannedRun& planned = plan_.runs[waiting_.back()];
        lane.run = waiting_.back();
        lane.begin = now();
        waiting_.pop_back();
        lock.unlock();
        std::string failed;
        try {
            make(lane, planned);
        } catch (const SceneError& error) {
            failed = error.what(); // names the study's own line
        } catch (const std::exception& error) {
            failed = fmt::format("{}: {}: {}", plan_.scene.string(), name_of(planned), error.what());
        }
        lock.lock();
        lane.run.reset();
        if (failed.empty()) {
            ++finished_;
            news_.push_back(fmt::format("{}: {}", name_of(planned), duration(now() - lane.begin)));
        } else if (!stopping()) {
            failure_ = failed;
        }
    }
    --working_;
}

void StudyRunner::make(Lane& lane, const PlannedRun& planned) {
    const fs::path folder = folder_of(planned);
    fs::create_directories(folder);
    remove_record(folder);
    study::Cost best;
    double peak_memory = 0.0;
    for (std::uint64_t time = 0; time < plan_.declaration.said.repeats; ++time) {
        const ChildEnd end = make_once(lane, planned);
        peak_memory = std::max(peak_memory, end.peak_memory);
        if (time == 0 || end.wall_time < best.wall_time) best = {end.wall_time, stepping_time(folder)};
    }
    measured(folder, plan_, planned);
    write_record(folder, planned, settings_.jobs == 1 ? std::optional(best) : std::nullopt, peak_memory);
}

ChildEnd StudyRunner::make_once(Lane& lane, const PlannedRun& planned) {
    const fs::path folder = folder_of(planned);
    lane.child.start(arguments_for(planned), folder / complaints_name);
    const ChildEnd end = lane.child.wait();
    if (end.code != 0) throw RunError(complaint(folder, end.code));
    if (!fs::exists(folder / output::names::summary))
        throw RunError("the scene ran nothing, so there is nothing to measure");
    std::error_code ignored;
    fs::remove(folder / progress_name, ignored);
    if (fs::file_size(folder / complaints_name, ignored) == 0) fs::remove(folder / complaints_name, ignored);
    return end;
}

std::vector<std::string> StudyRunner::arguments_for(const PlannedRun& planned) const {
    std::vector<std::string> words{plan_.scene.string(), "--quiet", "--overwrite", "-o", folder_of(planned).string()};
    for (const auto& [name, value] : planned.overrides) {
        words.emplace_back("--set");
        words.push_back(fmt::format("{}={}", name, value));
    }
    if (terminal_.interactive()) {
        words.emplace_back("--progress");
        words.push_back((folder_of(planned) / progress_name).string());
    }
    int threads = settings_.threads;
    if (threads == 0 && settings_.jobs > 1) {
        threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / settings_.jobs);
    }
    if (threads > 0) {
        words.emplace_back("--threads");
        words.push_back(std::to_string(threads));
    }
    return words;
}

// --- in the thread that talks ----------------------------------------------------------------------------------------

void StudyRunner::watch(std::vector<Lane>& lanes) {
    for (;;) {
        tell(lanes);
        {
            const std::lock_guard lock(mutex_);
            if (working_ == 0) return;
            if (stopping()) {
                for (Lane& lane : lanes) lane.child.interrupt();
            }
        }
        std::this_thread::sleep_for(glance);
    }
}

void StudyRunner::tell(std::vector<Lane>& lanes) {
    const std::lock_guard lock(mutex_);
    for (const std::string& line : news_) terminal_.say(line);
    news_.clear();
    if (!terminal_.interactive()) return;
    const auto busy = std::find_if(lanes.begin(), lanes.end(), [](const Lane& lane) { return lane.run.has_value(); });
    if (busy != lanes.end()) terminal_.show_passing(passing_line(*busy));
}

std::string StudyRunner::passing_line(const Lane& lane) const {
    const PlannedRun& planned = plan_.runs[*lane.run];
    const double wall = now() - lane.begin;
    const double reached = time_reached(folder_of(planned));
    const double share = planned.duration > 0.0 ? std::clamp(reached / planned.duration, 0.0, 1.0) : 0.0;
    const auto whole = static_cast<double>(plan_.runs.size());
    std::string figures = fmt::format(" {} of {}  {}  {:.0f} %  {}", finished_ + 1, plan_.runs.size(), name_of(planned),
                                      100.0 * share, duration(wall));
    if (share > 0.01) figures += fmt::format(", {} left of it", duration(wall * (1.0 / share - 1.0)));
    const int room = Terminal::width() - static_cast<int>(figures.size()) - 3;
    if (room < 0) return figures.substr(0, static_cast<std::size_t>(Terminal::width()) - 1);
    return fmt::format("[{}]{}", bar((static_cast<double>(finished_) + share) / whole, std::min(room, 30)), figures);
}

} // namespace demlua::scripting
