#include "engine/output/whole_file.hpp"

#include "engine/base/problems.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace demlua::output {

namespace {

bool write_all(const std::filesystem::path& file, std::string_view text) {
    std::FILE* handle = std::fopen(file.c_str(), "wb");
    if (handle == nullptr) return false;
    const bool written = std::fwrite(text.data(), 1, text.size(), handle) == text.size();
    // A full disk may show only when the last buffer is handed over.
    const int closed = std::fclose(handle);
    return written && closed == 0;
}

} // namespace

std::string system_reason() { return std::strerror(errno); }

void replace_file(const std::filesystem::path& file, std::string_view text) {
    std::filesystem::path draft = file;
    draft += unfinished;
    if (write_all(draft, text) && std::rename(draft.c_str(), file.c_str()) == 0) return;
    const std::string reason = system_reason();
    std::remove(draft.c_str());
    throw RunError(fmt::format("{} cannot be written: {}", file.string(), reason));
}

} // namespace demlua::output
