// Columns as the inner loops of kernels read them: some rows at a time, in double precision, so that a loop over them asks
// of no column how it is kept.
#pragma once

#include "engine/base/number_column.hpp"

#include <algorithm>
#include <cstddef>

namespace demlua::step {

class Tile {
public:
    static constexpr std::size_t size = 64; ///< rows at most

    explicit Tile(const NumberRows& column) : column_(column) {
        if (column.wide == nullptr && column.narrow == nullptr) std::fill_n(kept_, size, column.same);
    }
    Tile(const Tile&) = delete;
    Tile& operator=(const Tile&) = delete;

    /// Rows [begin, end) of the column, until the next call.
    template <class Lane>
    const double* rows(std::size_t begin, std::size_t end) {
        if (column_.wide != nullptr) return column_.wide + begin;
        if (column_.narrow != nullptr) {
            for (std::size_t k = begin; k < end; k += Lane::width) {
                Lane::store(kept_ + (k - begin), Lane::load(column_.narrow + k));
            }
        }
        return kept_;
    }

private:
    NumberRows column_;
    alignas(64) double kept_[size];
};

/// The same of a column that is written, or read where another kernel writes it.
class TargetTile {
public:
    explicit TargetTile(const NumberTargets& column) : column_(column) {}
    TargetTile(const TargetTile&) = delete;
    TargetTile& operator=(const TargetTile&) = delete;

    /// Rows [begin, end) as they stand, until the next call.
    template <class Lane>
    double* rows(std::size_t begin, std::size_t end) {
        if (column_.wide != nullptr) return column_.wide + begin;
        for (std::size_t k = begin; k < end; k += Lane::width) {
            Lane::store(kept_ + (k - begin), Lane::load(column_.narrow + k));
        }
        return kept_;
    }
    /// To be called when these rows have been written.
    template <class Lane>
    void keep(std::size_t begin, std::size_t end) {
        if (column_.wide != nullptr) return;
        for (std::size_t k = begin; k < end; k += Lane::width) {
            Lane::store(column_.narrow + k, Lane::load(kept_ + (k - begin)));
        }
    }

private:
    NumberTargets column_;
    alignas(64) double kept_[Tile::size];
};

/// Calls `run(begin, end)` for rows [begin, end), a tile at a time.
template <class Run>
void tile_by_tile(std::size_t begin, std::size_t end, const Run& run) {
    for (; begin < end; begin += Tile::size) run(begin, begin + Tile::size < end ? begin + Tile::size : end);
}

} // namespace demlua::step
