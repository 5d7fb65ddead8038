// A text file that grows line by line, each on disk before the next is asked for.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace demlua::output {

class TextFile {
public:
    /// Starts the file anew. Throws RunError with the system's reason.
    explicit TextFile(std::filesystem::path file);

    /// Adds `text` and a line end, and hands them to the system. Throws RunError.
    void line(std::string_view text);

private:
    struct Close {
        void operator()(std::FILE* handle) const { std::fclose(handle); }
    };

    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    std::unique_ptr<std::FILE, Close> handle_;
};

} // namespace demlua::output
