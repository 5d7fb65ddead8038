#include "scripting/run_host.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <utility>

namespace demlua::scripting {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Adds what a run took, however it ends.
class EffortMeter {
public:
    EffortMeter(Effort& effort, const observe::Simulation& simulation)
        : effort_(effort), simulation_(simulation), first_step_(simulation.step()) {}
    ~EffortMeter() {
        effort_.steps += simulation_.step() - first_step_;
        effort_.wall_time += seconds_since(begin_);
    }
    EffortMeter(const EffortMeter&) = delete;
    EffortMeter& operator=(const EffortMeter&) = delete;
    EffortMeter(EffortMeter&&) = delete;
    EffortMeter& operator=(EffortMeter&&) = delete;

private:
    Effort& effort_;
    const observe::Simulation& simulation_;
    std::uint64_t first_step_;
    Clock::time_point begin_ = Clock::now();
};

using Intervals = std::vector<SharedInterval>;

Intervals intervals_of(const std::vector<HistoryRequest>& histories) {
    Intervals intervals;
    intervals.reserve(histories.size());
    for (const auto& history : histories) intervals.push_back(history.interval);
    return intervals;
}

/// Only functions of the scene can change something while a run goes on.
bool may_change(const RunRequest& request, const Intervals& intervals) {
    const auto has_columns = [](const HistoryRequest& history) { return !history.columns.empty(); };
    return !request.callbacks.empty() || std::any_of(request.histories.begin(), request.histories.end(), has_columns) ||
           std::any_of(intervals.begin(), intervals.end(), [](const auto& each) { return each->changed(); });
}

/// Watchers that act whenever one of the intervals comes round. Those as first said are there even when they have been
/// changed, as the time step is fitted to them.
void add_watchers(std::vector<observe::Watcher>& all, const Intervals& intervals, const RunRequest& request, double now,
                  const std::function<void()>& act) {
    std::map<double, Intervals> as_said;
    for (const auto& each : intervals) {
        each->begin(now);
        as_said[each->said()].push_back(each);
    }
    for (const auto& [every, those] : as_said) {
        all.push_back({every, [those = those, act](const observe::Simulation&) {
                           const auto as_was = [](const SharedInterval& each) { return !each->changed(); };
                           if (std::any_of(those.begin(), those.end(), as_was)) act();
                       }});
    }
    if (!may_change(request, intervals)) return;
    all.push_back({0.0, [intervals, act](const observe::Simulation& simulation) {
                       bool due = false;
                       for (const auto& each : intervals) {
                           due = each->comes_round(simulation.time(), 1e-6 * simulation.time_step()) || due;
                       }
                       if (due) act();
                   }});
}

std::vector<output::SummaryParameter> for_summary(const std::vector<Parameter>& parameters) {
    std::vector<output::SummaryParameter> rows;
    rows.reserve(parameters.size());
    for (const auto& p : parameters) rows.push_back({p.name, p.value, p.fallback, p.unit, p.help});
    return rows;
}

/// The user's columns stand beside those that every history has.
void refuse_taken_names(const observe::Simulation& simulation, const std::vector<HistoryRequest>& histories) {
    const observe::HistoryRow standing = simulation.history_row();
    std::vector<Problem> problems;
    for (const HistoryRequest& history : histories) {
        for (const auto& column : history.columns) {
            const auto same = [&](const auto& each) { return each.first == column.first; };
            if (std::none_of(standing.begin(), standing.end(), same)) continue;
            problems.push_back({history.place, "history." + column.first, "",
                                "is the name of a column that the history has anyway", "give yours another"});
        }
    }
    if (!problems.empty()) throw SceneError(std::move(problems));
}

} // namespace

RunHost::RunHost(RunSettings settings, Terminal& terminal, const std::atomic<bool>& interrupted)
    : settings_(std::move(settings)), terminal_(terminal), interrupted_(interrupted) {}

RunHost::~RunHost() { terminal_.detach(); }

observe::RunReport RunHost::run(const model::Scene& scene, const RunRequest& request) {
    if (started() && interrupted_) return {observe::Ending::interrupted, {}, 0, 0.0};
    begin_run(scene, request);
    const std::size_t told = simulation_->notes().size();
    {
        const EffortMeter meter(effort_, *simulation_);
        Progress progress(terminal_, *simulation_, request.duration);
        const std::vector<observe::Watcher> looking = watchers(request, progress);
        last_report_ = request.rest ? simulation_->solve_static(*request.rest, looking)
                       : request.slowly
                           ? simulation_->run_quasi_static(*request.slowly, looking, &interrupted_)
                           : simulation_->run(request.duration, looking, &interrupted_, request.until_rest);
    }
    // The end of a run is always shown, also one that came early.
    take_row(request.histories);
    take_frame();
    const std::vector<std::string> notes = simulation_->notes();
    for (std::size_t k = told; k < notes.size(); ++k) {
        if (request.rest || notes[k].starts_with("warning")) terminal_.say(notes[k]);
    }
    return last_report_;
}

void RunHost::begin_run(const model::Scene& scene, const RunRequest& request) {
    if (!simulation_) {
        start(scene, request);
    } else {
        simulation_->take_in(scene);
        refuse_taken_names(*simulation_, request.histories);
        inputs_ = output::inputs_json(scene, *simulation_);
    }
    if (!request.rest && !request.slowly) terminal_.say(run_outlook(*simulation_, request.duration));
}

