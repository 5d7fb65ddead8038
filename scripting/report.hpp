// What a user is told of a scene before it runs and of a run when it is over.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/observe/simulation.hpp"
#include "scripting/host.hpp"
#include "scripting/script.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace demlua::scripting {

/// What an assembled scene is: title, counts, stages, time step and its reason, notes.
std::vector<std::string> scene_facts(const model::Scene& scene, const observe::Simulation& simulation);

/// "6 ms in 50,000 steps: about 30 s", from the number of elements at a typical cost of each.
std::string run_outlook(const observe::Simulation& simulation, double duration);

/// A scene that was only read, in one line.
std::string scene_in_a_line(const SceneSummary& scene);

/// What the runs of a scene took together.
struct Effort {
    std::uint64_t steps = 0;
    double wall_time = 0.0; ///< s
};

/// "6 ms in 50,000 steps, 24.1 s of wall time, 40 ns per element and step".
std::string effort_line(const observe::Simulation& simulation, const Effort& effort);

/// "profile, ns per element and step: bonds 12.1 (54 %), motion 5.0 (22 %), other 5.3 (24 %)": stages from samples, the longest
/// first; `other` is what the wall time holds beside them, such as output and the scene's functions.
std::string profile_line(const observe::Simulation& simulation, const Effort& effort);

/// Where the energy went, in shares, and what is unaccounted for.
std::string energy_line(const observe::Ledger& ledger);

/// Broken bonds, crack length and fragments; empty when no bond has broken.
std::string fracture_line(const observe::Simulation& simulation);

/// "results: name = value, ..."; empty when there are none.
std::string results_line(const std::vector<Result>& results);

/// "period: 0.12 s, expected 0.1201 s: -0.08 %, tolerance 0.2 %".
std::string comparison_line(const model::Comparison& comparison);

} // namespace demlua::scripting
