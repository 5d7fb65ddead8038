// One line on the terminal that tells how far a run is, how fast, and how long it will take.
#pragma once

#include "engine/observe/simulation.hpp"
#include "scripting/terminal.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

namespace demlua::scripting {

/// `share` (0 to 1) of so many cells filled.
std::string bar(double share, int cells);

/// Keeps the simulated time reached, s, in `file`, written anew now and then.
observe::Watcher time_teller(const std::filesystem::path& file);

class Progress {
public:
    /// A run of `duration` s that begins now.
    Progress(Terminal& terminal, const observe::Simulation& simulation, double duration);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    Progress(Progress&&) = delete;
    Progress& operator=(Progress&&) = delete;

    /// Looks at the simulation now and then to redraw the line; nothing but its time and step are read.
    [[nodiscard]] observe::Watcher watcher();

private:
    using Clock = std::chrono::steady_clock;

    void draw(const observe::Simulation& simulation);

    Terminal& terminal_;
    double duration_;
    double first_time_;
    std::uint64_t first_step_;
    std::size_t elements_;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_draw_ = begin_;
};

} // namespace demlua::scripting
