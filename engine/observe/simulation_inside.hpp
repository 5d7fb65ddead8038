// What a simulation keeps beside its state; for the files that implement it.
#pragma once

#include "engine/observe/bond_probes.hpp"
#include "engine/observe/simulation.hpp"
#include "engine/state/state.hpp"
#include "engine/step/step.hpp"
#include "engine/step/time_step.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace demlua::observe {

/// The elements one motion of the scene drives, and its rows of State::drives.
struct Moved {
    Column<Index> elements;
    std::vector<std::size_t> drives;
};

/// How much of the scene has been taken in.
struct Taken {
    std::size_t supports = 0;
    std::size_t notches = 0;
    std::size_t dampings = 0;
    std::vector<Moved> motions;
    std::vector<std::size_t> forces;    ///< their rows of State::loads
    std::vector<std::size_t> tractions; ///< likewise
    std::vector<ProbedBond> probed;     ///< by row of the scene's bond probes
};

/// As many threads as asked for, or as there is work for when `asked` is 0.
int thread_count(int asked, std::size_t elements);

struct Simulation::Inside {
    model::Scene scene;
    Team team;
    step::Stepper stepper;
    std::vector<std::string> notes;
    Taken taken;
    double beta = 0.0; ///< of the dashpots laid beside the bonds, s
    step::StableStep stable;
    bool step_outdated = true;
    bool started = false;
    double balance_at_start = 0.0;
    bool stopping = false;
    std::string stop_reason;

    Inside(const model::Scene& said, Threads threads, const state::State& state, std::vector<std::string> facts)
        : scene(said), team({thread_count(threads.count, state.elements.size()), threads.shortest_shared_loop}),
          stepper(team, state, said.greatest_move), notes(std::move(facts)) {
        stepper.domain = said.domain;
    }

    /// Notes, once for each pair, outlines that lie across what moves as given like them.
    void note_passing(const state::State& state);

    /// Where what moves freely has changed: has the step found anew before the next run, and takes a shorter one at once if a run
    /// is under way and needs it.
    void shorten_step(state::State& state);

private:
    std::set<std::pair<std::size_t, std::size_t>> passing_; ///< pairs of State::walls that have been noted
};

} // namespace demlua::observe
