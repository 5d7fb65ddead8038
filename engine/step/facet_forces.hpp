// Forces across facets, written once over the law. Two passes: how cells grow, then, with their pressures, the forces.
// Where facets fail, plastic displacements and breaks are settled at the instant itself, so that the forces of the step
// derive from the energy the ledger knows.
#pragma once

#include "engine/state/free_wall.hpp"
#include "engine/step/bond_forces.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <vector>

namespace demlua::step {

/// Elastic part of q at the last computed instant.
template <class Law>
DEMLUA_INLINE law::FacetVector<double> strained(const state::FacetSet<Law>& bonds, const state::Elements& elements,
                                                std::size_t k) {
    const law::BondMotion<double> motion = bonds.motion[k];
    law::FacetVector<double> q{motion.stretch, motion.shear,
                               elements.rotation[bonds.j[k]] - elements.rotation[bonds.i[k]]};
    if constexpr (Law::yields) {
        const auto history = bonds.history.at(k);
        q.normal -= history.stretch;
        q.shear -= history.shear;
    }
    return q;
}

/// Normal force, shear force and bending moment, dashpots left out.
template <class Law>
DEMLUA_INLINE law::FacetVector<double> facet_force(const state::FacetSet<Law>& bonds, const state::Elements& elements,
                                                   std::size_t k) {
    const double p_i = bonds.pressure[bonds.i[k] - bonds.slots.first];
    const double p_j = bonds.pressure[bonds.j[k] - bonds.slots.first];
    return bonds.springs[k] * strained(bonds, elements, k) + p_i * bonds.growth_i[k] + p_j * bonds.growth_j[k];
}

template <class Law>
law::BondForce<double> held_force(const state::FacetSet<Law>& bonds, const state::Elements& elements, std::size_t k) {
    const law::FacetVector<double> force = facet_force(bonds, elements, k);
    return {force.normal, force.shear};
}

/// Energy in the facet's springs, the cells' left out.
template <class Law>
double stored_energy(const state::FacetSet<Law>& bonds, const state::Elements& elements, std::size_t k) {
    const law::FacetVector<double> q = strained(bonds, elements, k);
    return 0.5 * dot(q, bonds.springs[k] * q);
}

/// Energy of one cell under pressure p.
inline double cell_energy(double pressure, double pressure_per_growth) {
    return pressure_per_growth > 0.0 ? 0.5 * pressure * pressure / pressure_per_growth : 0.0;
}

template <class Law>
typename Law::Params params_of(const state::FacetSet<Law>& bonds, std::size_t k) {
    return Law::on_facet(bonds.tractions, bonds.yielding[k], bonds.area[k], bonds.radius[k]);
}

template <class Law>
void grow_cell_sides(state::FacetSet<Law>& bonds, const state::Elements& elements, std::size_t k) {
    const law::FacetVector<double> q = strained(bonds, elements, k);
    bonds.grown_i.set(k, dot(bonds.growth_i[k], q));
    bonds.grown_j.set(k, dot(bonds.growth_j[k], q));
}

template <class Law>
FacetRows rows_of(state::FacetSet<Law>& bonds) {
    FacetRows rows{};
    rows.i = bonds.i.data();
    rows.j = bonds.j.data();
    rows.Dx = bonds.Dx.rows();
    rows.Dy = bonds.Dy.rows();
    rows.length = bonds.length.rows();
    rows.inverse_length = bonds.inverse_length.rows();
    rows.share_i = bonds.share_i.rows();
    rows.twice_shear = bonds.twice_shear;
    rows.area = bonds.area.rows();
    rows.centre = bonds.centre.rows();
    rows.walled = bonds.walled.data();
    rows.springs = bonds.springs.begins();
    rows.growth_i = bonds.growth_i.begins();
    rows.growth_j = bonds.growth_j.begins();
    if constexpr (Law::yields) {
        using History = typename Law::template History<double>;
        if (bonds.remembers) {
            rows.plastic_stretch = bonds.history.template column<&History::stretch>().data();
            rows.plastic_shear = bonds.history.template column<&History::shear>().data();
        }
    }
    rows.inverse_d = bonds.motion.inverse_length.targets();
    rows.normal_x = bonds.motion.normal_x.targets();
    rows.normal_y = bonds.motion.normal_y.targets();
    rows.stretch = bonds.motion.stretch.targets();
    rows.shift = bonds.motion.shear.targets();
    rows.grown_i = bonds.grown_i.targets();
    rows.grown_j = bonds.grown_j.targets();
    rows.pressure = bonds.pressure.data() - bonds.slots.first;
    rows.Cn = bonds.dashpots.Cn.rows();
    rows.Ct = bonds.dashpots.Ct.rows();
    rows.dashpot_normal = bonds.dashpots.normal.data();
    rows.dashpot_shear = bonds.dashpots.shear.data();
    rows.spent = bonds.dashpots.spent.sums.data();
    rows.forces = bonds.forces.targets();
    if constexpr (Law::breaks) {
        rows.normal = bonds.normal.data();
        rows.shear = bonds.shear.data();
        rows.broken = bonds.broken.data();
    }
    return rows;
}

/// First pass over the bonds of one share.
template <class Law>
void measure_facets(state::FacetSet<Law>& bonds, const state::Elements& elements, const Kernels& kernels, Share part) {
    const FacetRows rows = rows_of(bonds);
    const ElementRows moving = rows_of(elements, bonds);
    run_rows(kernels, part, [&](const Kernels& width, std::size_t begin, std::size_t end) {
        width.measure_facets(rows, moving, begin, end);
    });
}

template <class Law>
CellRows cells_of(state::FacetSet<Law>& bonds) {
    return {bonds.grown_i.rows(),
            bonds.grown_j.rows(),
            bonds.slots.start.data(),
            bonds.slots.row.data(),
            bonds.pressure_per_growth.data(),
            bonds.pressure.data(),
            bonds.moved.empty() ? nullptr : bonds.moved.data()};
}

/// Pressures of the cells of one share from the growth of their sides.
template <class Law>
void press_cells(state::FacetSet<Law>& bonds, const Kernels& kernels, Share part) {
    const CellRows cells = cells_of(bonds);
    run_rows(kernels, part,
             [&](const Kernels& width, std::size_t begin, std::size_t end) { width.press_cells(cells, begin, end); });
}

/// Forces on the elements, from the motions and pressures there are; dashpots as they stand are added.
template <class Law>
void put_forces(state::FacetSet<Law>& bonds, const state::Elements& elements, const Kernels& kernels, Share part) {
    const FacetRows rows = rows_of(bonds);
    const ElementRows moving = rows_of(elements, bonds);
    const std::size_t damped = bonds.dashpots.present() ? 1 : 0;
    run_rows(kernels, part, [&](const Kernels& width, std::size_t begin, std::size_t end) {
        width.facet_forces[damped](rows, moving, begin, end);
    });
}

/// A facet beyond its strength: what it bore at the last instant, and its plastic state after.
template <class Law>
struct Failing {
    Index bond = 0;
    bool breaks = false;
    law::BondForce<double> borne;
    law::BondForce<double> moved; ///< plastic stretch and slip of this instant, m
    typename Law::template History<double> history;
};

template <class Law>
SuspectRows<Law> suspects_of(state::FacetSet<Law>& bonds) {
    return {bonds.tractions,
            bonds.normal.data(),
            bonds.shear.data(),
            bonds.area.rows(),
            bonds.radius.rows(),
            bonds.history.begins(),
            bonds.remembers || law::follows_rate<Law>,
            bonds.broken.data(),
            bonds.suspect.data()};
}

/// What facet `k`, under the forces of this instant, can no longer bear; nothing if it holds as it is.
template <class Law>
std::optional<Failing<Law>> failing_facet(const state::FacetSet<Law>& bonds, std::size_t k) {
    const law::ContactStiffness& spring = bonds.yielding[k];
    const auto before = bonds.history.at(k);
    auto history = before;
    law::BondMotion<double> motion;
    motion.stretch = bonds.normal[k] / spring.normal;
    motion.shear = bonds.shear[k] / spring.shear;
    if constexpr (Law::yields) {
        motion.stretch += before.stretch;
        motion.shear += before.shear;
    }
    const typename Law::Params params = params_of(bonds, k);
    Law::respond(params, 1.0, motion, history);
    const bool breaks = Law::broken(params, 1.0, motion, history);
    if (!breaks && !Law::has_yielded(before, history)) return std::nullopt;
    law::BondForce<double> moved{0.0, 0.0};
    if constexpr (Law::yields) {
        history.work = before.work;
        if constexpr (Law::wakes) history.damage = before.damage;
        moved = {history.stretch - before.stretch, history.shear - before.shear};
    }
    const law::BondForce<double> borne{bonds.normal_before[k], bonds.shear_before[k]};
    return Failing<Law>{static_cast<Index>(k), breaks, borne, moved, history};
}

/// Second pass over the bonds of one share. Bonds that yield are appended to `failing`, with the forces they cannot keep.
template <class Law>
void facet_forces(state::FacetSet<Law>& bonds, const state::Elements& elements, double dt, const Kernels& kernels,
                  Share part, std::vector<Failing<Law>>& failing) {
    if (bonds.dashpots.present()) {
        const FacetRows rows = rows_of(bonds);
        const ElementRows moving = rows_of(elements, bonds);
        run_rows(kernels, part, [&](const Kernels& width, std::size_t begin, std::size_t end) {
            width.facet_dashpots(rows, moving, dt, begin, end);
        });
    }
    put_forces(bonds, elements, kernels, part);
    if constexpr (Law::breaks) {
        const SuspectRows<Law> rows = suspects_of(bonds);
        bool some = false;
        run_rows(kernels, part, [&](const Kernels& width, std::size_t begin, std::size_t end) {
            some |= std::get<FacetKernels<Law>>(width.bonds).mark_suspects(rows, begin, end);
        });
        if (!some) return;
        for (std::size_t k = part.begin; k < part.end; ++k) {
            if (bonds.suspect[k] == 0) continue;
            if (std::optional<Failing<Law>> found = failing_facet(bonds, k)) failing.push_back(*found);
        }
    }
}

/// Brings the pressures of the cells beside `bonds_changed`, and the forces of all bonds of these cells, up to date.
template <class Law>
void refresh_around(state::FacetSet<Law>& bonds, const state::Elements& elements,
                    const std::vector<Index>& bonds_changed) {
    const std::size_t first = bonds.slots.first;
    std::vector<std::size_t> cells;
    for (const Index k : bonds_changed) {
        cells.push_back(bonds.i[k] - first);
        cells.push_back(bonds.j[k] - first);
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    const Kernels& one_by_one = kernels_of(1);
    for (const std::size_t e : cells) press_cells(bonds, one_by_one, {e, e + 1, 0});
    for (const std::size_t e : cells) {
        state::for_each_pair_of(bonds.slots, first + e, [&](std::size_t k, bool /*is_j*/) {
            put_forces(bonds, elements, one_by_one, {k, k + 1, 0});
        });
    }
}

/// Lets the failing facets yield and books their plastic work: the mean of the forces at both ends of the step times the
/// plastic displacement, which is what central difference takes out of motion and network together. Where a law breaks by
/// the work done, that is the work booked. Returns the bonds that break, in their order.
template <class Law>
std::vector<Index> settle_yielding(state::FacetSet<Law>& bonds, const state::Elements& elements,
                                   const std::vector<std::vector<Failing<Law>>>& parts) {
    std::vector<Failing<Law>> all;
    for (const std::vector<Failing<Law>>& part : parts) all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.bond < b.bond; });
    std::vector<Index> yielded;
    std::vector<Index> breaking;
    for (const Failing<Law>& failing : all) {
        bonds.remember(failing.bond, failing.history);
        grow_cell_sides(bonds, elements, failing.bond);
        yielded.push_back(failing.bond);
    }
    if constexpr (Law::yields) {
        refresh_around(bonds, elements, yielded);
        for (Failing<Law>& failing : all) {
            const std::size_t k = failing.bond;
            failing.history.work += 0.5 * ((failing.borne.normal + bonds.normal[k]) * failing.moved.normal +
                                           (failing.borne.shear + bonds.shear[k]) * failing.moved.shear);
            if constexpr (Law::wakes) {
                Law::wear(params_of(bonds, k), failing.history);
                failing.breaks = Law::broken(params_of(bonds, k), 1.0, bonds.motion[k], failing.history);
            }
            bonds.remember(k, failing.history);
        }
    }
    for (const Failing<Law>& failing : all) {
        if (failing.breaks) breaking.push_back(failing.bond);
    }
    return breaking;
}

