// A box that repeats along x, and elements that leave the scene.
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <cmath>
#include <string>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;

/// Soft enough for the runs below.
model::Material soft(double restitution, double friction) {
    model::Material material = test::bouncing(restitution, friction);
    material.youngs_modulus = 1e8;
    return material;
}

/// Disks at places of a coarse lattice with velocities that repeat no pattern, all moved along x by `shift`.
model::Scene gas(double shift) {
    model::Scene scene = test::scene_of(soft(1.0, 0.0));
    scene.periodic_x = Vec2{0.0, 0.2};
    scene.step_fraction = 0.05;
    for (int k = 0; k < 40; ++k) {
        const int column = k % 10;
        const int row = k / 10;
        const double x = 0.01 + 0.02 * column + shift;
        scene.bodies.push_back(
            test::disks("disk " + std::to_string(k), {{{x - 0.2 * std::floor(x / 0.2), 0.02 * row}, R}}, {}));
        scene.bodies.back().velocity = {std::sin(3.0 * k), std::cos(5.0 * k)};
    }
    scene.walls = {test::wall_along("floor", {{-5.0, -R}, {5.0, -R}}),
                   test::wall_along("lid", {{-5.0, 0.06 + R}, {5.0, 0.06 + R}})};
    return scene;
}

} // namespace

TEST_CASE("disks meet across the edges of a periodic box") {
    model::Scene scene = test::scene_of(soft(0.5, 0.0));
    scene.periodic_x = Vec2{0.0, 0.1};
    scene.step_fraction = 0.02;
    scene.bodies.push_back(test::disks("left", {{{R, 0.0}, R}}, model::NoBonds{}));
    scene.bodies.push_back(test::disks("right", {{{0.1 - 1.1 * R, 0.0}, R}}, model::NoBonds{}));
    scene.bodies[0].velocity = {-1.0, 0.0};
    observe::Simulation sim(scene, 1);
    sim.run(3e-3, {});
    CHECK(sim.body_motion(0).velocity.x - sim.body_motion(1).velocity.x == Approx(0.5).margin(2e-3));
    CHECK(sim.momentum().linear.x == Approx(-sim.body_motion(0).mass).epsilon(1e-12));
}

TEST_CASE("a periodic gas keeps its energy and does not notice where the edges are") {
    observe::Simulation one(gas(0.0), 1);
    observe::Simulation other(gas(0.0731), 2);
    const double px = one.momentum().linear.x;
    const double before = one.ledger().kinetic;
    // Every collision multiplies what rounding leaves: each disk meets one or two others.
    for (observe::Simulation* sim : {&one, &other}) sim->run(0.008, {});
    CHECK(one.momentum().linear.x == Approx(px).epsilon(1e-10));
    CHECK(one.ledger().kinetic + one.ledger().contacts == Approx(before).epsilon(1e-3));
    for (std::size_t body = 0; body < 40; ++body) {
        const Vec2 a = one.body_motion(body).centre;
        const Vec2 b = other.body_motion(body).centre;
        const double dx = b.x - a.x - 0.0731;
        CHECK(std::fabs(dx - 0.2 * std::nearbyint(dx / 0.2)) < 1e-7);
        CHECK(std::fabs(b.y - a.y) < 1e-7);
    }
    for (const Vec2 at : one.snapshot().position) CHECK((at.x >= 0.0 && at.x < 0.2));
}

TEST_CASE("a periodic box too small for its elements is refused with what it takes") {
    model::Scene scene = test::scene_of(soft(0.5, 0.0));
    scene.periodic_x = Vec2{0.0, 0.02};
    scene.bodies.push_back(test::disks("disk", {{{0.01, 0.0}, R}}, model::NoBonds{}));
    // Twice the reach: two diameters and a skin of 0.8 radii.
    CHECK_THROWS_WITH(observe::Simulation(scene, 1),
                      Catch::Matchers::ContainsSubstring("periodic_x") && Catch::Matchers::ContainsSubstring("0.028"));
}

TEST_CASE("a close packing goes on across the edges of a periodic box if the box is whole diameters wide") {
    model::Scene scene = test::scene_of(soft(0.5, 0.3));
    scene.periodic_x = Vec2{0.0, 20.0 * R};
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, {20.0 * R, 8.0 * R}, R, model::ElasticBonds{}));
    const std::size_t rows = 4; // 1 + (8 R - 2 R)/(sqrt(3) R), rounded down
    SECTION("no row ends") {
        const observe::Simulation sim(scene, 1);
        CHECK(sim.element_count() == rows * 10);
        CHECK(sim.bond_count() == rows * 10 + (rows - 1) * 20);
        CHECK(sim.snapshot().bond_ends.size() < sim.bond_count());
    }
    SECTION("a wider box leaves rows of 10 and 9 that touch nothing across the edge") {
        scene.periodic_x = Vec2{0.0, 24.0 * R};
        const observe::Simulation sim(scene, 1);
        CHECK(sim.element_count() == 38);
        CHECK(sim.bond_count() == 2 * 9 + 2 * 8 + (rows - 1) * 18);
        CHECK(sim.snapshot().bond_ends.size() == sim.bond_count());
    }
    SECTION("a lattice that does not repeat is told of") {
        scene.periodic_x = Vec2{0.0, 21.0 * R};
        scene.bodies[0].region = model::Region::rectangle({0.0, 0.0}, {21.0 * R, 8.0 * R});
        std::string told;
        for (const std::string& note : observe::Simulation(scene, 1).notes()) told += note + '\n';
        CHECK(told.find("warning: block: its close packing does not go on across the edges of the periodic box, which "
                        "is 10.5 diameters wide") != std::string::npos);
    }
    SECTION("elements in one another across the edge are refused") {
        scene.periodic_x = Vec2{0.0, 19.5 * R};
        CHECK_THROWS_WITH(observe::Simulation(scene, 1),
                          Catch::Matchers::ContainsSubstring(
                              "overlaps itself across the edge of the periodic box at the start, by 25 %"));
    }
}

TEST_CASE("what leaves the domain is counted, booked and no longer drawn") {
    model::Scene scene = test::scene_of(soft(0.5, 0.3));
    scene.gravity = {0.0, -9.81};
    scene.domain = model::Region::rectangle({-1.0, -0.1}, {2.0, 2.0});
    for (int k = 0; k < 5; ++k) {
        scene.bodies.push_back(test::disks("disk " + std::to_string(k), {{{0.05 * k, 0.1 * k}, R}}, {}));
    }
    observe::Simulation sim(scene, 1);
    // A fall of 0.1 m k + 0.1 m takes sqrt(2 h/g): 0.143, 0.202, 0.247, 0.286, 0.319 s.
    sim.run(0.26, {});
    CHECK(sim.removed_elements() == 3);
    CHECK(sim.snapshot().position.size() == 2);
    const double m = sim.body_motion(0).mass;
    CHECK(sim.ledger().removed == Approx(m * 9.81 * (0.1 + 0.2 + 0.3)).epsilon(0.05));
    CHECK(std::fabs(sim.ledger().error) < 1e-6 * sim.ledger().removed);
    sim.run(0.2, {});
    CHECK(sim.removed_elements() == 5);
    CHECK(sim.ledger().kinetic == 0.0);
}
