// The stiffness of bonded packs against the theory of elasticity: patches solved at rest, and waves.
#include "engine/state/assemble.hpp"
#include "engine/step/real_moduli.hpp"
#include "engine/step/springs.hpp"
#include "tests/catch.hpp"
#include "tests/patches.hpp"
#include "tests/scenes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double E = 29.7e9;
constexpr double density = 2400.0;
constexpr Vec2 size{0.2, 0.15};

model::Scene scene_with(double nu, model::Plane plane, const model::PackingChoice& packing) {
    model::Material material = test::concrete();
    material.poissons_ratio = nu;
    model::Scene scene = test::scene_of(material);
    scene.plane = plane;
    model::Body body;
    body.name = "patch";
    body.region = model::Region::rectangle({0.0, 0.0}, size);
    body.packing = packing;
    body.bonds = model::ElasticBonds{};
    scene.bodies.push_back(body);
    return scene;
}

double depth_of(Vec2 at) { return test::depth_in(size, at); }

/// A patch at rest: displacements and rotations of the elements up to `rim` deep are given, the others found.
struct Patch {
    state::State state;
    std::vector<std::size_t> inside;
    Eigen::SparseMatrix<double> K;

    Patch(const model::Scene& scene, double rim) : state(state::assemble(scene).state) {
        K = step::springs_of(state).stiffness_matrix();
        for (std::size_t k = 0; k < state.elements.size(); ++k) {
            if (depth_of(state.elements.position(k)) > rim * state.elements.radius[k]) inside.push_back(k);
        }
    }

    /// Greatest difference of the equilibrium from the uniform strain, relative to the largest displacement; rotations
    /// times the radius.
    [[nodiscard]] double deviation(const Eigen::Vector3d& strain) const {
        const Eigen::VectorXd uniform = test::strained(state, strain);
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::Index row = 0;
        for (const std::size_t k : inside) {
            for (int f = 0; f < 3; ++f) entries.emplace_back(row++, static_cast<Eigen::Index>(3 * k) + f, 1.0);
        }
        Eigen::SparseMatrix<double> pick(row, K.rows());
        pick.setFromTriplets(entries.begin(), entries.end());
        Eigen::SparseMatrix<double> inner = pick * K * pick.transpose();
        // At nu* = 1/3 bonds have no shear stiffness, and nothing turns the elements.
        const double most = inner.diagonal().maxCoeff();
        for (Eigen::Index k = 0; k < row; ++k) {
            if (inner.coeff(k, k) < 1e-12 * most) inner.coeffRef(k, k) += most;
        }
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(inner);
        Eigen::VectorXd off = solver.solve(Eigen::VectorXd(pick * (K * uniform)));
        for (std::size_t n = 0; n < inside.size(); ++n) {
            off[static_cast<Eigen::Index>(3 * n + 2)] *= state.elements.radius[inside[n]];
        }
        return off.cwiseAbs().maxCoeff() / uniform.cwiseAbs().maxCoeff();
    }

    /// Mean stress (xx, yy, xy) of the elements well inside under a uniform strain, from the pairs' forces on them.
    [[nodiscard]] Eigen::Vector3d stress(const Eigen::Vector3d& strain, double depth) const {
        const auto& bonds = std::get<state::BondSet<law::Elastic>>(state.bond_sets.at(0));
        Eigen::Vector3d virial = Eigen::Vector3d::Zero();
        double volume = 0.0;
        for (std::size_t k = 0; k < state.elements.size(); ++k) {
            if (depth_of(state.elements.position(k)) > depth * state.elements.radius[k]) {
                volume += state.elements.cell_area[k] * state.thickness;
            }
        }
        for (std::size_t k = 0; k < bonds.size(); ++k) {
            const Vec2 D{bonds.Dx[k], bonds.Dy[k]};
            const Vec2 n = D / bonds.length[k];
            const Vec2 du{strain[0] * D.x + strain[2] * D.y, strain[2] * D.x + strain[1] * D.y};
            const Vec2 f =
                bonds.params.Kn * dot(du, n) * n + bonds.params.Kt * dot(du, turned_left(n)) * turned_left(n);
            for (const Index element : {bonds.i[k], bonds.j[k]}) {
                if (depth_of(state.elements.position(element)) <= depth * state.elements.radius[element]) continue;
                virial += 0.5 * Eigen::Vector3d{f.x * D.x, f.y * D.y, 0.5 * (f.x * D.y + f.y * D.x)};
            }
        }
        return virial / volume;
    }
};

