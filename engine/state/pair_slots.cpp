#include "engine/state/pair_slots.hpp"

#include <algorithm>
#include <array>

namespace demlua::state {

PairSlots slots_of(const Column<Index>& i, const Column<Index>& j, std::size_t first, std::size_t count,
                   std::size_t spare) {
    constexpr std::size_t block = PairSlots::block;
    const std::size_t blocks = (count + block - 1) / block;
    const std::array<const Column<Index>*, 2> ends{&i, &j};

    PairSlots slots;
    slots.first = first;
    slots.elements = count;
    slots.none = static_cast<Index>(i.size() + spare);
    slots.start.assign(2 * blocks + 1, 0);
    std::array<Column<Index>, 2> taken{Column<Index>(count, 0), Column<Index>(count, 0)};
    for (std::size_t end = 0; end < 2; ++end) {
        for (const Index element : *ends[end]) {
            Index& widest = slots.start[2 * ((element - first) / block) + end + 1];
            widest = std::max(widest, ++taken[end][element - first]);
        }
        std::fill(taken[end].begin(), taken[end].end(), 0);
    }
    for (std::size_t k = 1; k < slots.start.size(); ++k) slots.start[k] += slots.start[k - 1];

    slots.row.assign(block * slots.start.back(), slots.none);
    for (std::size_t end = 0; end < 2; ++end) {
        for (std::size_t k = 0; k < i.size(); ++k) {
            const std::size_t e = (*ends[end])[k] - first;
            const std::size_t slot = slots.start[2 * (e / block) + end] + taken[end][e]++;
            slots.row[block * slot + e % block] = static_cast<Index>(k);
        }
    }
    return slots;
}

} // namespace demlua::state
