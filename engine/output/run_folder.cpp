#include "engine/output/run_folder.hpp"

#include "engine/base/problems.hpp"
#include "engine/output/whole_file.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <array>
#include <regex>
#include <system_error>
#include <utility>

namespace demlua::output {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& folder, const std::string& rule, const std::string& hint = {}) {
    throw SceneError(Problem{Place(), "output folder", folder.string(), rule, hint});
}

/// What every run leaves from its first moment on, so that a folder holding one of them holds a run.
constexpr std::array marks{names::log, names::summary};

bool holds_run(const fs::path& folder) {
    for (const auto mark : marks) {
        if (fs::exists(folder / mark)) return true;
    }
    for (const auto series : {names::elements, names::bonds, names::cracks, names::walls}) {
        if (fs::exists(folder / fmt::format("{}.pvd", series))) return true;
    }
    return false;
}

/// A file of the user's that a run would overwrite; empty when there is none.
std::string file_in_the_way(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::string name = entry.path().filename().string();
        if (written_by_a_run(name)) return name;
    }
    return {};
}

fs::path nearest_existing(fs::path path) {
    while (!fs::exists(path)) {
        path = path.has_parent_path() ? path.parent_path() : fs::path(".");
    }
    return path;
}

bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return fs::equivalent(a, b, ignored);
}

} // namespace

bool written_by_a_run(const std::string& name) {
    static const std::regex pattern(
        R"((scene\.lua|run\.log|history\.csv|summary\.json|(elements|bonds|cracks|walls)(_[0-9]{6,}\.vtu|\.pvd|\.vtu\.series))(\.unfinished)?)");
    return std::regex_match(name, pattern);
}

RunFolder::RunFolder(fs::path path, fs::path scene_file, bool overwrite)
    : path_(std::move(path)), scene_file_(std::move(scene_file)), overwrite_(overwrite) {}

void RunFolder::check() const {
    try {
        const fs::path existing = nearest_existing(path_);
        if (!fs::is_directory(existing)) refuse(path_, existing.string() + " is not a folder");
        if (access(existing.c_str(), R_OK | W_OK | X_OK) != 0) {
            refuse(path_, fmt::format("{} is not writable: {}", existing.string(), system_reason()));
        }
        if (existing != path_) return;
        if (same_file(file(names::scene), scene_file_)) {
            refuse(path_, "must not be the folder of the scene itself when that is called scene.lua");
        }
        if (holds_run(path_)) {
            if (!overwrite_) refuse(path_, "holds another run", "choose one with -o, or --overwrite to replace it");
            return;
        }
        const std::string name = file_in_the_way(path_);
        if (!name.empty()) refuse(path_, fmt::format("holds {}, which no run wrote", name), "choose one with -o");
    } catch (const fs::filesystem_error& error) {
        refuse(path_, "cannot be read: " + error.code().message());
    }
}

void RunFolder::open(std::string_view scene_text) const {
    check();
    std::error_code failed;
    const bool made = fs::create_directories(path_, failed);
    if (failed) refuse(path_, "cannot be made: " + failed.message());
    try {
        if (!made) remove_earlier_run();
        replace_file(file(names::scene), scene_text);
    } catch (const RunError& error) {
        if (made) fs::remove(path_, failed);
        refuse(path_, error.what());
    } catch (const fs::filesystem_error& error) {
        refuse(path_, "cannot be emptied: " + error.code().message());
    }
}

void RunFolder::remove_earlier_run() const {
    for (const auto& entry : fs::directory_iterator(path_)) {
        if (written_by_a_run(entry.path().filename().string())) fs::remove(entry.path());
    }
}

} // namespace demlua::output
