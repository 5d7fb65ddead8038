#include "scripting/study_program.hpp"

#include "demlua/version.hpp"
#include "engine/output/whole_file.hpp"
#include "engine/study/page.hpp"
#include "engine/study/table.hpp"
#include "scripting/study_plan.hpp"
#include "scripting/study_record.hpp"
#include "scripting/study_runner.hpp"

#include <fmt/format.h>

#include <system_error>

namespace demlua::scripting {

namespace {

namespace fs = std::filesystem;

void open_folder(const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed || !fs::is_directory(folder)) {
        const std::string reason = failed ? "cannot be made: " + failed.message() : "is not a folder";
        throw SceneError(Problem{Place(), "output folder", folder.string(), reason, ""});
    }
}

study::Study collected(const StudyPlan& plan, const fs::path& folder) {
    std::vector<study::Run> runs;
    for (const PlannedRun& each : plan.runs) runs.push_back(finished_run(folder / each.folder, plan, each));
    return study::study_of(plan.question, runs);
}

void write_files(const study::Study& study, const fs::path& folder) {
    const std::string made_by = fmt::format("demlua {} ({}, {}, {})", version, revision, compiler, build_type);
    output::replace_file(folder / "study.csv", study::csv_of(study));
    output::replace_file(folder / "study.json", study::json_of(study, made_by));
    output::replace_file(folder / "study.html", study::page_of(study, made_by));
    output::replace_file(folder / "error_size.svg", study::error_size_svg(study));
    output::replace_file(folder / "error_time.svg", study::error_time_svg(study));
}

void tell(const study::Study& study, const fs::path& folder, Terminal& terminal) {
    for (const auto& line : study::lines_of(study::table_of(study))) terminal.say(line);
    for (const auto& note : study::notes_on(study)) terminal.say(note);
    terminal.say("open it in a browser: " + (folder / "study.html").string());
}

} // namespace

StudyEnding run_study(const StudyLine& line, Terminal& terminal, const std::atomic<bool>& interrupted) {
    const StudyPlan plan = plan_study(line.scene, line.overrides, line.quick);
    open_folder(line.folder);
    if (line.fresh) {
        for (const PlannedRun& each : plan.runs) remove_record(line.folder / each.folder);
    }
    const StudySettings settings{line.folder, line.jobs, line.threads};
    StudyRunner runner(plan, settings, terminal, interrupted);
    const StudyEnding ending = runner.run();
    if (ending == StudyEnding::failed) terminal.complain(runner.failure());
    if (ending == StudyEnding::interrupted) {
        terminal.complain(fmt::format("interrupted: {} of {} runs are finished; the same command goes on from there",
                                      runner.finished(), plan.runs.size()));
    }
    if (ending != StudyEnding::done) return ending;
    const study::Study study = collected(plan, line.folder);
    write_files(study, line.folder);
    tell(study, line.folder, terminal);
    return ending;
}

} // namespace demlua::scripting
