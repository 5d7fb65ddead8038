// What the user asked for on the command line.
#pragma once

#include "scripting/script.hpp"

#include <filesystem>
#include <string>

namespace demlua::scripting {

struct CommandLine {
    enum class Task {
        run,
        check,   ///< read the scene and say whether it is right
        explain, ///< assemble it and say what would run
        text     ///< print `text` and leave
    };

    Task task = Task::run;
    std::string text;
    std::filesystem::path scene;
    Overrides overrides;
    std::filesystem::path folder;   ///< where the run goes: -o, else the scene's name with .out
    int threads = 0;                ///< 0: as many as there are processors and work for
    std::filesystem::path progress; ///< file that tells the time reached; empty for none
    bool profile = false;           ///< whether to say what each stage took
    bool quiet = false;
    bool overwrite = false;
};

/// Throws SceneError with every problem of the command line.
CommandLine read_command_line(int argc, const char* const* argv);

} // namespace demlua::scripting