/// Stiffness of an element of an endless pack against a plane wave: from the rows of one far from the walls.
Eigen::Matrix3cd seen_by(const Patch& patch, std::size_t middle, Vec2 wave) {
    using namespace std::complex_literals;
    Eigen::Matrix3cd seen = Eigen::Matrix3cd::Zero();
    const Vec2 here = patch.state.elements.position(middle);
    for (int f = 0; f < 3; ++f) {
        const auto column = static_cast<Eigen::Index>(3 * middle) + f;
        // K is symmetric: the column of a freedom is its row.
        for (Eigen::SparseMatrix<double>::InnerIterator entry(patch.K, column); entry; ++entry) {
            const auto other = static_cast<std::size_t>(entry.row() / 3);
            const double phase = dot(wave, patch.state.elements.position(other) - here);
            seen(f, entry.row() % 3) += entry.value() * std::exp(1i * phase);
        }
    }
    return seen;
}

/// Frequencies of the two slow waves, rising: transverse and longitudinal, rad/s.
std::array<double, 2> slow_waves(const Patch& patch, Vec2 wave) {
    const state::Elements& elements = patch.state.elements;
    std::size_t middle = 0;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        if (norm(elements.position(k) - 0.5 * size) < norm(elements.position(middle) - 0.5 * size)) middle = k;
    }
    const Eigen::Vector3d scale{std::sqrt(elements.inverse_mass[middle]), std::sqrt(elements.inverse_mass[middle]),
                                std::sqrt(elements.inverse_inertia[middle])};
    const Eigen::Matrix3cd scaled = scale.asDiagonal() * seen_by(patch, middle, wave) * scale.asDiagonal();
    const Eigen::Vector3d squared = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3cd>(scaled).eigenvalues();
    return {std::sqrt(squared[0]), std::sqrt(squared[1])};
}

model::ClosePacking lattice(double radius, model::Rows rows) {
    return {radius, rows, model::Fit::inside, std::nullopt};
}

} // namespace

TEST_CASE("a close-packed patch at rest is uniformly strained, with E*, nu* and G of the material") {
    const model::Rows rows = GENERATE(model::Rows::horizontal, model::Rows::vertical);
    const auto [plane, nu] = GENERATE(std::pair{model::Plane::stress, 0.0}, std::pair{model::Plane::stress, 0.1},
                                      std::pair{model::Plane::stress, 0.2}, std::pair{model::Plane::stress, 0.25},
                                      std::pair{model::Plane::stress, 0.3}, std::pair{model::Plane::strain, 0.0},
                                      std::pair{model::Plane::strain, 0.1}, std::pair{model::Plane::strain, 0.2},
                                      std::pair{model::Plane::strain, 0.25});
    const Patch patch(scene_with(nu, plane, lattice(5e-3, rows)), 3.0);
    const double Es = plane == model::Plane::stress ? E : E / (1.0 - nu * nu);
    const double nus = plane == model::Plane::stress ? nu : nu / (1.0 - nu);
    const double c11 = Es / (1.0 - nus * nus);
    const double G = Es / (2.0 * (1.0 + nus));
    for (int c = 0; c < 3; ++c) CHECK(patch.deviation(Eigen::Vector3d::Unit(c)) < 1e-12);
    const Eigen::Vector3d pulled = patch.stress({1.0, 0.0, 0.0}, 3.0);
    CHECK(std::fabs(pulled[0] / c11 - 1.0) < 1e-12);
    CHECK(std::fabs(pulled[1] / c11 - nus) < 1e-12);
    CHECK(std::fabs(patch.stress({0.0, 1.0, 0.0}, 3.0)[1] / c11 - 1.0) < 1e-12);
    CHECK(std::fabs(patch.stress({0.0, 0.0, 0.5}, 3.0)[2] / G - 1.0) < 1e-12);
}

