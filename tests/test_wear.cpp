// Wear of clusters (Tavarez & Plesha 2007, section 3, eqs 1 and 2).
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <cmath>
#include <numbers>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;
constexpr double g = 9.81;
constexpr double mu = 0.2;
constexpr double density = 2400.0;

/// Three disks that touch each other, two of them on a floor on which they slide at `speed`, held together by bonds or rigidly.
model::Scene sliding_trio(bool rigid, double speed, double W0) {
    model::Scene scene = test::scene_of(test::concrete());
    scene.materials[0].youngs_modulus = 2e7;
    scene.materials[0].friction = mu;
    scene.materials[0].restitution = 0.3;
    scene.materials[0].wear_energy_density = W0;
    scene.gravity = {0.0, -g};
    const double top = (1.0 + std::numbers::sqrt3) * R;
    model::Body trio = test::disks("trio", {{{0.0, R}, R}, {{2.0 * R, R}, R}, {{R, top}, R}},
                                   rigid ? model::BondChoice{model::NoBonds{}} : model::PlateauBonds{});
    std::get<model::ListedDisks>(trio.packing).clusters = {0, 0, 0};
    trio.in_clusters = true;
    trio.rigid = rigid;
    trio.velocity = {speed, 0.0};
    scene.bodies.push_back(trio);
    scene.walls.push_back(test::wall_along("floor", {{-1.0, 0.0}, {3.0, 0.0}}));
    return scene;
}

} // namespace

TEST_CASE("the leading element of a sliding cluster leaves where its sliding work reaches the limit") {
    // Friction mu 3 m g on the floor, h = R (1 + 1/sqrt(3)) below the middle, is balanced by unequal pressures R beside it: the
    // leading disk carries N = 3/2 m g (1 + mu h/R), and W = mu N s reaches W0 pi R^2 t at s = W0 / (mu n density g), n = N/(m g).
    const bool rigid = GENERATE(true, false);
    CAPTURE(rigid);
    const double speed = 2.0;
    const double s = 0.2;
    const double n = 1.5 * (1.0 + mu * (1.0 + 1.0 / std::numbers::sqrt3));
    const double W0 = mu * n * density * g * s;
    observe::Simulation sim(sliding_trio(rigid, speed, W0), 1);
    double left_at = -1.0;
    Vec2 before;
    Vec2 after;
    std::size_t worn_at_once = 0;
    sim.run(0.15, {test::watching(0.0, [&](observe::Simulation& now) {
                if (now.worn_elements() == 0) {
                    before = now.momentum().linear;
                } else if (left_at < 0.0) {
                    left_at = now.state().elements.ux[1];
                    after = now.momentum().linear;
                    worn_at_once = now.worn_elements();
                }
            })});
    REQUIRE(left_at > 0.0);
    CHECK(left_at == Approx(s).epsilon(0.01));
    // Only friction takes momentum: mu g dt of it in a step.
    CHECK(after.x == Approx(before.x).margin(2.0 * mu * g * sim.time_step() * sim.body_motion(0).mass));
    CHECK(worn_at_once == 1);
    CHECK(sim.state().elements.cluster[1] > 0);
    CHECK(sim.worn_elements() <= 2); // of three the last has nothing to leave
    const observe::Ledger energy = sim.ledger();
    CHECK(std::fabs(energy.error) < 1e-3 * energy.friction);
    if (!rigid) {
        CHECK(sim.broken_bonds() >= 2);
        CHECK(sim.state().cracks.at(0).mode == state::CrackMode::wear);
    }
}

TEST_CASE("the sliding work of an element is the friction of its contacts") {
    observe::Simulation sim(sliding_trio(true, 2.0, 1e12), 1);
    sim.run(0.1, {});
    const std::vector<double> wear = sim.field("wear", {});
    CHECK(wear[0] + wear[1] + wear[2] == Approx(sim.ledger().friction).epsilon(1e-10));
    CHECK(sim.worn_elements() == 0);
}

TEST_CASE("the middle of a worn rod goes on with what is left of momentum and moment of momentum") {
    // Five disks in a rod that spins; an end leaves at once, its limit being next to nothing once it slides.
    model::Scene scene = test::scene_of(test::concrete());
    scene.materials[0].friction = 0.5;
    scene.materials[0].restitution = 1.0;
    scene.materials[0].wear_energy_density = 1e-6;
    scene.step_fraction = 0.02;
    std::vector<model::Disk> list;
    list.reserve(5);
    for (int k = 0; k < 5; ++k) list.push_back({{2.0 * R * k, 0.0}, R});
    model::Body rod = test::disks("rod", list, model::NoBonds{});
    std::get<model::ListedDisks>(rod.packing).clusters = {0, 0, 0, 0, 0};
    rod.in_clusters = rod.rigid = true;
    rod.spin = 20.0;
    scene.bodies.push_back(rod);
    scene.bodies.push_back(test::disks("shot", {{{8.0 * R, 2.03 * R}, R}}, model::NoBonds{}));
    scene.bodies[1].velocity = {0.0, -2.0};
    observe::Simulation sim(scene, 1);
    const observe::Momentum begin = sim.momentum();
    sim.run(1e-3, {});
    CHECK(sim.worn_elements() >= 1);
    const observe::Momentum end = sim.momentum();
    const double scale = 2400.0 * std::numbers::pi * R * R * 2.0;
    CHECK(norm(end.linear - begin.linear) < 1e-10 * scale);
    CHECK(std::fabs(end.angular - begin.angular) < 1e-4 * scale * 8.0 * R);
    CHECK(std::fabs(sim.ledger().error) < 2e-3 * sim.ledger().kinetic);
}
