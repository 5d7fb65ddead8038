#include "scripting/report.hpp"

#include "engine/study/convergence.hpp"
#include "scripting/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace demlua::scripting {

namespace {

/// A bonded element on one core, contacts and output included: good for the order of magnitude only, the progress line
/// measures.
constexpr double typical_cost = 200e-9; // s per element and step
/// Shares below this are left out of the energy line.
constexpr double least_share = 0.005;

std::string text_of(const std::variant<double, bool, std::string>& value) {
    if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.6g}", *number);
    if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "true" : "false";
    return std::get<std::string>(value);
}

} // namespace

std::vector<std::string> scene_facts(const model::Scene& scene, const observe::Simulation& simulation) {
    std::vector<std::string> lines;
    if (!scene.title.empty()) lines.push_back(scene.title);
    lines.push_back(fmt::format("{}, {}, {}", counted(simulation.element_count(), "element"),
                                counted(simulation.bond_count(), "bond"),
                                counted(static_cast<std::uint64_t>(simulation.threads()), "thread")));
    lines.push_back(simulation.schedule());
    lines.push_back(
        fmt::format("time step {}: {}", with_prefix(simulation.time_step(), "s"), simulation.time_step_reason()));
    for (auto& note : simulation.notes()) lines.push_back(std::move(note));
    return lines;
}

std::string run_outlook(const observe::Simulation& simulation, double duration) {
    // A quotient that rounding has put just above a whole number is that number.
    const double steps = std::ceil(duration / simulation.time_step() * (1.0 - 1e-9));
    const auto elements = static_cast<double>(simulation.element_count());
    const double estimate = steps * elements * typical_cost / simulation.threads();
    return fmt::format("{} in {}: about {}", with_prefix(duration, "s"),
                       counted(static_cast<std::uint64_t>(steps), "step"), scripting::duration(estimate));
}

std::string scene_in_a_line(const SceneSummary& scene) {
    std::string line = scene.scene.title.empty() ? "untitled" : scene.scene.title;
    const std::size_t bodies = scene.scene.bodies.size();
    line += fmt::format(": {} {}, {}, {}", bodies, bodies == 1 ? "body" : "bodies",
                        counted(scene.scene.walls.size(), "wall"), counted(scene.runs.size(), "run"));
    if (scene.runs.empty()) return line;
    double total = 0.0;
    for (const auto& run : scene.runs) total += run.duration;
    return line + fmt::format(" of {} together", with_prefix(total, "s"));
}

std::string effort_line(const observe::Simulation& simulation, const Effort& effort) {
    std::string line = fmt::format("{} in {}, {} of wall time", with_prefix(simulation.time(), "s"),
                                   counted(effort.steps, "step"), duration(effort.wall_time));
    const double element_steps = static_cast<double>(effort.steps) * static_cast<double>(simulation.element_count());
    if (element_steps == 0.0) return line;
    return line + fmt::format(", {:.1f} ns per element and step", effort.wall_time / element_steps * 1e9);
}

std::string profile_line(const observe::Simulation& simulation, const Effort& effort) {
    const double element_steps = static_cast<double>(effort.steps) * static_cast<double>(simulation.element_count());
    if (element_steps == 0.0) return "profile: no steps";
    std::vector<observe::StageTime> times = simulation.stage_times();
    double rest = effort.wall_time;
    for (const observe::StageTime& time : times) rest -= time.seconds;
    std::stable_sort(times.begin(), times.end(), [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
    times.push_back({"other", std::max(rest, 0.0)});
    std::vector<std::string> parts;
    parts.reserve(times.size());
    for (const observe::StageTime& time : times) {
        parts.push_back(fmt::format("{} {:.1f} ({:.0f} %)", time.stage, time.seconds / element_steps * 1e9,
                                    100.0 * time.seconds / effort.wall_time));
    }
    return fmt::format("profile, ns per element and step: {}", fmt::join(parts, ", "));
}

std::string energy_line(const observe::Ledger& ledger) {
    const std::vector<std::pair<const char*, double>> parts{{"kinetic", ledger.kinetic},
                                                            {"bonds", ledger.bonds},
                                                            {"contacts", ledger.contacts},
                                                            {"gravity", ledger.potential},
                                                            {"plastic", ledger.plastic},
                                                            {"fracture", ledger.fracture},
                                                            {"friction", ledger.friction},
                                                            {"bond damping", ledger.bond_damping},
                                                            {"contact damping", ledger.contact_damping},
                                                            {"mass damping", ledger.mass_damping},
                                                            {"removed", ledger.removed}};
    double whole = 0.0;
    for (const auto& part : parts) whole += std::abs(part.second);
    // With nothing left anywhere, what the loads put in and took out again is the measure.
    whole = std::max(whole, std::abs(ledger.work));
    if (whole == 0.0) return "energy: none";
    std::string line = fmt::format("energy {}:", with_prefix(whole, "J"));
    for (const auto& [name, value] : parts) {
        if (std::abs(value) >= least_share * whole) line += fmt::format(" {} {:.0f} %,", name, 100.0 * value / whole);
    }
    return line + fmt::format(" unaccounted {:.2g} %", 100.0 * ledger.error / whole);
}

std::string fracture_line(const observe::Simulation& simulation) {
    const std::size_t broken = simulation.broken_bonds();
    if (broken == 0) return {};
    return fmt::format("{}, crack length {:.4g} m, {}", counted(broken, "broken bond"), simulation.crack_length(),
                       counted(simulation.fragments(), "fragment"));
}

std::string results_line(const std::vector<Result>& results) {
    std::string line;
    for (const auto& [name, value] : results) {
        line += fmt::format("{}{} = {}", line.empty() ? "results: " : ", ", name, text_of(value));
    }
    return line;
}

std::string comparison_line(const model::Comparison& comparison) {
    const std::string unit = comparison.unit.empty() ? "" : " " + comparison.unit;
    const auto error_text = [&](const char* format, double error) {
        return comparison.reference == 0.0 ? fmt::format(fmt::runtime(format), error) + unit
                                           : fmt::format(fmt::runtime(format), 100.0 * error) + " %";
    };
    std::string line = fmt::format(
        "{}: {:.6g}{}, expected {:.6g}{}: {}", comparison.what, comparison.value, unit, comparison.reference, unit,
        error_text("{:+.3g}", study::relative_error(comparison.value, comparison.reference)));
    if (comparison.tolerance) line += ", tolerance " + error_text("{:.3g}", *comparison.tolerance);
    return line;
}

} // namespace demlua::scripting
