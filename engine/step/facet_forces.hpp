// Forces across facets, written once over the law. Two passes: how cells grow, then, with their pressures, the forces.
// Where facets fail, plastic displacements and breaks are settled at the instant itself, so that the forces of the step
// derive from the energy the ledger knows.
#pragma once

#include "engine/state/free_wall.hpp"
#include "engine/step/bond_forces.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace demlua::step {

/// Elastic part of q at the last computed instant.
template <class Law>
DEMLUA_INLINE law::FacetVector<double> strained(const state::FacetSet<Law>& bonds, const state::Elements& elements,
                                                std::size_t k) {
    const law::BondMotion<double>& motion = bonds.motion[k];
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
    const double p_i = bonds.pressure[bonds.i[k] - bonds.incidence.first];
    const double p_j = bonds.pressure[bonds.j[k] - bonds.incidence.first];
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
    bonds.grown_i[k] = dot(bonds.growth_i[k], q);
    bonds.grown_j[k] = dot(bonds.growth_j[k], q);
}

/// First pass over the bonds of one share.
template <class Law>
void measure_facets(state::FacetSet<Law>& bonds, const state::Elements& elements, Share part) {
    for (std::size_t k = part.begin; k < part.end; ++k) {
        if (bonds.is_broken(k)) continue;
        bonds.motion[k] = motion_of(bonds, elements, k);
        grow_cell_sides(bonds, elements, k);
    }
}

/// Pressure of cell `e` from the growth of its sides, summed in the order of its list.
template <class Law>
void press_cell(state::FacetSet<Law>& bonds, std::size_t e) {
    const state::Incidence& incidence = bonds.incidence;
    double grown = 0.0;
    for (Index entry = incidence.start[e]; entry < incidence.start[e + 1]; ++entry) {
        const Index end = incidence.end[entry];
        grown += (end & 1U) != 0 ? bonds.grown_j[end / 2] : bonds.grown_i[end / 2];
    }
    bonds.pressure[e] = bonds.pressure_per_growth[e] * grown;
}

