// The bonds of one set as a linear network with offsets: what plastic displacements of bonds do to it.
//
//   U(u, w) = energy of the bonds when bond k is stretched by e_k - w_k,n and sheared by ut_k - w_k,t
//   f_k = -dU/dw_k      force in bond k: normal and shear, N
//   L_k = -d2U/du dw_k  so that K u = P + sum_k L_k w_k  is rest under the loads P with offsets w
//   M_km = d2U/dw_k dw_m  so that  f_k = L_k.u - sum_m M_km w_m
//
// u displacements (m) and rotations (rad) from bonding, of first order; e, ut of law/bond_motion.hpp. For pairs M is
// diagonal; facets of one cell share its pressure (law/facet.hpp).
#pragma once

#include "engine/step/facet_springs.hpp"

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace demlua::step {

/// Freedoms of elements with the forces (N, N m) on them.
using ElementForces = std::vector<SpringEnd>;

inline double work_of(std::span<const SpringEnd> forces, const Eigen::VectorXd& u) {
    double sum = 0.0;
    for (const SpringEnd& end : forces) {
        const auto row = static_cast<Eigen::Index>(3 * end.element);
        sum += end.x * u[row] + end.y * u[row + 1] + end.turn * u[row + 2];
    }
    return sum;
}

template <class Law>
std::array<SpringEnd, 2> ends_of(const state::BondSet<Law>& bonds, std::size_t k, Eigen::Vector2d force) {
    const Vec2 n = Vec2{bonds.Dx[k], bonds.Dy[k]} / bonds.length[k];
    const double arm = bonds.length[k] * bonds.share_i[k];
    const Vec2 f = force[0] * n + force[1] * turned_left(n);
    return between(bonds.i[k], bonds.j[k], f, force[1] * arm, force[1] * (bonds.length[k] - arm));
}

/// L_k w.
template <class Law>
ElementForces offset_forces(const state::BondSet<Law>& bonds, std::size_t k, Eigen::Vector2d w) {
    const auto ends = ends_of(bonds, k, {bonds.params.Kn * w[0], bonds.params.Kt * w[1]});
    return {ends.begin(), ends.end()};
}

/// M_km.
template <class Law>
Eigen::Matrix2d offset_coupling(const state::BondSet<Law>& bonds, std::size_t k, std::size_t m) {
    Eigen::Matrix2d coupling = Eigen::Matrix2d::Zero();
    if (k == m) coupling.diagonal() << bonds.params.Kn, bonds.params.Kt;
    return coupling;
}

/// Bonds m, k among them, with M_km other than zero.
template <class Law>
std::vector<std::size_t> coupled_bonds(const state::BondSet<Law>& /*bonds*/, std::size_t k) {
    return {k};
}

/// f of all bonds under u, without offsets; zero in broken ones.
template <class Law>
std::vector<Eigen::Vector2d> network_forces(const state::BondSet<Law>& bonds, const Eigen::VectorXd& u) {
    std::vector<Eigen::Vector2d> force(bonds.size(), Eigen::Vector2d::Zero());
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        if (bonds.is_broken(k)) continue;
        force[k] = {work_of(ends_of(bonds, k, {bonds.params.Kn, 0.0}), u),
                    work_of(ends_of(bonds, k, {0.0, bonds.params.Kt}), u)};
    }
    return force;
}

namespace facets {

inline law::FacetVector<double> as_q(Eigen::Vector2d w) { return {w[0], w[1], 0.0}; }

inline void add_ends(ElementForces& forces, const FacetEnds& ends, law::FacetVector<double> force) {
    forces.push_back(ends.at_i(force));
    forces.push_back(ends.at_j(force));
}

/// Calls `of(bond, growth of this cell with its q)` for every bond of cell `e` that holds.
template <class Law, class Of>
void for_facets_of(const state::FacetSet<Law>& bonds, std::size_t e, const Of& of) {
    state::for_each_pair_of(bonds.slots, bonds.slots.first + e, [&](std::size_t k, bool is_j) {
        if (!bonds.is_broken(k)) of(k, is_j ? bonds.growth_j[k] : bonds.growth_i[k]);
    });
}

template <class Law>
std::array<std::size_t, 2> cells_of(const state::FacetSet<Law>& bonds, std::size_t k) {
    return {bonds.i[k] - bonds.slots.first, bonds.j[k] - bonds.slots.first};
}

template <class Law>
law::FacetVector<double> growth(const state::FacetSet<Law>& bonds, std::size_t k, std::size_t cell) {
    return cells_of(bonds, k)[0] == cell ? bonds.growth_i[k] : bonds.growth_j[k];
}

} // namespace facets

