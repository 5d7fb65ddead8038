// Files that others may open at any moment: they see the old text or the new one, never a part.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace demlua::output {

/// Ending of the names under which files are written before they get their own.
inline constexpr std::string_view unfinished = ".unfinished";

/// Writes `text` beside `file` and renames it. Throws RunError with the system's reason; nothing is left behind then.
void replace_file(const std::filesystem::path& file, std::string_view text);

/// The reason the system gave for the last call that failed, e.g. "No space left on device".
std::string system_reason();

} // namespace demlua::output
