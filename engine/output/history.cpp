#include "engine/output/history.hpp"

#include "engine/base/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace demlua::output {

namespace {

/// A name as a CSV cell: in quotes when it needs them.
std::string cell(const std::string& name) {
    if (name.find_first_of(",\"\n") == std::string::npos) return name;
    std::string quoted = "\"";
    for (const char c : name) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::vector<std::string> names_of(const observe::HistoryRow& row) {
    std::vector<std::string> names;
    names.reserve(row.size());
    for (const auto& column : row) names.push_back(column.first);
    return names;
}

/// The first name that `names` holds and `others` does not.
std::string odd_one(const std::vector<std::string>& names, const std::vector<std::string>& others) {
    for (const std::string& name : names) {
        if (std::find(others.begin(), others.end(), name) == others.end()) return name;
    }
    return {};
}

[[noreturn]] void complain_of_change(const std::vector<std::string>& header, const std::vector<std::string>& now) {
    const std::string added = odd_one(now, header);
    const std::string gone = odd_one(header, now);
    const std::string what = !added.empty()  ? fmt::format("column {} is new", added)
                             : !gone.empty() ? fmt::format("column {} is missing", gone)
                                             : std::string("the columns stand in another order");
    throw RunError(fmt::format("history: {}: every row of a run has the columns of the first", what));
}

} // namespace

HistoryFile::HistoryFile(std::filesystem::path file) : file_(std::move(file)) {}

void HistoryFile::begin(const observe::HistoryRow& row) {
    columns_ = names_of(row);
    auto sorted = columns_;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) throw RunError(fmt::format("history: two columns are called {}", *twice));
    std::string header;
    for (const std::string& name : columns_) header += (header.empty() ? "" : ",") + cell(name);
    file_.line(header);
}

void HistoryFile::add(const observe::HistoryRow& row) {
    if (columns_.empty()) begin(row);
    const auto now = names_of(row);
    if (now != columns_) complain_of_change(columns_, now);
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
        fmt::format_to(std::back_inserter(line), "{}{}", k == 0 ? "" : ",", row[k].second);
    }
    file_.line(line);
}

} // namespace demlua::output
