// What is wrong with a scene, collected so that a user sees everything at once.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace demlua {

/// Where in the user's files something was said; line 0 when no line is known.
struct Place {
    std::string file;
    int line = 0;
};

/// One complaint. `what` is the noun or noun.key, `value` what was given (may be empty), `rule` what is asked,
/// `hint` a suggestion (may be empty).
struct Problem {
    Place place;
    std::string what;
    std::string value;
    std::string rule;
    std::string hint;

    /// `file:line: what = value: rule; hint`, leaving out what is empty.
    [[nodiscard]] std::string message() const;
};

/// Thrown when a scene cannot be run as written; carries every problem found so far.
class SceneError : public std::runtime_error {
public:
    explicit SceneError(std::vector<Problem> problems);
    explicit SceneError(Problem problem) : SceneError(std::vector<Problem>{std::move(problem)}) {}

    [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }

private:
    std::vector<Problem> problems_;
};

/// Thrown when a run must stop: a value that is not a number, runaway energy, an element moving too far in a step.
class RunError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The entry of `known` nearest to `word` by edit distance, or an empty string when none is near enough to suggest.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

} // namespace demlua
