#include "engine/step/real_moduli.hpp"

#include "engine/step/springs.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

namespace demlua::step {

namespace {

constexpr std::size_t most = 2000; ///< elements that are solved for
constexpr std::size_t least = 50;  ///< elements of a body for which moduli mean anything

using Stress = Eigen::Vector3d; // xx, yy, xy; Pa

/// A part of a body whose elements are free while all others are moved.
struct Middle {
    std::vector<std::size_t> elements;
    std::vector<bool> inside; ///< of each element of the body
};

Middle middle_of(const state::State& state, const state::Body& body) {
    const state::Elements& elements = state.elements;
    Box box{elements.position(body.first), elements.position(body.first)};
    for (std::size_t k = body.first; k < body.last; ++k) {
        const Vec2 at = elements.position(k);
        box.lower = {std::min(box.lower.x, at.x), std::min(box.lower.y, at.y)};
        box.upper = {std::max(box.upper.x, at.x), std::max(box.upper.y, at.y)};
    }
    const Vec2 centre = 0.5 * (box.lower + box.upper);
    constexpr double kept_from_walls = 0.8;
    const Vec2 half = 0.5 * kept_from_walls * box.size();
    const double area = box.size().x * box.size().y * static_cast<double>(most) / static_cast<double>(body.size());
    // A square, or where the body is too narrow for one, as long a piece as has the same area.
    const double y = std::min(half.y, 0.5 * std::sqrt(area));
    const double x = std::min(half.x, 0.25 * area / y);
    Middle middle;
    middle.inside.resize(body.size());
    for (std::size_t k = body.first; k < body.last; ++k) {
        const Vec2 at = elements.position(k) - centre;
        if (std::fabs(at.x) > x || std::fabs(at.y) > y) continue;
        middle.inside[k - body.first] = true;
        middle.elements.push_back(k);
    }
    return middle;
}

/// Displacements of a body under the uniform strain (xx, yy, xy) with the middle at rest under it.
Eigen::VectorXd settled(const state::State& state, const state::Body& body, const Eigen::SparseMatrix<double>& K,
                        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>& solver,
                        const Eigen::SparseMatrix<double>& pick, const Eigen::Vector3d& strain) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(K.rows());
    for (std::size_t k = body.first; k < body.last; ++k) {
        const Vec2 at = state.elements.position(k);
        const auto row = static_cast<Eigen::Index>(3 * (k - body.first));
        u[row] = strain[0] * at.x + strain[2] * at.y;
        u[row + 1] = strain[2] * at.x + strain[1] * at.y;
    }
    const Eigen::VectorXd residual = pick * (K * u);
    return u - pick.transpose() * solver.solve(residual);
}

template <class Law>
Stress mean_stress(const state::State& state, const state::BondSet<Law>& bonds, const Middle& middle,
                   const Eigen::VectorXd& u) {
    const std::size_t first = bonds.slots.first;
    Stress virial = Stress::Zero();
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        const std::size_t i = bonds.i[k] - first;
        const std::size_t j = bonds.j[k] - first;
        const double weight =
            (middle.inside[i] ? bonds.share_i[k] : 0.0) + (middle.inside[j] ? 1.0 - bonds.share_i[k] : 0.0);
        if (bonds.is_broken(k) || weight == 0.0) continue;
        const Vec2 D{bonds.Dx[k], bonds.Dy[k]};
        const Vec2 n = D / bonds.length[k];
        const auto a = static_cast<Eigen::Index>(3 * i);
        const auto b = static_cast<Eigen::Index>(3 * j);
        const Vec2 du{u[b] - u[a], u[b + 1] - u[a + 1]};
        const double turn = bonds.share_i[k] * u[a + 2] + (1.0 - bonds.share_i[k]) * u[b + 2];
        const Vec2 f = bonds.params.Kn * dot(du, n) * n +
                       bonds.params.Kt * (dot(du, turned_left(n)) - bonds.length[k] * turn) * turned_left(n);
        virial += weight * Stress{f.x * D.x, f.y * D.y, 0.5 * (f.x * D.y + f.y * D.x)};
    }
    double volume = 0.0;
    for (const std::size_t k : middle.elements) volume += state.elements.cell_area[k] * state.thickness;
    return virial / volume;
}

/// Rows of the freedoms of the elements in the middle, out of all of the body's.
Eigen::SparseMatrix<double> picking(const state::Body& body, const Middle& middle) {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::Index row = 0;
    for (const std::size_t k : middle.elements) {
        for (int f = 0; f < 3; ++f)
            entries.emplace_back(row++, static_cast<Eigen::Index>(3 * (k - body.first)) + f, 1.0);
    }
    Eigen::SparseMatrix<double> pick(row, static_cast<Eigen::Index>(3 * body.size()));
    pick.setFromTriplets(entries.begin(), entries.end());
    return pick;
}

template <class Law>
std::optional<law::PlaneModuli> moduli_of(const state::State& state, const state::BondSet<Law>& bonds) {
    const state::Body& body = state.bodies[bonds.body];
    const Middle middle = middle_of(state, body);
    if (middle.elements.empty()) return std::nullopt;
    const Eigen::SparseMatrix<double> K = springs_of_body(state, bonds.body).stiffness_matrix();
    const Eigen::SparseMatrix<double> pick = picking(body, middle);
    Eigen::SparseMatrix<double> inner = pick * K * pick.transpose();
    // An element held by nothing has no stiffness of its own; it may stand where it is.
    const double little = 1e-9 * inner.diagonal().maxCoeff();
    for (Eigen::Index k = 0; k < inner.rows(); ++k) inner.coeffRef(k, k) += little;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(inner);
    Eigen::Matrix3d stiffness;
    for (int c = 0; c < 3; ++c) {
        const Eigen::VectorXd u = settled(state, body, K, solver, pick, Eigen::Vector3d::Unit(c));
        stiffness.col(c) = mean_stress(state, bonds, middle, u);
    }
    const double along = 0.5 * (stiffness(0, 0) + stiffness(1, 1));
    const double ratio = 0.5 * (stiffness(0, 1) + stiffness(1, 0)) / along;
    return law::PlaneModuli{along * (1.0 - ratio * ratio), ratio};
}

} // namespace

std::optional<law::PlaneModuli> real_moduli(const state::State& state, std::size_t body) {
    if (state.bodies[body].size() < least) return std::nullopt;
    for (const state::AnyBondSet& any : state.bond_sets) {
        const std::optional<law::PlaneModuli> found = std::visit(
            [&]<class Bonds>(const Bonds& bonds) -> std::optional<law::PlaneModuli> {
                if constexpr (std::is_base_of_v<state::BondSet<typename Bonds::law>, Bonds>) {
                    if (bonds.body == body) return moduli_of(state, bonds);
                }
                return std::nullopt;
            },
            any);
        if (found) return found;
    }
    return std::nullopt;
}

} // namespace demlua::step
