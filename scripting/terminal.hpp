// What the program says: to the terminal, and to the log of a run once there is one.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace demlua::output {
class Writer;
} // namespace demlua::output

namespace demlua::scripting {

class Terminal {
public:
    /// A quiet terminal shows errors and what the scene prints, nothing else.
    explicit Terminal(bool quiet);

    /// The program's own words.
    void say(const std::string& line);
    /// The scene's words.
    void print(const std::string& line);
    /// Errors, to stderr.
    void complain(const std::string& line);

    /// Whether a line that is redrawn makes sense.
    [[nodiscard]] bool interactive() const { return interactive_; }
    /// Columns of the terminal.
    [[nodiscard]] static int width();
    /// Shows `text` in place of the last such text; anything else said removes it.
    void show_passing(const std::string& text);
    void clear_passing();

    /// From now on all goes to the log too, what was said before included.
    void attach(output::Writer& log);
    void detach() { log_ = nullptr; }

private:
    using Clock = std::chrono::system_clock;

    void note(const std::string& line);

    bool quiet_;
    bool interactive_;
    bool passing_ = false;
    output::Writer* log_ = nullptr;
    std::vector<std::pair<Clock::time_point, std::string>> unlogged_;
};

} // namespace demlua::scripting
