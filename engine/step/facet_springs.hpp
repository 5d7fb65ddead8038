// Facets and the cells between them as springs: what facet_forces computes, to first order from bonding.
#pragma once

#include "engine/step/springs.hpp"

#include <array>
#include <vector>

namespace demlua::step {

/// A facet's q as displacements of its elements move it, at bonding.
struct FacetEnds {
    std::size_t i, j;
    Vec2 normal;
    double arm_i, arm_j;

    [[nodiscard]] SpringEnd at_i(law::FacetVector<double> g) const {
        const Vec2 along = g.normal * normal + g.shear * turned_left(normal);
        return {i, -along.x, -along.y, -arm_i * g.shear - g.turn};
    }
    [[nodiscard]] SpringEnd at_j(law::FacetVector<double> g) const {
        const Vec2 along = g.normal * normal + g.shear * turned_left(normal);
        return {j, along.x, along.y, -arm_j * g.shear + g.turn};
    }
};

template <class Law>
FacetEnds ends_of(const state::FacetSet<Law>& bonds, std::size_t k) {
    const double arm_i = bonds.length[k] * bonds.share_i[k];
    return {bonds.i[k], bonds.j[k], Vec2{bonds.Dx[k], bonds.Dy[k]} / bonds.length[k], arm_i, bonds.length[k] - arm_i};
}

/// K as three springs, by its factors L D L'.
inline void add_springs(const law::FacetSprings<double>& K, const FacetEnds& ends, Springs& springs) {
    const auto add = [&](double k, law::FacetVector<double> g) {
        if (k > 0.0) springs.add(k, 0.0, std::array{ends.at_i(g), ends.at_j(g)});
    };
    const double tt = K.nn > 0.0 ? K.tt - K.nt * K.nt / K.nn : K.tt;
    const double tw = K.nn > 0.0 ? K.tw - K.nt * K.nw / K.nn : K.tw;
    const double ww = K.nn > 0.0 ? K.ww - K.nw * K.nw / K.nn : K.ww;
    if (K.nn > 0.0) add(K.nn, {1.0, K.nt / K.nn, K.nw / K.nn});
    if (tt > 0.0) add(tt, {0.0, 1.0, tw / tt});
    add(tt > 0.0 ? ww - tw * tw / tt : ww, {0.0, 0.0, 1.0});
}

inline void join(SpringEnd& sum, const SpringEnd& end) {
    sum.x += end.x;
    sum.y += end.y;
    sum.turn += end.turn;
}

template <class Law>
void add_stiffness(const state::FacetSet<Law>& bonds, const state::Elements& /*elements*/, Springs& springs) {
    const std::size_t first = bonds.slots.first;
    std::vector<std::vector<SpringEnd>> cells(bonds.pressure.size());
    for (std::size_t e = 0; e < cells.size(); ++e) cells[e].push_back({first + e});
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        if (bonds.is_broken(k)) continue;
        const FacetEnds ends = ends_of(bonds, k);
        add_springs(bonds.springs[k], ends, springs);
        if (bonds.dashpots.present()) {
            const law::FacetVector<double> stretch{1.0, 0.0, 0.0};
            const law::FacetVector<double> shear{0.0, 1.0, 0.0};
            springs.add(0.0, bonds.dashpots.Cn[k], std::array{ends.at_i(stretch), ends.at_j(stretch)});
            springs.add(0.0, bonds.dashpots.Ct[k], std::array{ends.at_i(shear), ends.at_j(shear)});
        }
        std::vector<SpringEnd>& of_i = cells[bonds.i[k] - first];
        std::vector<SpringEnd>& of_j = cells[bonds.j[k] - first];
        join(of_i.front(), ends.at_i(bonds.growth_i[k]));
        join(of_j.front(), ends.at_j(bonds.growth_j[k]));
        of_i.push_back(ends.at_j(bonds.growth_i[k]));
        of_j.push_back(ends.at_i(bonds.growth_j[k]));
    }
    for (std::size_t e = 0; e < cells.size(); ++e) {
        if (bonds.pressure_per_growth[e] > 0.0) springs.add(bonds.pressure_per_growth[e], 0.0, cells[e]);
    }
}

} // namespace demlua::step
