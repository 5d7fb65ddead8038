// What the command lines of the program's tasks share.
#pragma once

#include "engine/base/problems.hpp"
#include "scripting/script.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace demlua::scripting {

inline constexpr int most_threads = 256;

Problem line_problem(std::string what, std::string value, std::string rule, std::string hint = {});

/// Complains of words that mean nothing; `what` names the one file expected, "scene" or "study".
void refuse_extras(const CLI::App& app, const std::string& what, std::vector<Problem>& problems);

/// NAME=VALUE each.
Overrides read_overrides(const std::vector<std::string>& set, std::vector<Problem>& problems);

/// A whole number from 1 to `most`; `otherwise` where nothing was said.
int read_count(const std::string& option, const std::string& word, int most, int otherwise,
               std::vector<Problem>& problems);

} // namespace demlua::scripting
