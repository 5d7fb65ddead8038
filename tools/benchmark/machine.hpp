// What the machine itself can do: memory moved and arithmetic done per second.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/team.hpp"
#include "tools/benchmark/cost.hpp"

#include <cstddef>

namespace demlua::bench {

/// Loops for one width of registers. A round of the first two is `per_round` multiply-adds, or divisions; what they return
/// means nothing. `triad` is to = a + b/2 over [begin, end), both multiples of 8.
struct RateLoops {
    std::size_t per_round = 0;
    double (*multiply_add)(std::size_t rounds) = nullptr;
    double (*divide)(std::size_t rounds) = nullptr;
    void (*triad)(double* to, const double* a, const double* b, std::size_t begin, std::size_t end) = nullptr;
};
RateLoops rate_loops_2();
RateLoops rate_loops_4();
RateLoops rate_loops_8();

/// Rates found in about `seconds` of all threads of a team together.
class Machine {
public:
    /// `footprint`: bytes of memory to walk through, as many as the work that is compared touches.
    Machine(Team& team, std::size_t footprint);

    double bytes_per_second(double seconds);         ///< two lines read for one written
    double multiply_adds_per_second(double seconds); ///< fused where the machine can
    double divisions_per_second(double seconds);

private:
    double arithmetic_per_second(double seconds, double (*loop)(std::size_t));

    Team& team_;
    RateLoops loops_;
    Column<double> to_, a_, b_;
};

} // namespace demlua::bench
