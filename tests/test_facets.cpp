// Facet springs with one pressure per cell: exactness on irregular packs, and what must hold in motion.
#include "engine/base/team.hpp"
#include "engine/observe/ledger.hpp"
#include "engine/observe/stress.hpp"
#include "engine/state/assemble.hpp"
#include "engine/state/loading.hpp"
#include "engine/step/springs.hpp"
#include "engine/step/step.hpp"
#include "tests/catch.hpp"
#include "tests/patches.hpp"
#include "tests/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr Vec2 size{0.2, 0.1};

model::Material solid(double nu) {
    model::Material material = test::concrete();
    material.poissons_ratio = nu;
    return material;
}

/// A consolidated pack of three-element clusters in a rectangle.
model::Body packed(std::uint64_t count, std::uint64_t seed, const model::BondChoice& bonds) {
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
    scene.bodies.push_back(packed(count, seed, model::ElasticBonds{}));
    return scene;
}

double depth_of(Vec2 at) { return test::depth_in(size, at); }

/// Greatest unbalanced force inside a pack under a uniform strain, relative to what its walls need.
double residual_inside(const state::State& state, const Eigen::Vector3d& strain) {
    const state::Elements& elements = state.elements;
    const Eigen::VectorXd force = step::springs_of(state).times(1.0, 0.0, test::strained(state, strain));
    const double walls = force.cwiseAbs().maxCoeff();
    double worst = 0.0;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        // Cells on the walls, whose elements lie up to 3 R deep, pass on what their walls would have to hold.
        if (depth_of(elements.position(k)) < 6.0 * elements.radius[k]) continue;
        const auto row = static_cast<Eigen::Index>(3 * k);
        worst = std::max(
            {worst, std::fabs(force[row]), std::fabs(force[row + 1]), std::fabs(force[row + 2]) / elements.radius[k]});
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

TEST_CASE("the stress of every inner element under a uniform strain is Hooke's") {
    const double nu = 0.3;
    state::State state = state::assemble(elastic_pack(nu, 400, 1)).state;
    const Vec2 stretch{1e-7, -0.3e-7};
    state::Elements& elements = state.elements;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        elements.ux[k] = stretch.x * elements.reference_x[k];
        elements.uy[k] = stretch.y * elements.reference_y[k];
    }
    Team team(1);
    step::Stepper stepper(team, state, 0.2);
    step::compute_forces(state, stepper);
    const std::vector<double> stress = observe::stress_of_elements(state);
    const double E = 29.7e9 / (1.0 - nu * nu);
    const double xx = E * (stretch.x + nu * stretch.y);
    const double yy = E * (stretch.y + nu * stretch.x);
    std::size_t seen = 0;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        if (depth_of(elements.position(k)) < 6.0 * elements.radius[k]) continue;
        // Finite kinematics leave errors of the order of the strain.
        CHECK(std::fabs(stress[3 * k] - xx) < 1e-5 * xx);
        CHECK(std::fabs(stress[3 * k + 1] - yy) < 1e-5 * xx);
        CHECK(std::fabs(stress[3 * k + 2]) < 1e-5 * xx);
        ++seen;
    }
    CHECK(seen > 30);
}

TEST_CASE("a pull along free walls is in equilibrium up to the walls of a relaxed pack, moments included") {
    // Uniaxial stress: strain (1, -nu). Only the elements beside the pulled ends may be out of balance. Packs that are hardly
    // relaxed have bonds along the wall whose line misses their facet.
    const double nu = GENERATE(0.0, 0.3, 0.45);
    model::Scene scene = elastic_pack(nu, 0, 1);
    scene.bodies[0].packing = test::relaxed_between(size, 400, 1, GENERATE(8, 50));
    const state::State state = state::assemble(scene).state;
    const Eigen::VectorXd force = step::springs_of(state).times(1.0, 0.0, test::strained(state, {1.0, -nu, 0.0}));
    const double ends = force.cwiseAbs().maxCoeff();
    double worst = 0.0;
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        const double x = state.elements.position(k).x;
        const double radius = state.elements.radius[k];
        if (std::min(x, size.x - x) < 6.0 * radius) continue;
        const auto row = static_cast<Eigen::Index>(3 * k);
        worst = std::max({worst, std::fabs(force[row]), std::fabs(force[row + 1]), std::fabs(force[row + 2]) / radius});
    }
    CHECK(worst < 1e-10 * ends);
}

TEST_CASE("a spinning pack of facets keeps its energy and angular momentum") {
    const double spin = 200.0;
    model::Scene scene = elastic_pack(0.3, 100, 2);
    scene.bodies[0].spin = spin;
    scene.step_fraction = 0.8;
    observe::Simulation sim(scene, 1);
    const double turn = 2.0 * std::numbers::pi / spin;
    double first_energy = 0.0;
    double first_momentum = 0.0;
    double energy_drift = 0.0;
    double momentum_drift = 0.0;
    sim.run(5.0 * turn, {test::watching(turn / 16.0, [&](observe::Simulation& now) {
                const observe::Ledger ledger = now.ledger();
                const double angular = now.momentum().angular;
                if (now.step() == 0) {
                    first_energy = ledger.kinetic;
                    first_momentum = angular;
                }
                energy_drift = std::max(energy_drift, std::fabs(ledger.error / first_energy));
                momentum_drift = std::max(momentum_drift, std::fabs(angular / first_momentum - 1.0));
            })});
    // Started without its centrifugal stretch the pack rings, which central difference shows as a few 1e-7.
    CHECK(energy_drift < 1e-6);
    CHECK(momentum_drift < 1e-11);
}

