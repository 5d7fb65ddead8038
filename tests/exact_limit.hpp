// Stiffness and dashpots of bonds written out bond by bond and solved densely: what the engine's estimates are held against.
#pragma once

#include "engine/law/elastic.hpp"
#include "engine/state/state.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <variant>

namespace demlua::test {

/// M^-1/2 K M^-1/2 and M^-1/2 C M^-1/2 of an assembly of elastic bonds.
struct Pencil {
    Eigen::MatrixXd K;
    Eigen::MatrixXd C;
};

inline Pencil pencil_of(const state::State& state) {
    const state::Elements& elements = state.elements;
    const auto rows = static_cast<Eigen::Index>(3 * elements.size());
    Pencil pencil{Eigen::MatrixXd::Zero(rows, rows), Eigen::MatrixXd::Zero(rows, rows)};
    for (const state::AnyBondSet& any : state.bond_sets) {
        const auto& bonds = std::get<state::BondSet<law::Elastic>>(any);
        for (std::size_t k = 0; k < bonds.size(); ++k) {
            const Vec2 n = Vec2{bonds.Dx[k], bonds.Dy[k]} / bonds.length[k];
            const Vec2 t = turned_left(n);
            const double a_i = bonds.length[k] * bonds.share_i[k];
            const double a_j = bonds.length[k] - a_i;
            const auto i = 3 * static_cast<Eigen::Index>(bonds.i[k]);
            const auto j = 3 * static_cast<Eigen::Index>(bonds.j[k]);
            Eigen::VectorXd stretch = Eigen::VectorXd::Zero(rows);
            Eigen::VectorXd shear = Eigen::VectorXd::Zero(rows);
            const double mi = std::sqrt(elements.inverse_mass[bonds.i[k]]);
            const double mj = std::sqrt(elements.inverse_mass[bonds.j[k]]);
            stretch[i] = -n.x * mi, stretch[i + 1] = -n.y * mi, stretch[j] = n.x * mj, stretch[j + 1] = n.y * mj;
            shear[i] = -t.x * mi, shear[i + 1] = -t.y * mi, shear[j] = t.x * mj, shear[j + 1] = t.y * mj;
            shear[i + 2] = -a_i * std::sqrt(elements.inverse_inertia[bonds.i[k]]);
            shear[j + 2] = -a_j * std::sqrt(elements.inverse_inertia[bonds.j[k]]);
            const auto add = [&](Eigen::MatrixXd& sum, double factor, const Eigen::VectorXd& b) {
                for (const Eigen::Index p : {i, i + 1, i + 2, j, j + 1, j + 2}) {
                    for (const Eigen::Index q : {i, i + 1, i + 2, j, j + 1, j + 2}) sum(p, q) += factor * b[p] * b[q];
                }
            };
            add(pencil.K, bonds.params.Kn, stretch);
            add(pencil.K, bonds.params.Kt, shear);
            if (!bonds.dashpots.present()) continue;
            add(pencil.C, bonds.dashpots.Cn[k], stretch);
            add(pencil.C, bonds.dashpots.Ct[k], shear);
        }
    }
    return pencil;
}

inline double largest_eigenvalue(const Eigen::MatrixXd& A) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

/// The dt at which lambda_max(dt^2 K + 2 dt C) is 4. At any dt the mode that is largest there would reach 4 at a dt of its
/// own, which is never below the answer and nearer to it.
inline double exact_limit(const Pencil& pencil) {
    double dt = 2.0 / std::sqrt(largest_eigenvalue(pencil.K));
    if (pencil.C.isZero(0.0)) return dt;
    for (int round = 0; round < 6; ++round) {
        const Eigen::MatrixXd A = dt * dt * pencil.K + 2.0 * dt * pencil.C;
        const Eigen::VectorXd x = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvectors().rightCols<1>();
        const double k = x.dot(pencil.K * x);
        const double c = x.dot(pencil.C * x);
        dt = (std::sqrt(c * c + 4.0 * k) - c) / k;
    }
    return dt;
}

} // namespace demlua::test
