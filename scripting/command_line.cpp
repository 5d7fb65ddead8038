#include "scripting/command_line.hpp"

#include "demlua/version.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <thread>
#include <utility>
#include <vector>

namespace demlua::scripting {

namespace {

constexpr int most_threads = 256;
constexpr const char* endings = "Exit codes: 0 done; 2 something is wrong with the scene or the command line, and\n"
                                "nothing was written; 3 the run failed; 130 interrupted, its last frame written.";

Problem problem(std::string what, std::string value, std::string rule, std::string hint = {}) {
    return {{"demlua", 0}, std::move(what), std::move(value), std::move(rule), std::move(hint)};
}

/// The words as given, before they mean anything.
struct Words {
    std::string scene;
    std::vector<std::string> set;
    std::string folder;
    std::string threads;
    std::string help_scene;
    bool check = false;
    bool explain = false;
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
    app.add_flag("--quiet", words.quiet, "Show only errors and what the scene prints");
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

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const auto* option : app.get_options()) {
        for (const auto& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

void refuse_extras(const CLI::App& app, std::vector<Problem>& problems) {
    for (const auto& extra : app.remaining()) {
        if (extra.rfind('-', 0) != 0) {
            problems.push_back(problem(extra, "", "one scene at a time"));
            continue;
        }
        const std::string near = nearest_word(extra.substr(0, extra.find('=')), option_names(app));
        problems.push_back(
            problem(extra, "", "unknown option", near.empty() ? "see demlua --help" : "did you mean " + near + "?"));
    }
}

void read_overrides(const std::vector<std::string>& set, CommandLine& line, std::vector<Problem>& problems) {
    for (const auto& word : set) {
        const auto equals = word.find('=');
        if (equals == std::string::npos || equals == 0) {
            problems.push_back(problem("--set", word, "NAME=VALUE"));
        } else {
            line.overrides.emplace_back(word.substr(0, equals), word.substr(equals + 1));
        }
    }
}

void read_threads(const std::string& word, CommandLine& line, std::vector<Problem>& problems) {
    if (word.empty()) return;
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, line.threads);
    if (error != std::errc() || rest != end || line.threads < 1 || line.threads > most_threads) {
        problems.push_back(problem("--threads", word, fmt::format("a whole number from 1 to {}", most_threads)));
    }
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
    refuse_extras(app, problems);
    read_overrides(words.set, line, problems);
    read_threads(words.threads, line, problems);
    if (words.check && words.explain) problems.push_back(problem("--check --explain", "", "one of them"));
    if (problems.empty()) line.text = text_asked_for(app, words);
    if (line.text.empty() && words.scene.empty())
        problems.push_back(problem("FILE.lua", "", "missing", "see demlua --help"));
    if (!problems.empty()) throw SceneError(std::move(problems));
    using Task = CommandLine::Task;
    line.task = !line.text.empty() ? Task::text : words.check ? Task::check : words.explain ? Task::explain : Task::run;
    line.scene = words.scene;
    line.folder =
        !words.folder.empty() ? std::filesystem::path(words.folder) : line.scene.filename().replace_extension(".out");
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
        throw SceneError(problem(error.what(), "", "", "see demlua --help"));
    }
    return meaning(app, words);
}

} // namespace demlua::scripting
