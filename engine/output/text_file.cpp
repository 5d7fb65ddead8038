#include "engine/output/text_file.hpp"

#include "engine/base/problems.hpp"
#include "engine/output/whole_file.hpp"

#include <fmt/format.h>

#include <utility>

namespace demlua::output {

TextFile::TextFile(std::filesystem::path file) : path_(std::move(file)), handle_(std::fopen(path_.c_str(), "wb")) {
    if (!handle_) fail();
}

void TextFile::line(std::string_view text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), handle_.get()) == text.size() &&
                         std::fputc('\n', handle_.get()) != EOF && std::fflush(handle_.get()) == 0;
    if (!written) fail();
}

void TextFile::fail() const {
    throw RunError(fmt::format("{} cannot be written: {}", path_.string(), system_reason()));
}

} // namespace demlua::output
