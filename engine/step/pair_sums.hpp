// From forces in pairs to forces on elements.
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/elements.hpp"
#include "engine/state/pair_slots.hpp"
#include "engine/step/kernels.hpp"

namespace demlua::step {

inline NumberRows rows_of(const Column<double>& column) { return {column.data(), nullptr, 0.0}; }
inline NumberRows rows_of(const NumberColumn& column) { return column.rows(); }

/// Adds the forces of `pairs` (fx, fy on i, the opposite on j; moment_i, moment_j) to the elements of its slots. Each
/// element is summed by one thread in the order of its slots: the sum does not depend on the number of threads.
template <class Pairs>
void add_pair_forces(const Pairs& pairs, state::Elements& elements, const Kernels& kernels, Team& team) {
    const state::PairSlots& slots = pairs.slots;
    const PairSums sums{rows_of(pairs.fx),
                        rows_of(pairs.fy),
                        rows_of(pairs.moment_i),
                        rows_of(pairs.moments_of_j()),
                        slots.start.data(),
                        slots.row.data(),
                        elements.fx.data() + slots.first,
                        elements.fy.data() + slots.first,
                        elements.moment.data() + slots.first};
    team.share(slots.elements, [&](Share part) {
        run_rows(kernels, part,
                 [&](const Kernels& width, std::size_t begin, std::size_t end) { width.sum_pairs(sums, begin, end); });
    });
}

} // namespace demlua::step
