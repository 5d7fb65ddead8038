// The table of a study: for people, for spreadsheets, for scripts.
#pragma once

#include "engine/study/study.hpp"

#include <string>
#include <vector>

namespace demlua::study {

/// Headings and cells as short texts; a column that says nothing in any row is left out.
struct Table {
    std::vector<std::string> headings;
    std::vector<std::vector<std::string>> rows;
};
Table table_of(const Study& study);

/// The same as lines of equal length, columns aligned to the right.
std::vector<std::string> lines_of(const Table& table);

/// One row for each level, with full digits and SI units; what is not known is empty.
std::string csv_of(const Study& study);

/// Everything, each single run included. `version` is that of the program that ran it.
std::string json_of(const Study& study, const std::string& version);

} // namespace demlua::study
