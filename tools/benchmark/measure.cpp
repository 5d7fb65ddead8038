#include "tools/benchmark/measure.hpp"

#include "engine/state/assemble.hpp"
#include "engine/step/step.hpp"
#include "engine/step/time_step.hpp"
#include "tools/benchmark/batch.hpp"
#include "tools/benchmark/machine.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <memory>
#include <unistd.h>
#include <utility>
#include <variant>

namespace demlua::bench {

namespace {

constexpr double batch = 10e-3;     // s
constexpr double rate_batch = 2e-3; // s, of each of the machine's rates
constexpr std::size_t fewest_rounds = 5;

/// A state with threads of its own.
struct Running {
    Team team;
    state::State state;
    step::Stepper stepper;
    Machine machine;
    Rounds rounds;

    Running(int threads, const state::State& begin, double greatest_move, std::size_t footprint)
        : team(threads), state(begin), stepper(team, state, greatest_move), machine(team, footprint) {
        rounds.threads = threads;
        // Lists are made anew by the new stepper; forces and velocities are those of `begin`.
        step::refresh_contacts(state, stepper.search, stepper.team);
        const double dt = std::exchange(state.dt, 0.0);
        step::compute_forces(state, stepper);
        state.dt = dt;
    }

    double step_time(std::size_t width) {
        stepper.kernels = &step::kernels_of(width);
        return mean_time(batch, [&] { step::advance(state, stepper); });
    }

    void round() {
        rounds.widest.push_back(step_time(step::widest_kernels()));
        rounds.one_lane.push_back(step_time(1));
        rounds.bytes.push_back(machine.bytes_per_second(rate_batch));
        rounds.multiply_adds.push_back(machine.multiply_adds_per_second(rate_batch));
        rounds.divisions.push_back(machine.divisions_per_second(rate_batch));
    }
};

/// Bytes of memory that this program holds now.
double resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    double whole = 0.0;
    double resident = 0.0;
    statm >> whole >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void set_waves(state::Elements& elements, double speed) {
    for (std::size_t k = 0; k < elements.size(); ++k) {
        elements.vx[k] = speed * std::sin(7.0 * elements.reference_x[k]);
        elements.vy[k] = speed * std::cos(5.0 * elements.reference_y[k]);
    }
}

std::size_t bonds_of(const state::State& state) {
    std::size_t count = 0;
    for (const state::AnyBondSet& any : state.bond_sets) {
        count += std::visit([](const auto& bonds) { return bonds.size(); }, any);
    }
    return count;
}

std::size_t touching(const state::State& state) {
    std::size_t count = 0;
    for (std::size_t c = 0; c < state.contacts.size(); ++c) count += state.overlap(c) > 0.0 ? 1 : 0;
    return count;
}

void advance(state::State& state, const Work& work) {
    Team alone(1);
    step::Stepper stepper(alone, state, work.scene.greatest_move);
    step::refresh_contacts(state, stepper.search, stepper.team);
    for (std::uint64_t step = 0; step < work.steps_before; ++step) step::advance(state, stepper);
}

} // namespace

Begun begin_of(const Work& work, const packing::PackStore* packs) {
    Begun begun;
    begun.set_up.assembly = time_of([&] { *begun.state = state::assemble(work.scene, packs).state; });
    begun.set_up.time_step = time_of([&] {
        begun.state->dt = work.scene.step_fraction *
                          step::stable_step(*begun.state, model::StepRule::bound, work.scene.place).critical;
    });
    if (work.speed > 0.0) set_waves(begun.state->elements, work.speed);
    Team alone(1);
    step::Stepper stepper(alone, *begun.state, work.scene.greatest_move);
    begun.set_up.first_forces = time_of([&] { step::start(*begun.state, stepper); });
    return begun;
}

Measurement measure(const Work& work, const std::vector<int>& threads, double seconds,
                    const packing::PackStore* packs) {
    Measurement found;
    const double before = resident_bytes();
    const Begun begun = begin_of(work, packs);
    if (work.steps_before > 0) advance(*begun.state, work);
    const state::State& state = *begun.state;
    found.elements = state.elements.size();
    found.bonds = bonds_of(state);
    found.lanes = step::widest_kernels();
    found.bytes_per_element = (resident_bytes() - before) / static_cast<double>(found.elements);
    found.set_up = begun.set_up;
    {
        auto spoilt = std::make_unique<state::State>(state);
        found.cost = cost_of(*spoilt);
    }
    const auto footprint = static_cast<std::size_t>(found.cost.footprint * static_cast<double>(found.elements));
    std::vector<std::unique_ptr<Running>> all;
    all.reserve(threads.size());
    for (const int count : threads) {
        all.push_back(std::make_unique<Running>(count, state, work.scene.greatest_move, footprint));
    }
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t round = 0;; ++round) {
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        if (round >= fewest_rounds && taken.count() > seconds) break;
        for (const auto& running : all) running->round();
    }
    found.touching = touching(all.front()->state);
    found.broken = all.front()->state.cracks.size();
    for (const auto& running : all) found.rounds.push_back(running->rounds);
    return found;
}

} // namespace demlua::bench
