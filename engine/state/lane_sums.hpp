// A sum over rows that comes out the same however many rows a loop takes at a time.
#pragma once

#include "engine/base/column.hpp"

#include <cstddef>
#include <numeric>

namespace demlua::state {

/// Each run of 64 rows has eight sums, for every eighth row of it: a loop adds a row to the one at `place(row)`. Loops may be
/// shared between threads at multiples of 64 rows. A loop of several rows at a time begins at multiples of their number.
struct LaneSums {
    static constexpr std::size_t run = 64;
    static constexpr std::size_t lanes = 8;
    Column<double> sums;

    void cover(std::size_t rows) { sums.resize((rows + run - 1) / run * lanes); }
    static constexpr std::size_t place(std::size_t row) { return row / run * lanes + row % lanes; }
    [[nodiscard]] double total() const { return std::accumulate(sums.begin(), sums.end(), 0.0); }
};

} // namespace demlua::state
