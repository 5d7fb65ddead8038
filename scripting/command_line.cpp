#include "scripting/command_line.hpp"

#include "demlua/version.hpp"
#include "scripting/words_of_line.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace demlua::scripting {

namespace {

constexpr const char* endings = "demlua study FILE.lua runs what the scene declares with dem.study: speed against "
                                "error; see\ndemlua study --help.\n"
                                "Exit codes: 0 done; 2 something is wrong with the scene or the command line, and\n"
                                "nothing was written; 3 the run failed; 130 interrupted, its last frame written.";

/// The words as given, before they mean anything.
struct Words {
    std::string scene;
    std::vector<std::string> set;
    std::string folder;
    std::string threads;
    std::string progress;
    std::string help_scene;
    bool check = false;
    bool explain = false;
    bool profile = false;
    bool quiet = false;
    bool overwrite = false;
    bool version = false;
    bool reference = false;
    bool editor_stub = false;
};

void declare(CLI::App& app, Words& words) {
    app.add_option("FILE.lua", words.scene, "The scene to run")->type_name("");
    app.add_option("--set", words.set, "Give a parameter of the scene another value")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    app.add_option("-o,--output", words.folder, "Folder to write into; else the scene's name with .out")
        ->type_name("DIR");
    app.add_option("--threads", words.threads, "1 to 256; else as many as there are processors and work for")
        ->type_name("N");
    app.add_flag("--check", words.check, "Say whether the scene is right; run nothing");
    app.add_flag("--explain", words.explain, "Assemble the scene and say what a run would do; run nothing");
    app.add_flag("--profile", words.profile, "Say at the end what each stage of a step took");
    app.add_flag("--quiet", words.quiet, "Show only errors and what the scene prints");
    app.add_option("--progress", words.progress, "Keep the simulated time reached, in s, in this file")
        ->type_name("FILE");
    app.add_flag("--overwrite", words.overwrite, "Replace the run that the folder holds");
    app.add_flag("--version", words.version, "Print the version");
    app.add_option("--help-scene", words.help_scene, "Print the words of the scene language, or one of them")
        ->type_name("[WORD]")
        ->expected(0, 1);
    app.add_flag("--scene-reference", words.reference, "Print the scene language as Markdown");
    app.add_flag("--editor-stub", words.editor_stub, "Print the scene language for the Lua language server");
    app.footer(endings);
    app.allow_extras();
}

std::string version_text() { return fmt::format("demlua {} ({}, {}, {})\n", version, revision, compiler, build_type); }

/// What was asked to be printed; empty when a scene is to be run.
std::string text_asked_for(const CLI::App& app, const Words& words) {
    if (words.version) return version_text();
    if (app.count("--help-scene") > 0) return words_as_text(words.help_scene);
    if (words.reference) return words_as_markdown();
    if (words.editor_stub) return words_as_editor_stub();
    return {};
}

CommandLine meaning(const CLI::App& app, const Words& words) {
    CommandLine line;
    std::vector<Problem> problems;
    refuse_extras(app, "scene", problems);
    line.overrides = read_overrides(words.set, problems);
    line.threads = read_count("--threads", words.threads, most_threads, 0, problems);
    if (words.check && words.explain) problems.push_back(line_problem("--check --explain", "", "one of them"));
    if (problems.empty()) line.text = text_asked_for(app, words);
    if (line.text.empty() && words.scene.empty())
        problems.push_back(line_problem("FILE.lua", "", "missing", "see demlua --help"));
    if (!problems.empty()) throw SceneError(std::move(problems));
    using Task = CommandLine::Task;
    line.task = !line.text.empty() ? Task::text : words.check ? Task::check : words.explain ? Task::explain : Task::run;
    line.scene = words.scene;
    line.folder =
        !words.folder.empty() ? std::filesystem::path(words.folder) : line.scene.filename().replace_extension(".out");
    line.progress = words.progress;
    line.profile = words.profile;
    line.quiet = words.quiet;
    line.overwrite = words.overwrite;
    return line;
}

} // namespace

CommandLine read_command_line(int argc, const char* const* argv) {
    CLI::App app("Runs a scene of disks and bonds written in Lua and writes what happens for ParaView.", "demlua");
    Words words;
    declare(app, words);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        CommandLine line;
        line.task = CommandLine::Task::text;
        line.text = app.help();
        return line;
    } catch (const CLI::ParseError& error) {
        throw SceneError(line_problem(error.what(), "", "", "see demlua --help"));
    }
    return meaning(app, words);
}

} // namespace demlua::scripting
