#include "scripting/program.hpp"

#include "scripting/command_line.hpp"
#include "scripting/kept_packs.hpp"
#include "scripting/run_host.hpp"
#include "scripting/study_program.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace demlua::scripting {

namespace {

constexpr int exit_done = 0;
constexpr int exit_wrong_input = 2;
constexpr int exit_failed = 3;
constexpr int exit_interrupted = 130;

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

/// The first signal asks the run to end; a second one ends the program as usual.
void listen_to_signals() {
    struct sigaction action = {};
    action.sa_handler = [](int) { interrupted = true; };
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

int complain(Terminal& terminal, const std::vector<Problem>& problems) {
    for (const auto& problem : problems) terminal.complain(problem.message());
    return exit_wrong_input;
}

/// Adds the problems that `work` throws to `problems`.
template <class Work>
auto collecting(std::vector<Problem>& problems, const Work& work) -> std::optional<decltype(work())> {
    try {
        return work();
    } catch (const SceneError& error) {
        problems.insert(problems.end(), error.problems().begin(), error.problems().end());
        return std::nullopt;
    }
}

std::string text_of_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

int check(const CommandLine& line, Terminal& terminal) {
    const SceneSummary scene = check_scene(line.scene, line.overrides);
    terminal.say(fmt::format("{}: no problems", line.scene.string()));
    terminal.say(scene_in_a_line(scene));
    return exit_done;
}

int explain(const CommandLine& line, Terminal& terminal) {
    const SceneSummary scene = check_scene(line.scene, line.overrides);
    const observe::Simulation simulation(scene.scene, line.threads, kept_packs().get());
    for (const auto& fact : scene_facts(scene.scene, simulation)) terminal.say(fact);
    for (const auto& run : scene.runs) {
        if (!run.rest) terminal.say(run_outlook(simulation, run.duration));
    }
    return exit_done;
}

/// Reads the scene and looks at the folder, so that the user sees the problems of both at once.
RunSettings settings_for(const CommandLine& line) {
    const auto begin = std::chrono::steady_clock::now();
    RunSettings settings{output::RunFolder(line.folder, line.scene, line.overwrite),
                         line.scene.filename().string(),
                         text_of_file(line.scene),
                         {},
                         line.threads,
                         0.0,
                         kept_packs(),
                         line.progress,
                         line.profile};
    std::vector<Problem> problems;
    auto scene = collecting(problems, [&] { return check_scene(line.scene, line.overrides); });
    if (!scene || !scene->runs.empty()) {
        collecting(problems, [&] { return settings.folder.check(), true; });
    }
    if (!problems.empty()) throw SceneError(std::move(problems));
    settings.parameters = std::move(scene->parameters);
    settings.reading_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return settings;
}

int exit_code(const output::SummaryEnding& ending) {
    if (ending.state == "failed") return exit_failed;
    return ending.state == "interrupted" ? exit_interrupted : exit_done;
}

int run(const CommandLine& line, Terminal& terminal) {
    RunHost host(settings_for(line), terminal, interrupted);
    std::string failure;
    listen_to_signals();
    try {
        run_scene(line.scene, line.overrides, host);
    } catch (const std::exception& error) {
        // Before the first run nothing has been written, and it is the scene that is wrong.
        if (!host.started()) throw;
        failure = error.what();
    }
    if (host.started()) return exit_code(host.finish(failure));
    terminal.say(fmt::format("{}: no sim:run, so nothing was run", line.scene.string()));
    return exit_done;
}

int do_task(const CommandLine& line, Terminal& terminal) {
    switch (line.task) {
    case CommandLine::Task::check:
        return check(line, terminal);
    case CommandLine::Task::explain:
        return explain(line, terminal);
    case CommandLine::Task::text:
        fmt::print("{}", line.text);
        return exit_done;
    case CommandLine::Task::run:
        break;
    }
    return run(line, terminal);
}

int exit_code(StudyEnding ending) {
    if (ending == StudyEnding::failed) return exit_failed;
    return ending == StudyEnding::interrupted ? exit_interrupted : exit_done;
}

int study(int argc, const char* const* argv) {
    const StudyLine line = read_study_line(argc, argv);
    if (!line.text.empty()) {
        fmt::print("{}", line.text);
        return exit_done;
    }
    Terminal terminal(line.quiet);
    listen_to_signals();
    return exit_code(run_study(line, terminal, interrupted));
}

} // namespace

int run_program(int argc, const char* const* argv) {
    Terminal errors(false);
    try {
        if (argc > 1 && std::strcmp(argv[1], "study") == 0) return study(argc - 1, argv + 1);
        const CommandLine line = read_command_line(argc, argv);
        Terminal terminal(line.quiet);
        return do_task(line, terminal);
    } catch (const SceneError& error) {
        return complain(errors, error.problems());
    } catch (const std::exception& error) {
        errors.complain(fmt::format("demlua: {}", error.what()));
        return exit_failed;
    }
}

} // namespace demlua::scripting
