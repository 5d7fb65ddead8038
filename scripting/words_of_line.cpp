#include "scripting/words_of_line.hpp"

#include <fmt/format.h>

#include <charconv>
#include <utility>

namespace demlua::scripting {

namespace {

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const auto* option : app.get_options()) {
        for (const auto& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

} // namespace

Problem line_problem(std::string what, std::string value, std::string rule, std::string hint) {
    return {{"demlua", 0}, std::move(what), std::move(value), std::move(rule), std::move(hint)};
}

void refuse_extras(const CLI::App& app, const std::string& what, std::vector<Problem>& problems) {
    for (const auto& extra : app.remaining()) {
        if (extra.rfind('-', 0) != 0) {
            problems.push_back(line_problem(extra, "", "one " + what + " at a time"));
            continue;
        }
        const std::string near = nearest_word(extra.substr(0, extra.find('=')), option_names(app));
        const std::string help = "see " + app.get_name() + " --help";
        problems.push_back(
            line_problem(extra, "", "unknown option", near.empty() ? help : "did you mean " + near + "?"));
    }
}

Overrides read_overrides(const std::vector<std::string>& set, std::vector<Problem>& problems) {
    Overrides overrides;
    for (const auto& word : set) {
        const auto equals = word.find('=');
        if (equals == std::string::npos || equals == 0) {
            problems.push_back(line_problem("--set", word, "NAME=VALUE"));
        } else {
            overrides.emplace_back(word.substr(0, equals), word.substr(equals + 1));
        }
    }
    return overrides;
}

int read_count(const std::string& option, const std::string& word, int most, int otherwise,
               std::vector<Problem>& problems) {
    if (word.empty()) return otherwise;
    int count = 0;
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, count);
    if (error == std::errc() && rest == end && count >= 1 && count <= most) return count;
    problems.push_back(line_problem(option, word, fmt::format("a whole number from 1 to {}", most)));
    return otherwise;
}

} // namespace demlua::scripting
