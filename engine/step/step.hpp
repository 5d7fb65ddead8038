// One time step.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/base/team.hpp"
#include "engine/model/region.hpp"
#include "engine/state/state.hpp"
#include "engine/step/contact_audit.hpp"
#include "engine/step/kernels.hpp"
#include "engine/step/motion.hpp"
#include "engine/step/search.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace demlua::step {

/// Stages in the order they run, for the clock and the schedule line.
enum class Stage { motion, bonds, contacts, walls, loads, rigid, search, wear };
inline constexpr std::array<const char*, 8> stage_names{"motion", "bonds", "contacts", "walls",
                                                        "loads",  "rigid", "search",   "wear"};

/// Seconds spent in each stage, from every 16th step; of searches, which are rare and long, from all.
class Clock {
public:
    static constexpr std::uint64_t sampled_every = 16;
    std::array<double, stage_names.size()> seconds{};

    template <class Work>
    void time(std::uint64_t step, Stage stage, const Work& work);
};

/// What a step works with beside the state.
struct Stepper {
    Team& team;
    const Kernels* kernels;
    Search search;
    TravelLimit limit;
    model::Region domain;   ///< elements that leave it are taken out; empty where nothing can leave
    Column<double> records; ///< of elements, as contacts see them; empty while there are no contacts
    ContactAudit audit;     ///< of debug builds
    bool cut = false;       ///< whether bonds have been marked to break at this instant
    Clock clock;

    Stepper(Team& threads, const state::State& state, double greatest_share);
};

/// Forces at the present instant, from positions there and velocities half a step before; without drives.
void compute_forces(state::State& state, Stepper& stepper);

/// The same where clear_forces has been called already.
void add_forces(state::State& state, Stepper& stepper);

/// Forces for a state that has just been assembled, and its velocities taken from the instant to half a step before it.
void start(state::State& state, Stepper& stepper);

/// Takes velocities to half a step before the instant for another step length.
void change_step(state::State& state, double dt);

/// Kick, drift, forces: from one settled instant to the next. Throws RunError naming the element when one moves too far.
void advance(state::State& state, Stepper& stepper);

/// `step: bonds[plateau] > contacts[coulomb] > ...; unused: ...`
std::string schedule_line(const state::State& state);

} // namespace demlua::step