TEST_CASE("patches of facets at rest are uniformly strained on every packing for nu from 0 to 0.45") {
    const model::Plane plane = GENERATE(model::Plane::stress, model::Plane::strain);
    const double nu = GENERATE(0.0, 0.2, 0.3, 0.45);
    const int kind = GENERATE(0, 1, 2, 3, 4);
    model::PackingChoice packing;
    if (kind == 0 || kind == 1) {
        model::Consolidation clusters;
        clusters.count = 450;
        clusters.solid_fraction = 0.8;
        clusters.relax = 4 * kind;
        packing = clusters;
    } else {
        model::Relaxation relaxed;
        relaxed.on_boundary = kind == 3;
        if (kind == 4) {
            relaxed.size = [](Vec2 at) { return 4e-3 + 0.05 * at.x; };
        } else {
            relaxed.count = 450;
        }
        packing = relaxed;
    }
    // Cells on the walls are made for free walls; elements up to two rows deep are held instead.
    const Patch patch(scene_with(nu, plane, packing), 6.0);
    REQUIRE(patch.inside.size() > 40);
    for (int c = 0; c < 3; ++c) CHECK(patch.deviation(Eigen::Vector3d::Unit(c)) < 1e-10);
}

TEST_CASE("waves in the lattice travel at the figures worked out from its unit cell") {
    // Phase speed over that of theory at wavelengths of 80, 40, 20, 10 R, nu* = 0.2: derived from eqs 15, 16 by Bloch's
    // theorem outside this project.
    const double radius = 2e-3;
    const Patch patch(scene_with(0.2, model::Plane::stress, lattice(radius, model::Rows::horizontal)), 0.0);
    const double cp = std::sqrt(E / (1.0 - 0.04) / density);
    const double cs = std::sqrt(E / (2.0 * 1.2) / density);
    constexpr std::array wavelengths{80.0, 40.0, 20.0, 10.0};
    constexpr std::array p_wave{0.9992, 0.9966, 0.986, 0.945};
    constexpr std::array s_wave{0.9995, 0.998, 0.992, 0.966};
    for (std::size_t n = 0; n < wavelengths.size(); ++n) {
        const double q = 2.0 * std::numbers::pi / (wavelengths[n] * radius);
        const auto [s, p] = slow_waves(patch, {q, 0.0});
        CHECK(p / (q * cp) == Approx(p_wave[n]).epsilon(2e-3));
        CHECK(s / (q * cs) == Approx(s_wave[n]).epsilon(2e-3));
    }
}

TEST_CASE("the moduli a body of pairs really has are the material's in close packing") {
    // Eqs 15 and 16 are exact there, so that what is measured must be what was given.
    const model::Plane plane = GENERATE(model::Plane::stress, model::Plane::strain);
    const double nu = 0.2;
    const model::Rows rows = GENERATE(model::Rows::horizontal, model::Rows::vertical);
    const state::State state = state::assemble(scene_with(nu, plane, lattice(2e-3, rows))).state;
    const law::PlaneModuli real = law::solid_moduli(step::real_moduli(state, 0).value(), plane == model::Plane::strain);
    CHECK(std::fabs(real.youngs_modulus / E - 1.0) < 1e-6);
    CHECK(std::fabs(real.poissons_ratio - nu) < 1e-6);
}
