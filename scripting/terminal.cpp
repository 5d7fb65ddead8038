#include "scripting/terminal.hpp"

#include "engine/output/writer.hpp"

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace demlua::scripting {

namespace {

/// A terminal that can erase a line.
bool can_redraw() {
    const char* kind = std::getenv("TERM");
    return isatty(STDOUT_FILENO) == 1 && kind != nullptr && std::strcmp(kind, "dumb") != 0;
}

} // namespace

Terminal::Terminal(bool quiet) : quiet_(quiet), interactive_(!quiet && can_redraw()) {}

void Terminal::say(const std::string& line) {
    if (!quiet_) {
        clear_passing();
        fmt::print("{}\n", line);
        std::fflush(stdout);
    }
    note(line);
}

void Terminal::print(const std::string& line) {
    clear_passing();
    fmt::print("{}\n", line);
    std::fflush(stdout);
    note(line);
}

void Terminal::complain(const std::string& line) {
    clear_passing();
    fmt::print(stderr, "{}\n", line);
    note(line);
}

int Terminal::width() {
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

void Terminal::show_passing(const std::string& text) {
    fmt::print("\r{}\033[K", text);
    std::fflush(stdout);
    passing_ = true;
}

void Terminal::clear_passing() {
    if (!passing_) return;
    fmt::print("\r\033[K");
    std::fflush(stdout);
    passing_ = false;
}

void Terminal::attach(output::Writer& log) {
    log_ = &log;
    for (auto& [when, line] : unlogged_) log.log(when, std::move(line));
    unlogged_.clear();
}

void Terminal::note(const std::string& line) {
    if (log_ != nullptr) {
        log_->log(Clock::now(), line);
    } else {
        unlogged_.emplace_back(Clock::now(), line);
    }
}

} // namespace demlua::scripting