TEST_CASE("an elastic pack pressed together by a quarter and let go keeps its energy in the ledger") {
    model::Scene scene = elastic_pack(0.3, 100, 1);
    scene.step_fraction = 0.2;
    const double rate = 5.0;
    for (const auto& [side, vx] : {std::pair{model::Side::left, rate}, std::pair{model::Side::right, -rate}}) {
        model::Motion motion;
        motion.selection = test::side_of(0, side);
        motion.velocity_x = Signal{{0.0, 5e-3, 5.001e-3, 10e-3}, {vx, vx, -vx, -vx}};
        scene.motions.push_back(motion);
    }
    observe::Simulation sim(scene, 2);
    double most = 0.0;
    sim.run(10e-3, {test::watching(1e-4, [&](observe::Simulation& now) {
                const observe::Ledger ledger = now.ledger();
                most = std::max(most, ledger.bonds);
                CHECK(std::fabs(ledger.error) <= 1e-3 * std::max(most, ledger.kinetic));
            })});
    CHECK(most > 1e6);
}

TEST_CASE("pulled apart, a pack of facets spends what its broken facets owe and leaves nothing unaccounted") {
    model::Scene scene = test::scene_of(solid(0.2));
    scene.bodies.push_back(packed(300, 1, model::PlateauBonds{{0.1, 0.02}, true}));
    for (const auto& [side, vx] : {std::pair{model::Side::left, -0.02}, std::pair{model::Side::right, 0.02}}) {
        model::Motion motion;
        motion.selection = test::side_of(0, side);
        motion.velocity_x = Signal{{0.0, 1e-3}, {0.0, vx}};
        scene.motions.push_back(motion);
    }
    observe::Simulation sim(scene, 2);
    sim.run(6e-3, {});
    const observe::Ledger ledger = sim.ledger();
    CHECK(sim.fragments() > 1);
    CHECK(std::fabs(ledger.error) < 2e-3 * ledger.work);
    // G_f for every broken facet at least; facets that yield and do not break add to it.
    const double Gf = 1e12 / 29.7e9;
    CHECK(ledger.plastic + ledger.fracture > 0.9 * Gf * sim.crack_length());
}

TEST_CASE("a scene turned and shifted as a whole has the same forces to round-off") {
    const double angle = 0.7;
    const Vec2 shift{3.0, -2.0};
    state::State there = state::assemble(elastic_pack(0.3, 100, 4)).state;
    state::State here = state::assemble(elastic_pack(0.3, 100, 4)).state;
    for (std::size_t k = 0; k < here.elements.size(); ++k) {
        const Vec2 at = here.elements.position(k);
        const Vec2 u{1e-4 * std::sin(40.0 * at.y), 1e-4 * std::cos(50.0 * at.x)};
        const Vec2 moved = turned(at + u, angle) + shift - at;
        here.elements.ux[k] = u.x, here.elements.uy[k] = u.y, here.elements.rotation[k] = 1e-3 * std::sin(90.0 * at.x);
        there.elements.ux[k] = moved.x, there.elements.uy[k] = moved.y;
        there.elements.rotation[k] = here.elements.rotation[k] + angle;
    }
    Team team(1);
    for (state::State* state : {&here, &there}) {
        step::Stepper stepper(team, *state, 0.2);
        step::compute_forces(*state, stepper);
    }
    double largest = 0.0;
    double worst = 0.0;
    for (std::size_t k = 0; k < here.elements.size(); ++k) {
        largest = std::max(largest, norm(here.elements.force(k)));
        worst = std::max(worst, norm(turned(here.elements.force(k), angle) - there.elements.force(k)));
    }
    // Coordinates of 3 m against stretches of 1e-5 m cost five digits of sixteen.
    CHECK(worst < 1e-9 * largest);
}

namespace {

/// Over how much of the right side of an irregular body a traction acts, m.
double loaded_on_the_right(const model::Region& region, const model::Relaxation& pack) {
    model::Scene scene = elastic_pack(0.3, 0, 1);
    scene.bodies[0].region = region;
    scene.bodies[0].packing = pack;
    model::Traction traction;
    traction.selection = test::side_of(0, model::Side::right);
    traction.stress_y = Signal::constant(1e3);
    const state::State state = state::assemble(scene).state;
    const Column<double> share = state::load_of(traction, scene.bodies[0], state).share;
    return std::accumulate(share.begin(), share.end(), 0.0) / state.thickness;
}

} // namespace

TEST_CASE("a traction acts on the whole of its side and nothing more, however the other sides stand") {
    // An upright end 0.1 m high that begins above the region's lowest point: force = stress times height times thickness.
    model::Relaxation relaxed;
    relaxed.count = 300;
    relaxed.on_boundary = true;
    const auto leaning = model::Region::polygon({{0.0, 0.0}, {0.3, 0.12}, {0.3, 0.22}, {0.0, 0.1}});
    CHECK(loaded_on_the_right(leaning, relaxed) == Approx(0.1).epsilon(1e-9));
}

TEST_CASE("a traction on the end of a thin bar is all there, whichever elements stand in its corners") {
    // Packs without a row on the boundary: the element in a corner is often none of the end's. Force = stress times height.
    const double height = 0.02;
    const auto bar = model::Region::rectangle({0.0, 0.0}, {0.3, height});
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        model::Relaxation relaxed;
        relaxed.count = 180;
        relaxed.seed = seed;
        CHECK(loaded_on_the_right(bar, relaxed) == Approx(height).epsilon(1e-9));
    }
}