/// How fast the cell of `element` grows with all its bonds but `k`, m^2/s.
template <class Law>
double growth_rate_without(const state::FacetSet<Law>& bonds, const state::Elements& elements, Index element,
                           std::size_t k) {
    double rate = 0.0;
    state::for_each_pair_of(bonds.slots, element, [&](std::size_t m, bool is_j) {
        if (m == k || bonds.is_broken(m)) return;
        const law::BondForce<double> speed = rates_of(bonds, elements, m, bonds.motion[m]);
        const double turning = elements.spin[bonds.j[m]] - elements.spin[bonds.i[m]];
        rate += dot(is_j ? bonds.growth_j[m] : bonds.growth_i[m],
                    law::FacetVector<double>{speed.normal, speed.shear, turning});
    });
    return rate;
}

/// Takes bond `k` out of its cells, leaves free walls there, and gives the energy that cells and springs lose: less what
/// the step that led here did not move under, since its forces count as the mean of those at both ends.
template <class Law>
double let_go(state::FacetSet<Law>& bonds, const state::Elements& elements, std::size_t k, double dt) {
    const std::array<Index, 2> sides{bonds.i[k], bonds.j[k]};
    const std::array<double, 2> grown{bonds.grown_i[k], bonds.grown_j[k]};
    std::array<double, 2> stiff{};
    std::array<double, 2> pressure{};
    double lost = stored_energy(bonds, elements, k);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t e = sides[side] - bonds.slots.first;
        stiff[side] = bonds.pressure_per_growth[e];
        pressure[side] = bonds.pressure[e];
    }
    bonds.grown_i.set(k, 0.0);
    bonds.grown_j.set(k, 0.0);
    state::free_wall(bonds, k);
    for (std::size_t side = 0; side < 2; ++side) {
        if (stiff[side] == 0.0) continue;
        const std::size_t e = sides[side] - bonds.slots.first;
        const double now = bonds.pressure_per_growth[e];
        bonds.pressure[e] = now * (pressure[side] / stiff[side] - grown[side]);
        lost += cell_energy(pressure[side], stiff[side]) - cell_energy(bonds.pressure[e], now);
        lost -= 0.5 * dt * (pressure[side] - bonds.pressure[e]) * growth_rate_without(bonds, elements, sides[side], k);
    }
    return lost;
}

} // namespace demlua::step
