#include "tools/benchmark/machine.hpp"

#include "engine/step/kernels.hpp"
#include "tools/benchmark/batch.hpp"

#include <algorithm>
#include <vector>

namespace demlua::bench {

namespace {

constexpr std::size_t shared = 4096;          // rows that a team's loop is shared in: enough to wake every thread
constexpr std::size_t rounds_per_part = 2000; // some ten microseconds

RateLoops widest_loops() {
    switch (step::widest_kernels()) {
    case 8:
        return rate_loops_8();
    case 4:
        return rate_loops_4();
    default:
        return rate_loops_2();
    }
}

} // namespace

Machine::Machine(Team& team, std::size_t footprint) : team_(team), loops_(widest_loops()) {
    const std::size_t rows = std::max<std::size_t>(8, footprint / (3 * sizeof(double)) / 8 * 8);
    for (Column<double>* column : {&to_, &a_, &b_}) column->assign(rows, 1.0);
}

double Machine::bytes_per_second(double seconds) {
    const auto walk = [&] {
        team_.share(to_.size(),
                    [&](Share part) { loops_.triad(to_.data(), a_.data(), b_.data(), part.begin, part.end); });
    };
    return static_cast<double>(3 * sizeof(double) * to_.size()) / mean_time(seconds, walk);
}

double Machine::arithmetic_per_second(double seconds, double (*loop)(std::size_t)) {
    std::vector<double> kept(team_.parts());
    const auto compute = [&] { team_.share(shared, [&](Share part) { kept[part.part] = loop(rounds_per_part); }); };
    return static_cast<double>(loops_.per_round * rounds_per_part * team_.parts()) / mean_time(seconds, compute);
}

double Machine::multiply_adds_per_second(double seconds) { return arithmetic_per_second(seconds, loops_.multiply_add); }
double Machine::divisions_per_second(double seconds) { return arithmetic_per_second(seconds, loops_.divide); }

} // namespace demlua::bench
