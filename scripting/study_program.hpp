// demlua study: speed against error.
#pragma once

#include "scripting/script.hpp"
#include "scripting/study_runner.hpp"
#include "scripting/terminal.hpp"

#include <atomic>
#include <filesystem>
#include <string>

namespace demlua::scripting {

/// What was asked on the command line.
struct StudyLine {
    std::filesystem::path scene;
    std::filesystem::path folder; ///< -o, else the scene's name with .study
    Overrides overrides;
    int jobs = 1;
    int threads = 0;
    bool quick = false;
    bool fresh = false; ///< forget finished runs
    bool quiet = false;
    std::string text; ///< to be printed in place of a study
};

/// Throws SceneError with every problem of the command line; `argv` begins with "study".
StudyLine read_study_line(int argc, const char* const* argv);

/// Makes the runs and, when all are done, writes study.csv, study.json, study.html, error_size.svg and error_time.svg. Says
/// why when it does not come to that. Throws SceneError for what is wrong with scene or study before anything is run.
StudyEnding run_study(const StudyLine& line, Terminal& terminal, const std::atomic<bool>& interrupted);

} // namespace demlua::scripting
