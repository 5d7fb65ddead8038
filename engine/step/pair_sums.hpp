// From forces in pairs to forces on elements.
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/elements.hpp"
#include "engine/state/pair_slots.hpp"
#include "engine/step/kernels.hpp"

namespace demlua::step {

/// Adds the forces of `pairs` to the elements of its slots. Each
/// element is summed by one thread in the order of its slots: the sum does not depend on the number of threads.
template <class Pairs>
void add_pair_forces(const Pairs& pairs, state::Elements& elements, const Kernels& kernels, Team& team) {
    const state::PairSlots& slots = pairs.slots;
    const PairSums sums{pairs.forces.rows(),
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
