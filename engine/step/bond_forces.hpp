// Forces in bonds, written once over the law.
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/bonds.hpp"
#include "engine/state/elements.hpp"
#include "engine/step/kernels.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace demlua::step {

/// Kinematics of one bond in the present configuration.
template <class Law>
DEMLUA_INLINE law::BondMotion<double> motion_of(const state::BondTable<Law>& bonds, const state::Elements& elements,
                                                std::size_t k) {
    const ElementRows rows = rows_of(elements);
    const EndMotions<double> ends =
        end_motions(displacements<OneLane>(rows, &bonds.i[k]), displacements<OneLane>(rows, &bonds.j[k]),
                    OneLane::Held(nullptr), bonds.share_i[k]);
    return law::bond_motion(Vec2{bonds.Dx[k], bonds.Dy[k]}, bonds.length[k], bonds.inverse_length[k], ends.du,
                            ends.turn);
}

/// Speeds at which a bond stretches and shears, m/s, from the velocities of the last half step.
template <class Law>
law::BondForce<double> rates_of(const state::BondTable<Law>& bonds, const state::Elements& elements, std::size_t k,
                                const law::BondMotion<double>& motion) {
    const ElementRows rows = rows_of(elements);
    return rates(velocities<OneLane>(rows, &bonds.i[k]), velocities<OneLane>(rows, &bonds.j[k]), motion.normal,
                 motion.inverse_length, bonds.length[k], bonds.share_i[k]);
}

template <class Law>
typename Law::Params params_of(const state::BondSet<Law>& bonds, std::size_t /*k*/) {
    return bonds.params;
}

/// The radius a law is asked with: the bond's own, or 1 for a facet, whose Params are its own.
template <class Law>
double law_radius(const state::BondSet<Law>& bonds, std::size_t k) {
    return bonds.radius[k];
}
template <class Law>
double law_radius(const state::FacetSet<Law>& /*bonds*/, std::size_t /*k*/) {
    return 1.0;
}

/// Force of the springs at the present instant, N.
template <class Law>
law::BondForce<double> held_force(const state::BondSet<Law>& bonds, const state::Elements& elements, std::size_t k) {
    auto history = bonds.history.at(k);
    return Law::respond(bonds.params, bonds.radius[k], motion_of(bonds, elements, k), history);
}

/// Energy in the springs at the present instant, J.
template <class Law>
double stored_energy(const state::BondSet<Law>& bonds, const state::Elements& elements, std::size_t k) {
    return Law::stored_energy(bonds.params, motion_of(bonds, elements, k), bonds.history.at(k));
}

/// Calls `fill(columns, quads)` for what the bonds of a body keep of its elements in quads, if they do.
template <class Law, class Fill>
void for_each_quads(state::BondTable<Law>& bonds, const state::Elements& elements, const Fill& fill) {
    const auto from = [&](const Column<double>& column) { return column.data() + bonds.slots.first; };
    const auto columns = [&](const Column<double>& x, const Column<double>& y, const Column<double>& turn) {
        return std::array{from(x), from(y), from(turn)};
    };
    if (!bonds.moved.empty()) fill(columns(elements.ux, elements.uy, elements.rotation), bonds.moved.data());
    if (!bonds.speeds.empty()) fill(columns(elements.vx, elements.vy, elements.spin), bonds.speeds.data());
}

/// Brings them up to date.
template <class Law>
void refresh_quads(state::BondTable<Law>& bonds, const state::Elements& elements, const Kernels& kernels, Team& team) {
    if (bonds.moved.empty()) return;
    team.share(bonds.slots.elements, [&](Share part) {
        run_rows(kernels, part, [&](const Kernels& width, std::size_t begin, std::size_t end) {
            for_each_quads(bonds, elements,
                           [&](const auto& columns, double* quads) { width.fill_quads(columns, quads, begin, end); });
        });
    });
}

/// Fills the forces of the bonds of one share. Bonds that are to break are marked so and left for settle_broken.
template <class Law>
Happened bond_forces(state::BondSet<Law>& bonds, const state::Elements& elements, double dt, Share part,
                     const Kernels& kernels) {
    const BondRows<Law> rows = rows_of(bonds);
    const ElementRows moving = rows_of(elements, bonds);
    Happened happened;
    const bool fits = std::get<PairKernels<Law>>(kernels.bonds).plain != nullptr;
    run_rows(fits ? kernels : kernels_of(1), part, [&](const Kernels& width, std::size_t begin, std::size_t end) {
        const auto& kernel = std::get<PairKernels<Law>>(width.bonds);
        happened |= (bonds.dashpots.present() ? kernel.damped : kernel.plain)(rows, moving, dt, begin, end);
    });
    return happened;
}

/// Rows marked as failing, rising.
template <class Law>
std::vector<Index> failing_rows(const state::BondTable<Law>& bonds) {
    std::vector<Index> rows;
    const auto& marks = bonds.broken;
    for (auto at = std::find(marks.begin(), marks.end(), state::failing); at != marks.end();
         at = std::find(at + 1, marks.end(), state::failing)) {
        rows.push_back(static_cast<Index>(at - marks.begin()));
    }
    return rows;
}

} // namespace demlua::step
