// What bonds across facets have beside what all bonds have.
#pragma once

#include "engine/bonding/facets.hpp"
#include "engine/state/bonds.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace demlua::state {

/// Stiffness that facet k meets when all facets of both its cells yield together: the sum of its row, magnitudes taken,
/// so that facets that yield at once do not let go of more than they must.
template <class Law>
law::ContactStiffness row_stiffness(const FacetSet<Law>& bonds, const std::vector<double>& grown, std::size_t k) {
    const auto coupled = [&](Index element, double own) {
        const std::size_t e = element - bonds.slots.first;
        return bonds.pressure_per_growth[e] * std::abs(own) * grown[e];
    };
    const law::FacetVector<double>& g_i = bonds.growth_i[k];
    const law::FacetVector<double>& g_j = bonds.growth_j[k];
    const law::FacetSprings<double>& K = bonds.springs[k];
    return {K.nn + std::abs(K.nt) + coupled(bonds.i[k], g_i.normal) + coupled(bonds.j[k], g_j.normal),
            K.tt + std::abs(K.nt) + coupled(bonds.i[k], g_i.shear) + coupled(bonds.j[k], g_j.shear)};
}

template <class Law>
void find_yielding_stiffness(FacetSet<Law>& bonds) {
    std::vector<double> grown(bonds.pressure_per_growth.size());
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        grown[bonds.i[k] - bonds.slots.first] += std::abs(bonds.growth_i[k].normal) + std::abs(bonds.growth_i[k].shear);
        grown[bonds.j[k] - bonds.slots.first] += std::abs(bonds.growth_j[k].normal) + std::abs(bonds.growth_j[k].shear);
    }
    for (std::size_t k = 0; k < bonds.size(); ++k) bonds.yielding.push_back(row_stiffness(bonds, grown, k));
}

/// To the last bit what loops make of area and centre, so that it does not matter which of the two they take.
template <class Law>
void fill_springs(FacetSet<Law>& bonds) {
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        if (bonds.walled[k] != 0) continue;
        const double A = bonds.area[k];
        const double c = bonds.centre[k];
        const double per_length = bonds.inverse_length[k];
        bonds.springs.store(k, law::facet_springs(bonds.twice_shear, A, c, per_length));
        bonds.growth_i.store(k, law::growth_of_i(A, c, per_length, bonds.share_i[k]));
        bonds.growth_j.store(k, law::growth_of_j(A, c, per_length, bonds.share_i[k]));
    }
}

/// Fills the columns of facets for bonds that have been laid out in the network's order. `thickness` in m; `single`: in
/// single precision.
template <class Law>
void fill_facets(FacetSet<Law>& bonds, const bonding::FacetNetwork& network, const law::FacetModuli& moduli,
                 double thickness, bool single) {
    bonds.twice_shear = thickness * moduli.twice_shear;
    for (std::size_t k = 0; k < network.bonds.size(); ++k) {
        const bonding::FacetBond& bond = network.bonds[k];
        bonds.share_i.set(k, bond.share_i);
        bonds.walled.push_back(bond.walled ? 1 : 0);
        bonds.area.push_back(bond.whole.area);
        bonds.centre.push_back(bond.whole.centre);
        bonds.springs.push_back(bond.springs);
        bonds.growth_i.push_back(bond.growth_i);
        bonds.growth_j.push_back(bond.growth_j);
    }
    for (const double volume : network.volume) {
        bonds.pressure_per_growth.push_back(volume > 0.0 ? thickness * moduli.lame / volume : 0.0);
    }
    for (NumberColumn* column : bonds.motion.all()) column->resize(bonds.size());
    bonds.grown_i.resize(bonds.size() + 1);
    bonds.grown_j.resize(bonds.size() + 1);
    if (single) bonds.keep_single();
    fill_springs(bonds);
    bonds.pressure.resize(network.volume.size());
    bonds.bands = bands_of(bonds.i, bonds.j, bonds.slots.first, bonds.slots.elements);
    if constexpr (Law::breaks) {
        find_yielding_stiffness(bonds);
        for (Column<double>* column : {&bonds.normal, &bonds.shear, &bonds.normal_before, &bonds.shear_before}) {
            column->resize(bonds.size());
        }
        bonds.suspect.resize(bonds.size());
    }
}

} // namespace demlua::state
