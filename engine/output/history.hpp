// The history of a run as comma-separated values.
#pragma once

#include "engine/observe/snapshot.hpp"
#include "engine/output/text_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace demlua::output {

/// The first row's names make the header. Numbers have as many digits as it takes to read the same number back.
class HistoryFile {
public:
    /// Throws RunError when the file cannot be made.
    explicit HistoryFile(std::filesystem::path file);

    /// Throws RunError when the file cannot be written, two columns have one name, or the names are not the header's.
    void add(const observe::HistoryRow& row);

private:
    void begin(const observe::HistoryRow& row);

    TextFile file_;
    std::vector<std::string> columns_;
};

} // namespace demlua::output
