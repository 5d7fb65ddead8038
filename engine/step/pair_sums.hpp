// From forces in pairs to forces on elements.
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/bonds.hpp"
#include "engine/state/elements.hpp"
#include "engine/step/kernels.hpp"

namespace demlua::step {

/// Adds the forces of `pairs` (fx, fy on i, the opposite on j; moment_i, moment_j) to the elements of its incidence.
/// Each element is summed by one thread in the order of its list: the sum does not depend on the number of threads.
template <class Pairs>
void add_pair_forces(const Pairs& pairs, state::Elements& elements, Team& team) {
    const state::Incidence& incidence = pairs.incidence;
    team.share(incidence.start.size() - 1, [&](Share part) {
        for (std::size_t e = part.begin; e < part.end; ++e) {
            if (incidence.start[e] == incidence.start[e + 1]) continue;
            double fx = 0.0;
            double fy = 0.0;
            double moment = 0.0;
            for (Index entry = incidence.start[e]; entry < incidence.start[e + 1]; ++entry) {
                const Index end = incidence.end[entry];
                const std::size_t pair = end / 2;
                const bool is_j = (end & 1U) != 0;
                fx += is_j ? -pairs.fx[pair] : pairs.fx[pair];
                fy += is_j ? -pairs.fy[pair] : pairs.fy[pair];
                moment += is_j ? pairs.moment_j[pair] : pairs.moment_i[pair];
            }
            const std::size_t k = incidence.first + e;
            elements.fx[k] += fx;
            elements.fy[k] += fy;
            elements.moment[k] += moment;
        }
    });
}

/// The same for bonds, several elements at a time.
template <class Law>
void add_bond_forces(const state::BondTable<Law>& bonds, state::Elements& elements, const Kernels& kernels,
                     Team& team) {
    const state::PairSlots& slots = bonds.slots;
    const PairSums sums{bonds.fx.data(),
                        bonds.fy.data(),
                        bonds.moment_i.data(),
                        bonds.moment_j.data(),
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
