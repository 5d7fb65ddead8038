#include "scripting/progress.hpp"

#include "engine/output/whole_file.hpp"
#include "scripting/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace demlua::scripting {

namespace {

constexpr std::chrono::milliseconds shortest_pause{100};

} // namespace

std::string bar(double share, int cells) {
    const auto filled = static_cast<std::size_t>(share * cells);
    return std::string(filled, '#') + std::string(static_cast<std::size_t>(cells) - filled, '.');
}

observe::Watcher time_teller(const std::filesystem::path& file) {
    using Clock = std::chrono::steady_clock;
    return {0.0, [file, next = Clock::now()](const observe::Simulation& simulation) mutable {
                if (Clock::now() < next) return;
                next = Clock::now() + shortest_pause;
                output::replace_file(file, fmt::format("{}\n", simulation.time()));
            }};
}

Progress::Progress(Terminal& terminal, const observe::Simulation& simulation, double duration)
    : terminal_(terminal), duration_(duration), first_time_(simulation.time()), first_step_(simulation.step()),
      elements_(simulation.element_count()) {}

Progress::~Progress() { terminal_.clear_passing(); }

observe::Watcher Progress::watcher() {
    // At every step: an interval of its own could change the time step, and with it the result.
    return {0.0, [this](observe::Simulation& simulation) { draw(simulation); }};
}

void Progress::draw(const observe::Simulation& simulation) {
    const auto now = Clock::now();
    if (now < next_draw_) return;
    next_draw_ = now + shortest_pause;
    const double wall = std::chrono::duration<double>(now - begin_).count();
    const auto steps = static_cast<double>(simulation.step() - first_step_);
    const double share = std::clamp((simulation.time() - first_time_) / duration_, 0.0, 1.0);
    if (steps == 0.0 || share == 0.0) return;
    const std::string figures =
        fmt::format(" {:3.0f} %  {} steps/s  {:.0f} ns per element and step  {} left", 100.0 * share,
                    grouped(static_cast<std::uint64_t>(steps / wall)),
                    wall / steps / static_cast<double>(std::max<std::size_t>(elements_, 1)) * 1e9,
                    scripting::duration(wall * (1.0 / share - 1.0)));
    const int room = Terminal::width() - static_cast<int>(figures.size()) - 3;
    if (room < 0) return;
    terminal_.show_passing(fmt::format("[{}]{}", bar(share, std::min(room, 30)), figures));
}

} // namespace demlua::scripting
