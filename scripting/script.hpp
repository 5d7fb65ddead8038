// A scene file: Lua, read in a sandbox.
#pragma once

#include "scripting/host.hpp"
#include "scripting/study_declaration.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace demlua::scripting {

/// `--set name=value`, in the order given.
using Overrides = std::vector<std::pair<std::string, std::string>>;

struct SourceFile {
    std::filesystem::path path;
    std::string text;
};

/// What a scene turned out to be when only read.
struct SceneSummary {
    model::Scene scene; ///< as it stands at the first run (or at the end of a file without one)
    std::vector<Parameter> parameters;
    std::vector<RunRequest> runs;  ///< without their functions
    std::vector<SourceFile> files; ///< the scene's own and those it includes
    std::optional<StudyDeclaration> study;
    bool read_to_end = false; ///< false: a line asked for results that only a run brings, and those after it are unread
};

/// Reads a scene without running it and checks all that can be checked without packing it. Throws SceneError with every
/// problem: missing file, Lua errors, unknown keys, wrong types, values out of range, unknown parameters in `overrides`.
SceneSummary check_scene(const std::filesystem::path& file, const Overrides& overrides);

/// Runs a scene that check_scene has passed, asking `host` at every sim:run. A Lua error in the script or in a callback
/// becomes a SceneError that names file and line and carries the traceback.
void run_scene(const std::filesystem::path& file, const Overrides& overrides, Host& host);

/// All words of the scene language with their settings, as plain text for the terminal (`demlua --help-scene [word]`), as
/// Markdown for docs/scene.md and as a stub for the Lua language server.
std::string words_as_text(const std::string& word);
std::string words_as_markdown();
std::string words_as_editor_stub();

} // namespace demlua::scripting