/// Writes the force on the elements of bond `k`; dashpot forces as they stand are added.
template <class Law>
DEMLUA_INLINE void put_force(state::FacetSet<Law>& bonds, std::size_t k, law::FacetVector<double> force) {
    if constexpr (Law::breaks) {
        bonds.normal[k] = force.normal;
        bonds.shear[k] = force.shear;
    }
    if (bonds.dashpots.present()) {
        force.normal += bonds.dashpots.normal[k];
        force.shear += bonds.dashpots.shear[k];
    }
    const law::BondMotion<double>& motion = bonds.motion[k];
    const double couple = force.shear * bonds.length[k];
    const Vec2 f = force.normal * motion.normal + (couple * motion.inverse_length) * turned_left(motion.normal);
    bonds.fx[k] = f.x;
    bonds.fy[k] = f.y;
    bonds.moment_i[k] = couple * bonds.share_i[k] + force.turn;
    bonds.moment_j[k] = couple * (1.0 - bonds.share_i[k]) - force.turn;
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

/// Second pass over the bonds of one share. Bonds that yield are appended to `failing`, with the forces they cannot keep.
template <class Law>
void facet_forces(state::FacetSet<Law>& bonds, const state::Elements& elements, double dt, Share part,
                  std::vector<Failing<Law>>& failing) {
    const bool damped = bonds.dashpots.present();
    for (std::size_t k = part.begin; k < part.end; ++k) {
        if (bonds.is_broken(k)) continue;
        const law::FacetVector<double> force = facet_force(bonds, elements, k);
        if (damped) {
            law::BondForce<double> dashpots{0.0, 0.0};
            add_dashpots(bonds, k, rates_of(bonds, elements, k, bonds.motion[k]), dt, dashpots);
        }
        if constexpr (Law::breaks) {
            const law::BondForce<double> borne{bonds.normal[k], bonds.shear[k]};
            put_force(bonds, k, force);
            const law::ContactStiffness& spring = bonds.yielding[k];
            const auto before = bonds.history.at(k);
            auto history = before;
            law::BondMotion<double> motion;
            motion.stretch = force.normal / spring.normal;
            motion.shear = force.shear / spring.shear;
            if constexpr (Law::yields) {
                motion.stretch += before.stretch;
                motion.shear += before.shear;
            }
            const typename Law::Params params = params_of(bonds, k);
            Law::respond(params, 1.0, motion, history);
            const bool breaks = Law::broken(params, 1.0, motion, history);
            if (!breaks && !Law::has_yielded(before, history)) continue;
            law::BondForce<double> moved{0.0, 0.0};
            if constexpr (Law::yields) {
                history.work = before.work;
                if constexpr (Law::wakes) history.damage = before.damage;
                moved = {history.stretch - before.stretch, history.shear - before.shear};
            }
            failing.push_back({static_cast<Index>(k), breaks, borne, moved, history});
        } else {
            put_force(bonds, k, force);
        }
    }
}

/// Brings the pressures of the cells beside `bonds_changed`, and the forces of all bonds of these cells, up to date.
template <class Law>
void refresh_around(state::FacetSet<Law>& bonds, const state::Elements& elements,
                    const std::vector<Index>& bonds_changed) {
    const state::Incidence& incidence = bonds.incidence;
    std::vector<std::size_t> cells;
    for (const Index k : bonds_changed) {
        cells.push_back(bonds.i[k] - incidence.first);
        cells.push_back(bonds.j[k] - incidence.first);
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    for (const std::size_t e : cells) press_cell(bonds, e);
    for (const std::size_t e : cells) {
        for (Index entry = incidence.start[e]; entry < incidence.start[e + 1]; ++entry) {
            const std::size_t k = incidence.end[entry] / 2;
            if (!bonds.is_broken(k)) put_force(bonds, k, facet_force(bonds, elements, k));
        }
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
    std::vector<Index> yielded;
    std::vector<Index> breaking;
    for (const Failing<Law>& failing : all) {
        bonds.history.store(failing.bond, failing.history);
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
            bonds.history.store(k, failing.history);
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
    const state::Incidence& incidence = bonds.incidence;
    const std::size_t e = element - incidence.first;
    double rate = 0.0;
    for (Index entry = incidence.start[e]; entry < incidence.start[e + 1]; ++entry) {
        const std::size_t m = incidence.end[entry] / 2;
        if (m == k || bonds.is_broken(m)) continue;
        const law::BondForce<double> speed = rates_of(bonds, elements, m, bonds.motion[m]);
        const double turning = elements.spin[bonds.j[m]] - elements.spin[bonds.i[m]];
        const bool is_j = (incidence.end[entry] & 1U) != 0;
        rate += dot(is_j ? bonds.growth_j[m] : bonds.growth_i[m],
                    law::FacetVector<double>{speed.normal, speed.shear, turning});
    }
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
        const std::size_t e = sides[side] - bonds.incidence.first;
        stiff[side] = bonds.pressure_per_growth[e];
        pressure[side] = bonds.pressure[e];
    }
    bonds.grown_i[k] = bonds.grown_j[k] = 0.0;
    state::free_wall(bonds, k);
    for (std::size_t side = 0; side < 2; ++side) {
        if (stiff[side] == 0.0) continue;
        const std::size_t e = sides[side] - bonds.incidence.first;
        const double now = bonds.pressure_per_growth[e];
        bonds.pressure[e] = now * (pressure[side] / stiff[side] - grown[side]);
        lost += cell_energy(pressure[side], stiff[side]) - cell_energy(bonds.pressure[e], now);
        lost -= 0.5 * dt * (pressure[side] - bonds.pressure[e]) * growth_rate_without(bonds, elements, sides[side], k);
    }
    return lost;
}

} // namespace demlua::step
