#include "engine/output/history.hpp"

#include "engine/base/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
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

/// `names` with those of `now` that are new, each after the one it follows in `now`.
std::vector<std::string> joined(std::vector<std::string> names, const std::vector<std::string>& now) {
    auto after = names.begin();
    for (const std::string& name : now) {
        const auto known = std::find(names.begin(), names.end(), name);
        after = (known != names.end() ? known : names.insert(after, name)) + 1;
    }
    return names;
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string each; std::getline(stream, each, ',');) cells.push_back(each);
    return cells;
}

/// One line of a table whose columns are `names`; cells without a value are empty.
template <class ValueOf>
std::string line_of(const std::vector<std::string>& names, const ValueOf& value_of) {
    std::string line;
    for (const std::string& name : names) line += (&name == &names.front() ? "" : ",") + value_of(name);
    return line;
}

} // namespace

HistoryFile::HistoryFile(std::filesystem::path file) : path_(std::move(file)), file_(path_) {}

void HistoryFile::begin(const std::vector<std::string>& names) {
    auto sorted = names;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) throw RunError(fmt::format("history: two columns are called {}", *twice));
    file_.line(line_of(names, cell));
    columns_ = names;
}

void HistoryFile::widen(const std::vector<std::string>& names) {
    std::vector<std::string> lines;
    {
        std::ifstream written(path_);
        std::string line;
        std::getline(written, line);
        while (std::getline(written, line)) lines.push_back(line);
    }
    const std::vector<std::string> before = columns_;
    file_ = TextFile(path_);
    begin(names);
    for (const std::string& line : lines) {
        std::map<std::string, std::string> values;
        const std::vector<std::string> cells = cells_of(line);
        for (std::size_t k = 0; k < cells.size(); ++k) values[before[k]] = cells[k];
        file_.line(line_of(columns_, [&](const std::string& name) { return values[name]; }));
    }
}

void HistoryFile::add(const observe::HistoryRow& row) {
    const auto now = names_of(row);
    if (columns_.empty()) begin(now);
    if (now != columns_) {
        const std::vector<std::string> all = joined(columns_, now);
        if (all != columns_) widen(all);
    }
    std::map<std::string, std::string> values;
    for (const auto& [name, value] : row) values[name] = fmt::format("{}", value);
    file_.line(line_of(columns_, [&](const std::string& name) { return values[name]; }));
}

} // namespace demlua::output
