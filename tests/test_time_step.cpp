// The bound on the highest frequency against exact values, and the step on both sides of the limit.
#include "engine/state/assemble.hpp"
#include "engine/step/time_step.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;

/// Largest eigenvalue of M^-1/2 K M^-1/2 of an elastic assembly, by a dense solver.
double exact_frequency_squared(const state::State& state) {
    const auto& bonds = std::get<state::BondSet<law::Elastic>>(state.bond_sets.at(0));
    const state::Elements& elements = state.elements;
    const auto rows = static_cast<Eigen::Index>(3 * elements.size());
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(rows, rows);
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
        K += bonds.params.Kn * stretch * stretch.transpose() + bonds.params.Kt * shear * shear.transpose();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

model::Scene elastic_block(double nu) {
    model::Material material = test::concrete();
    material.poissons_ratio = nu;
    model::Scene scene = test::scene_of(material);
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, {20.5 * R, 20.0 * R}, R, model::ElasticBonds{}));
    return scene;
}

} // namespace

TEST_CASE("the bound is the infinite lattice's max(6 Kn + 2 Kt, 24 Kt)/m or at most 1.17 times it") {
    const double nu = GENERATE(0.0, 0.1, 0.2, 0.25, 0.3, 0.33);
    const state::State state = state::assemble(elastic_block(nu)).state;
    const auto& p = std::get<state::BondSet<law::Elastic>>(state.bond_sets[0]).params;
    const double lattice = std::max(6.0 * p.Kn + 2.0 * p.Kt, 24.0 * p.Kt) * state.elements.inverse_mass[0];
    const double bound = std::pow(2.0 / step::bound_step(state), 2);
    CHECK(bound >= lattice * (1.0 - 1e-9));
    CHECK(bound <= lattice * 1.17);
    // A finite block lies below the infinite lattice.
    CHECK(exact_frequency_squared(state) <= lattice * (1.0 + 1e-9));
}

TEST_CASE("the bound is safe and not far off on irregular packs") {
    model::Scene scene = elastic_block(0.2);
    model::Consolidation pack;
    pack.count = 150;
    pack.solid_fraction = 0.76;
    pack.seed = GENERATE(1U, 2U, 3U);
    scene.bodies[0].packing = pack;
    const state::State state = state::assemble(scene).state;
    const double exact = exact_frequency_squared(state);
    const double bound = std::pow(2.0 / step::bound_step(state), 2);
    CHECK(bound >= exact);
    CHECK(bound <= 1.5 * exact);
}

TEST_CASE("a step just below the exact limit is stable and one just above is not") {
    model::Scene scene = elastic_block(0.1);
    scene.bodies[0].region = model::Region::rectangle({0.0, 0.0}, {8.5 * R, 8.0 * R});
    const state::State state = state::assemble(scene).state;
    const double exact = 2.0 / std::sqrt(exact_frequency_squared(state));
    const double bound = step::bound_step(state);
    const auto grows = [&](double dt) {
        model::Scene run = scene;
        run.step_fraction = dt / bound;
        observe::Simulation sim(run, 1);
        // A small push, so that the motion stays linear until it has grown a millionfold.
        model::Selection one = test::all_of(0);
        one.where = [](Vec2 at) { return at.x < 1.5 * R && at.y < 1.5 * R; };
        sim.set_velocity(one, {1e-9, 0.3e-9});
        try {
            sim.run(20000.5 * dt, {});
        } catch (const RunError&) {
            return true;
        }
        return sim.ledger().kinetic + sim.ledger().bonds > 1e3 * 1e-18;
    };
    CHECK_FALSE(grows(0.999 * exact));
    CHECK(grows(1.001 * exact));
}

TEST_CASE("the paper's step is taken when asked for and refused where it is unstable") {
    model::Scene scene = elastic_block(0.2);
    scene.time_step = model::StepRule::paper;
    scene.step_fraction = 1.0;
    const observe::Simulation sim(scene, 1);
    const auto& p = std::get<state::BondSet<law::Elastic>>(sim.state().bond_sets[0]).params;
    CHECK(sim.time_step() == Approx(0.5 * std::sqrt(sim.state().elements.mass(0) / p.Kn)).epsilon(1e-12));
    model::Scene refused = elastic_block(0.05);
    refused.time_step = model::StepRule::paper;
    CHECK_THROWS_AS(observe::Simulation(refused, 1), SceneError);
}

TEST_CASE("a run that blows up stops and names the element") {
    model::Scene scene = elastic_block(0.2);
    scene.step_fraction = 1.5;
    observe::Simulation sim(scene, 1);
    model::Selection one = test::all_of(0);
    one.where = [](Vec2 at) { return at.x < 1.5 * R; };
    sim.set_velocity(one, {1e-3, 0.0});
    CHECK_THROWS_WITH(sim.run(1e-3, {}), Catch::Matchers::ContainsSubstring("element") &&
                                             Catch::Matchers::ContainsSubstring("of body \"block\""));
}

TEST_CASE("a velocity that is no number stops the run at once") {
    observe::Simulation sim(elastic_block(0.2), 1);
    model::Selection one = test::all_of(0);
    one.where = [](Vec2 at) { return at.x < 1.5 * R && at.y < 1.5 * R; };
    sim.set_velocity(one, {std::numeric_limits<double>::quiet_NaN(), 0.0});
    CHECK_THROWS_WITH(sim.run(1e-3, {}), Catch::Matchers::ContainsSubstring("element 0 of body \"block\""));
    CHECK(sim.step() == 0);
}
