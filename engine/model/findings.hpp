// What the checks of a scene have in common.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/base/signal.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace demlua::model {

/// Problems as they are found, in the order of the scene.
struct Findings {
    std::vector<Problem> problems;

    void add(std::vector<Problem> found) { std::move(found.begin(), found.end(), std::back_inserter(problems)); }
    void add(const Place& place, std::string what, std::string value, std::string rule, std::string hint = {}) {
        problems.push_back({place, std::move(what), std::move(value), std::move(rule), std::move(hint)});
    }
};

/// Times must rise, and all numbers must be finite. A signal that is not there is right.
void check_signal(const std::optional<Signal>& signal, const std::string& what, const Place& place, Findings& findings);

/// Results are found by name, so a name must belong to one thing of its kind.
template <class Named>
void check_names(const std::vector<Named>& all, const std::string& word, Findings& findings) {
    std::set<std::string> seen;
    for (const Named& each : all) {
        if (!each.name.empty() && !seen.insert(each.name).second) {
            findings.add(each.place, word + ".name", '"' + each.name + '"', "is already the name of another " + word);
        }
    }
}

} // namespace demlua::model
