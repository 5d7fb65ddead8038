// One work measured: set-up, memory, and steps in short batches.
#pragma once

#include "tools/benchmark/cost.hpp"
#include "tools/benchmark/works.hpp"

#include "engine/packing/pack_store.hpp"
#include "engine/state/state.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace demlua::bench {

/// Seconds of each stage from the scene to the first step.
struct SetUp {
    double assembly = 0.0;     ///< pack (irregular ones from the store), bonds, stiffness
    double time_step = 0.0;    ///< stable step, by the bound
    double first_forces = 0.0; ///< search and forces at the first instant
};

/// A work at its first instant.
struct Begun {
    std::unique_ptr<state::State> state = std::make_unique<state::State>();
    SetUp set_up;
};
Begun begin_of(const Work& work, const packing::PackStore* packs);

/// Times of one thread count, one entry of every column per round, taken one straight after the other.
struct Rounds {
    int threads = 1;
    std::vector<double> widest;   ///< s per step, as a run takes it
    std::vector<double> one_lane; ///< s per step, kernels of one row at a time
    std::vector<double> bytes;    ///< per second
    std::vector<double> multiply_adds;
    std::vector<double> divisions;
};

struct Measurement {
    std::size_t elements = 0;
    std::size_t bonds = 0;
    std::size_t touching = 0; ///< contacts between elements when the measuring ends
    std::uint64_t broken = 0;
    std::size_t lanes = 0;        ///< of the widest kernels
    double bytes_per_element = 0; ///< of memory that the program holds more than before, at the first step
    SetUp set_up;
    Cost cost;
    std::vector<Rounds> rounds; ///< one per thread count
};

/// Measures for about `seconds`; all thread counts and kinds of batches take turns.
Measurement measure(const Work& work, const std::vector<int>& threads, double seconds, const packing::PackStore* packs);

} // namespace demlua::bench
