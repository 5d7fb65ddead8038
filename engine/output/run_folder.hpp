// The folder a run writes into: made when the run starts, never one that holds another run unless told so.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace demlua::output {

/// What a run writes besides the numbered files of its series.
namespace names {
inline constexpr std::string_view scene = "scene.lua";
inline constexpr std::string_view log = "run.log";
inline constexpr std::string_view history = "history.csv";
inline constexpr std::string_view summary = "summary.json";
inline constexpr std::string_view elements = "elements";
inline constexpr std::string_view bonds = "bonds";
inline constexpr std::string_view cracks = "cracks";
inline constexpr std::string_view walls = "walls";
} // namespace names

class RunFolder {
public:
    /// `scene_file` is the scene that will run; nothing is touched yet.
    RunFolder(std::filesystem::path path, std::filesystem::path scene_file, bool overwrite);

    /// Throws SceneError when a run could not be put here: not a folder, not writable, holding another run or files
    /// that a run would overwrite. Touches nothing.
    void check() const;

    /// Checks, makes the folder, removes what an earlier run wrote there, and puts `scene_text` in it. Throws
    /// SceneError; a folder made in vain is removed again.
    void open(std::string_view scene_text) const;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path file(std::string_view name) const { return path_ / name; }

private:
    void remove_earlier_run() const;

    std::filesystem::path path_;
    std::filesystem::path scene_file_;
    bool overwrite_;
};

/// Whether a file of this name is one that a run writes.
bool written_by_a_run(const std::string& name);

} // namespace demlua::output
