// The history of a run as comma-separated values.
#pragma once

#include "engine/observe/snapshot.hpp"
#include "engine/output/text_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace demlua::output {

/// The rows' names make the header. A name that comes later, as when a load is added between runs, makes a column that is
/// empty above; a name that goes leaves cells empty. Numbers have as many digits as it takes to read the same number back.
class HistoryFile {
public:
    /// Throws RunError when the file cannot be made.
    explicit HistoryFile(std::filesystem::path file);

    /// Throws RunError when the file cannot be written, or two columns have one name.
    void add(const observe::HistoryRow& row);

private:
    void begin(const std::vector<std::string>& names);
    void widen(const std::vector<std::string>& names);

    std::filesystem::path path_;
    TextFile file_;
    std::vector<std::string> columns_;
};

} // namespace demlua::output