template <class Law>
ElementForces offset_forces(const state::FacetSet<Law>& bonds, std::size_t k, Eigen::Vector2d w) {
    const law::FacetVector<double> q = facets::as_q(w);
    ElementForces forces;
    facets::add_ends(forces, ends_of(bonds, k), bonds.springs[k] * q);
    for (const std::size_t cell : facets::cells_of(bonds, k)) {
        const double pressure = bonds.pressure_per_growth[cell] * dot(facets::growth(bonds, k, cell), q);
        facets::for_facets_of(bonds, cell, [&](std::size_t m, const law::FacetVector<double>& grows) {
            facets::add_ends(forces, ends_of(bonds, m), pressure * grows);
        });
    }
    return forces;
}

template <class Law>
Eigen::Matrix2d offset_coupling(const state::FacetSet<Law>& bonds, std::size_t k, std::size_t m) {
    Eigen::Matrix2d coupling = Eigen::Matrix2d::Zero();
    if (k == m) {
        const law::FacetSprings<double>& K = bonds.springs[k];
        coupling << K.nn, K.nt, K.nt, K.tt;
    }
    const auto of_m = facets::cells_of(bonds, m);
    for (const std::size_t cell : facets::cells_of(bonds, k)) {
        if (cell != of_m[0] && cell != of_m[1]) continue;
        const law::FacetVector<double>& a = facets::growth(bonds, k, cell);
        const law::FacetVector<double>& b = facets::growth(bonds, m, cell);
        coupling += bonds.pressure_per_growth[cell] * Eigen::Vector2d(a.normal, a.shear) *
                    Eigen::RowVector2d(b.normal, b.shear);
    }
    return coupling;
}

template <class Law>
std::vector<std::size_t> coupled_bonds(const state::FacetSet<Law>& bonds, std::size_t k) {
    std::vector<std::size_t> found{k};
    for (const std::size_t cell : facets::cells_of(bonds, k)) {
        facets::for_facets_of(bonds, cell, [&](std::size_t m, const law::FacetVector<double>& /*grows*/) {
            if (m != k) found.push_back(m);
        });
    }
    return found;
}

template <class Law>
std::vector<Eigen::Vector2d> network_forces(const state::FacetSet<Law>& bonds, const Eigen::VectorXd& u) {
    std::vector<law::FacetVector<double>> q(bonds.size());
    const auto along = [&](const FacetEnds& ends, law::FacetVector<double> direction) {
        return work_of(std::array{ends.at_i(direction), ends.at_j(direction)}, u);
    };
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        if (bonds.is_broken(k)) continue;
        const FacetEnds ends = ends_of(bonds, k);
        q[k] = {along(ends, {1.0, 0.0, 0.0}), along(ends, {0.0, 1.0, 0.0}), along(ends, {0.0, 0.0, 1.0})};
    }
    std::vector<double> pressure(bonds.pressure.size());
    for (std::size_t e = 0; e < pressure.size(); ++e) {
        facets::for_facets_of(bonds, e, [&](std::size_t k, const law::FacetVector<double>& grows) {
            pressure[e] += bonds.pressure_per_growth[e] * dot(grows, q[k]);
        });
    }
    std::vector<Eigen::Vector2d> force(bonds.size(), Eigen::Vector2d::Zero());
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        if (bonds.is_broken(k)) continue;
        law::FacetVector<double> f = bonds.springs[k] * q[k];
        for (const std::size_t cell : facets::cells_of(bonds, k)) {
            f = f + pressure[cell] * facets::growth(bonds, k, cell);
        }
        force[k] = {f.normal, f.shear};
    }
    return force;
}

} // namespace demlua::step
