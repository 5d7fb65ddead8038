// Facets that wake at a settled instant, by the stress of their cells. Nothing is decided by what else wakes: all that
// qualify wake together, in whatever order they are looked at.
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/elements.hpp"
#include "engine/step/cell_stress.hpp"
#include "engine/step/facet_forces.hpp"

namespace demlua::step {

/// Of the cell of one element, times the thickness, N/m; dashpots and contacts left out.
template <class Law>
PlaneStress cell_stress(const state::FacetSet<Law>& bonds, const state::Elements& elements, Index element) {
    PlaneStress sum;
    state::for_each_pair_of(bonds.slots, element, [&](std::size_t k, bool is_j) {
        if (bonds.is_broken(k)) return;
        const law::BondMotion<double>& motion = bonds.motion[k];
        const Vec2 n = motion.normal;
        const Vec2 f =
            bonds.normal[k] * n + (bonds.shear[k] * bonds.length[k] * motion.inverse_length) * turned_left(n);
        const FacetArms arms = facet_arms(bonds, k, n, 1.0 / motion.inverse_length);
        sum.add(is_j ? -f : f, is_j ? arms.of_j : arms.of_i);
    });
    return (1.0 / elements.cell_area[element]) * sum;
}

/// How far facet `k` has come to waking: 1 when it does; 0 while its own force is too small.
template <class Law>
double share_of_waking(const state::FacetSet<Law>& bonds, const state::Elements& elements, std::size_t k) {
    const law::BondForce<double> force{bonds.normal[k], bonds.shear[k]};
    if (!Law::may_wake(bonds.tractions, bonds.area[k], force)) return 0.0;
    const PlaneStress of_both = cell_stress(bonds, elements, bonds.i[k]) + cell_stress(bonds, elements, bonds.j[k]);
    return Law::waking(bonds.tractions, bonds.area[k], force, (0.5 * of_both).tension());
}

/// Wakes the dormant facets of one share that the law wakes under the forces of this instant.
template <class Law>
void wake_facets(state::FacetSet<Law>& bonds, const state::Elements& elements, const Kernels& kernels, Share part) {
    const SuspectRows<Law> rows = suspects_of(bonds);
    bool some = false;
    run_rows(kernels, part, [&](const Kernels& width, std::size_t begin, std::size_t end) {
        some |= std::get<FacetKernels<Law>>(width.bonds).mark_waking(rows, begin, end);
    });
    if (!some) return;
    for (std::size_t k = part.begin; k < part.end; ++k) {
        if (bonds.suspect[k] == 0) continue;
        auto history = bonds.history.at(k);
        if (history.cap > 0.0 || share_of_waking(bonds, elements, k) < 1.0) continue;
        history.cap = Law::pull(law::BondForce<double>{bonds.normal[k], bonds.shear[k]});
        bonds.remember(k, history);
    }
}

} // namespace demlua::step