void RunHost::start(const model::Scene& scene, const RunRequest& request) {
    const auto begin = Clock::now();
    simulation_ = std::make_unique<observe::Simulation>(scene, settings_.threads, settings_.packs.get());
    assembly_time_ = seconds_since(begin);
    refuse_taken_names(*simulation_, request.histories);
    inputs_ = output::inputs_json(scene, *simulation_);
    settings_.folder.open(settings_.scene_text);
    writer_ = std::make_unique<output::Writer>(settings_.folder);
    terminal_.attach(*writer_);
    for (const auto& line : scene_facts(scene, *simulation_)) terminal_.say(line);
    terminal_.say(fmt::format("writing to {}", settings_.folder.path().string()));
}

std::vector<observe::Watcher> RunHost::watchers(const RunRequest& request, Progress& progress) {
    // Without sim:output a run still shows its start and its end; without sim:history there is a row for each frame.
    const double now = simulation_->time();
    const Intervals at_ends{std::make_shared<Interval>(request.duration)};
    row_for_each_frame_ = request.histories.empty();
    std::vector<observe::Watcher> all;
    add_watchers(all, intervals_of(request.histories), request, now, [this, &request] { take_row(request.histories); });
    add_watchers(all, request.frames.empty() ? at_ends : request.frames, request, now, [this] { frame(); });
    if (terminal_.interactive()) all.push_back(progress.watcher());
    if (!settings_.progress.empty()) all.push_back(time_teller(settings_.progress));
    // Last, so that an instant is written as it was before the scene changes it or fails.
    all.insert(all.end(), request.callbacks.begin(), request.callbacks.end());
    return all;
}

void RunHost::frame() {
    if (row_for_each_frame_) take_row({});
    take_frame();
}

void RunHost::take_frame() {
    if (last_frame_step_ == simulation_->step()) return;
    writer_->frame(simulation_->snapshot());
    last_frame_step_ = simulation_->step();
}

void RunHost::take_row(const std::vector<HistoryRequest>& extra) {
    if (last_row_step_ == simulation_->step()) return;
    auto row = simulation_->history_row();
    for (const auto& history : extra) {
        for (const auto& [name, read] : history.columns) row.emplace_back(name, read(*simulation_));
    }
    last_row_ = row;
    writer_->history(std::move(row));
    last_row_step_ = simulation_->step();
}

void RunHost::result(const Result& result) {
    const auto same = std::find_if(results_.begin(), results_.end(),
                                   [&](const Result& earlier) { return earlier.first == result.first; });
    if (same != results_.end()) {
        same->second = result.second;
    } else {
        results_.push_back(result);
    }
}

output::SummaryEnding RunHost::finish(const std::string& failure) {
    output::SummaryEnding how = ending(failure);
    try {
        writer_->drain();
    } catch (const RunError& error) {
        how = {"failed", error.what()};
    }
    const output::Summary done = summary(how);
    tell_result(how);
    try {
        writer_->finish(output::summary_json(done, *simulation_));
    } catch (const RunError& error) {
        // One clear error: where a frame could not be written, the summary's failure says nothing new.
        if (how.state != "failed") terminal_.complain(fmt::format("demlua: {}", error.what()));
        how = {"failed", error.what()};
    }
    return how;
}

output::SummaryEnding RunHost::ending(const std::string& failure) const {
    // A script may well fail over what an interrupted run did not bring.
    if (interrupted_) return {"interrupted", "by the user"};
    if (!failure.empty()) return {"failed", failure};
    if (last_report_.ending == observe::Ending::stopped) return {"stopped", last_report_.reason};
    return {};
}

void RunHost::tell_result(const output::SummaryEnding& ending) {
    const bool failed = ending.state == "failed";
    if (failed) terminal_.complain(fmt::format("demlua: run failed: {}", ending.reason));
    const std::string reason = ending.state == "stopped" ? fmt::format(" ({})", ending.reason) : "";
    terminal_.say(fmt::format("{}{}: {}", ending.state, reason, effort_line(*simulation_, effort_)));
    // What a failed run holds in memory need not make sense; its last frame and row do.
    if (!failed) {
        terminal_.say(energy_line(simulation_->ledger()));
        for (const auto& line : {fracture_line(*simulation_), results_line(results_)}) {
            if (!line.empty()) terminal_.say(line);
        }
        if (settings_.profile) terminal_.say(profile_line(*simulation_, effort_));
        for (const auto& each : comparisons_) terminal_.say(comparison_line(each));
    }
    if (writer_->frames() > 0) terminal_.say("open it in ParaView: " + files_to_open());
}

std::string RunHost::files_to_open() const {
    std::vector<std::string> files;
    const auto add = [&](bool written, const char* name) {
        if (written) files.push_back(settings_.folder.file(name).string());
    };
    add(writer_->has_walls(), "walls.pvd");
    add(writer_->has_cracks(), "cracks.pvd");
    add(writer_->has_bonds(), "bonds.pvd");
    std::string text = settings_.folder.file("elements.pvd").string();
    for (; files.size() > 1; files.pop_back()) text += ", " + files.back();
    return files.empty() ? text : text + " and " + files.back();
}

output::Summary RunHost::summary(const output::SummaryEnding& ending) const {
    output::Summary summary;
    summary.scene_file = settings_.scene_file;
    summary.inputs = inputs_;
    summary.ending = ending;
    summary.threads = simulation_ ? simulation_->threads() : 0;
    summary.parameters = for_summary(settings_.parameters);
    summary.results = results_;
    summary.comparisons = comparisons_;
    summary.figures = last_row_;
    summary.frames = writer_->frames();
    summary.timings = {settings_.reading_time, assembly_time_, effort_.wall_time, writer_->busy_time()};
    return summary;
}

} // namespace demlua::scripting
