// The pairs of each element, laid out so that several elements can be summed at a time.
#pragma once

#include "engine/base/column.hpp"

#include <cstddef>

namespace demlua::state {

/// Elements from `first` on stand in blocks of 8. A block has as many slots as the element of it with most pairs: first
/// those in which elements are a pair's i, from start[2b] to start[2b + 1], then those in which they are its j, to
/// start[2b + 2]. row[8 slot + lane] names the pair of each element in the slot; `none` where it has none.
/// Sums are taken slot by slot, so they come out the same whoever takes them, however many at a time.
struct PairSlots {
    static constexpr std::size_t block = 8;

    std::size_t first = 0;
    std::size_t elements = 0;
    Index none = 0; ///< a row beyond those of pairs
    Column<Index> start;
    Column<Index> row;
};

/// Pairs (i[k], j[k]) over elements `first` to `first + count`; those of an element in rising order within either kind.
/// `none` is the row `spare` after the last.
PairSlots slots_of(const Column<Index>& i, const Column<Index>& j, std::size_t first, std::size_t count,
                   std::size_t spare = 0);

/// Calls `f(row, is_j)` for the pairs of `element`, a row of all elements, in the slots start[from] to start[to] of its block.
template <class F>
void for_each_in_slots(const PairSlots& slots, std::size_t element, std::size_t from, std::size_t to, const F& f) {
    constexpr std::size_t block = PairSlots::block;
    const std::size_t e = element - slots.first;
    const Index* start = slots.start.data() + 2 * (e / block);
    for (Index slot = start[from]; slot < start[to]; ++slot) {
        const Index row = slots.row[block * slot + e % block];
        if (row != slots.none) f(std::size_t{row}, slot >= start[1]);
    }
}

/// Calls `f(row, is_j)` for every pair of `element`, in the order in which sums are taken.
template <class F>
void for_each_pair_of(const PairSlots& slots, std::size_t element, const F& f) {
    for_each_in_slots(slots, element, 0, 2, f);
}

/// Calls `f(row)` for those of which `element` is the i.
template <class F>
void for_each_pair_from(const PairSlots& slots, std::size_t element, const F& f) {
    for_each_in_slots(slots, element, 0, 1, [&](std::size_t row, bool /*is_j*/) { f(row); });
}

} // namespace demlua::state
