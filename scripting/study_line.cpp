// The command line of demlua study.
#include "scripting/study_program.hpp"
#include "scripting/words_of_line.hpp"

namespace demlua::scripting {

namespace {

constexpr int most_jobs = 64;
constexpr const char* endings =
    "A run that has finished is not made again by the same program with the same scene and parameters.\n"
    "Exit codes: 0 done; 2 something is wrong with the scene, its study or the command line, and nothing was run;\n"
    "3 a run failed or did not bring what is measured; 130 interrupted: the same command goes on.";

struct Words {
    std::string scene;
    std::vector<std::string> set;
    std::string folder;
    std::string jobs;
    std::string threads;
    bool quick = false;
    bool fresh = false;
    bool quiet = false;
};

void declare(CLI::App& app, Words& words) {
    app.add_option("FILE.lua", words.scene, "A scene that says dem.study")->type_name("");
    app.add_flag("--quick", words.quick, "Only the two coarsest levels, and one seed");
    app.add_option("--jobs", words.jobs, "Runs side by side, 1 to 64; with more than one no times are quoted")
        ->type_name("N");
    app.add_option("--threads", words.threads, "Of each run, 1 to 256; else as many as there are processors")
        ->type_name("N");
    app.add_option("--set", words.set, "Give a parameter that is not varied another value")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    app.add_option("-o,--output", words.folder, "Folder to write into; else the scene's name with .study")
        ->type_name("DIR");
    app.add_flag("--fresh", words.fresh, "Make finished runs again");
    app.add_flag("--quiet", words.quiet, "Show only errors");
    app.footer(endings);
    app.allow_extras();
}

StudyLine meaning(const CLI::App& app, const Words& words) {
    StudyLine line;
    std::vector<Problem> problems;
    refuse_extras(app, "study", problems);
    line.overrides = read_overrides(words.set, problems);
    line.jobs = read_count("--jobs", words.jobs, most_jobs, 1, problems);
    line.threads = read_count("--threads", words.threads, most_threads, 0, problems);
    if (words.scene.empty()) {
        problems.push_back(line_problem("FILE.lua", "", "missing", "see demlua study --help"));
    }
    if (!problems.empty()) throw SceneError(std::move(problems));
    line.scene = words.scene;
    line.folder =
        !words.folder.empty() ? std::filesystem::path(words.folder) : line.scene.filename().replace_extension(".study");
    line.quick = words.quick;
    line.fresh = words.fresh;
    line.quiet = words.quiet;
    return line;
}

} // namespace

StudyLine read_study_line(int argc, const char* const* argv) {
    CLI::App app(
        "Runs what a scene declares with dem.study: a quantity at several levels, its error, and what it cost.",
        "demlua study");
    Words words;
    declare(app, words);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        StudyLine line;
        line.text = app.help();
        return line;
    } catch (const CLI::ParseError& error) {
        throw SceneError(line_problem(error.what(), "", "", "see demlua study --help"));
    }
    return meaning(app, words);
}

} // namespace demlua::scripting
