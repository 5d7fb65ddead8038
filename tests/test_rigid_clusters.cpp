// Clusters that move as one (Tavarez & Plesha 2007, section 3): mass, motion, impacts.
#include "engine/law/stiffness.hpp"
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <cmath>
#include <numbers>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;

/// Disks of which every `size` make a rigid cluster.
model::Body clusters(const std::string& name, const std::vector<model::Disk>& list, std::size_t size) {
    model::Body body = test::disks(name, list, model::NoBonds{});
    auto& disks = std::get<model::ListedDisks>(body.packing);
    for (std::size_t k = 0; k < list.size(); ++k) disks.clusters.push_back(static_cast<std::uint32_t>(k / size));
    body.rigid = true;
    body.in_clusters = true;
    return body;
}

/// Three disks that touch each other, about `middle`.
std::vector<model::Disk> trio(Vec2 middle, double angle) {
    std::vector<model::Disk> list;
    for (int k = 0; k < 3; ++k) {
        const Vec2 arm = turned(Vec2{2.0 * R / std::numbers::sqrt3, 0.0}, angle + 2.0 * std::numbers::pi / 3.0 * k);
        list.push_back({middle + arm, R});
    }
    return list;
}

} // namespace

TEST_CASE("a rigid cluster has the mass and inertia of its disks together") {
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
    scene.bodies.push_back(clusters("trio", trio({0.1, 0.2}, 0.3), 3));
    const observe::Simulation sim(scene, 1);
    const state::RigidBody& rigid = sim.state().rigid_bodies.at(0);
    const double m = 2400.0 * std::numbers::pi * R * R;
    CHECK(rigid.mass == Approx(3.0 * m).epsilon(1e-12));
    CHECK(rigid.inertia == Approx(3.0 * (0.5 * m * R * R + m * 4.0 / 3.0 * R * R)).epsilon(1e-10));
    CHECK(norm(rigid.centre - Vec2{0.1, 0.2}) < 1e-14);
}

TEST_CASE("a rigid cluster in flight keeps its spin, its path and its shape") {
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
    scene.gravity = {0.0, -9.81};
    scene.bodies.push_back(clusters("trio", trio({0.0, 0.0}, 0.0), 3));
    scene.bodies[0].velocity = {1.0, 2.0};
    scene.bodies[0].spin = 30.0;
    observe::Simulation sim(scene, 1);
    const double before = sim.momentum().angular;
    sim.run(0.2, {});
    const observe::BodyMotion motion = sim.body_motion(0);
    CHECK(motion.centre.x == Approx(0.2).epsilon(1e-12));
    CHECK(motion.centre.y == Approx(2.0 * 0.2 - 0.5 * 9.81 * 0.04).epsilon(1e-10));
    CHECK(sim.state().rigid_bodies.at(0).spin == Approx(30.0).epsilon(1e-12));
    const auto& elements = sim.state().elements;
    CHECK(norm(elements.position(1) - elements.position(0)) == Approx(2.0 * R).epsilon(1e-13));
    CHECK(std::fabs(sim.ledger().error) < 1e-10 * sim.ledger().kinetic);
    // Gravity turns the path, not the cluster: angular momentum about the middle stays.
    const double about_middle = sim.momentum().angular - cross(motion.centre, sim.momentum().linear);
    CHECK(about_middle == Approx(before).epsilon(1e-9));
}

TEST_CASE("a disk that hits the end of a rod gives it the impulse of rigid bodies") {
    // Impulse J = 2 v / (1/m + 1/M + a^2/I) without friction, at arm a.
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
    scene.step_fraction = 0.01;
    scene.bodies.push_back(clusters("rod", {{{0.0, 0.0}, R}, {{2.0 * R, 0.0}, R}, {{4.0 * R, 0.0}, R}}, 3));
    scene.bodies.push_back(test::disks("shot", {{{4.0 * R, 2.02 * R}, R}}, model::NoBonds{}));
    scene.bodies[1].velocity = {0.0, -1.0};
    observe::Simulation sim(scene, 1);
    sim.run(5e-4, {});
    const double m = 2400.0 * std::numbers::pi * R * R;
    const double M = 3.0 * m;
    const double inertia = 3.0 * 0.5 * m * R * R + 2.0 * m * 4.0 * R * R;
    const double a = 2.0 * R;
    const double J = 2.0 / (1.0 / m + 1.0 / M + a * a / inertia);
    CHECK(sim.body_motion(1).velocity.y == Approx(-1.0 + J / m).margin(2e-3));
    CHECK(sim.body_motion(0).velocity.y == Approx(-J / M).epsilon(2e-3));
    CHECK(sim.body_motion(0).spin == Approx(-J * a / inertia).epsilon(2e-3));
    CHECK(std::fabs(sim.ledger().error) < 1e-3 * sim.ledger().kinetic);
}

TEST_CASE("a rigid cluster that meets a disk head-on parts with the restitution asked for") {
    const double e = GENERATE(0.8, 0.4);
    model::Scene scene = test::scene_of(test::bouncing(e, 0.0));
    scene.step_fraction = 0.01;
    scene.bodies.push_back(clusters("rod", {{{0.0, 0.0}, R}, {{2.0 * R, 0.0}, R}}, 2));
    scene.bodies.push_back(test::disks("shot", {{{4.02 * R, 0.0}, R}}, model::NoBonds{}));
    scene.bodies[1].velocity = {-1.0, 0.0};
    observe::Simulation sim(scene, 1);
    sim.run(5e-4, {});
    CHECK(sim.body_motion(1).velocity.x - sim.body_motion(0).velocity.x == Approx(e).margin(2e-3));
}

TEST_CASE("a heap of rigid clusters comes out alike on any number of threads and closes its ledger") {
    model::Scene scene = test::scene_of(test::bouncing(0.5, 0.4));
    scene.materials[0].youngs_modulus = 1e8;
    scene.gravity = {0.0, -9.81};
    std::vector<model::Disk> list;
    for (int row = 0; row < 20; ++row) {
        for (int column = 0; column < 20; ++column) {
            const Vec2 middle{(column + 0.1 * (row % 3)) * 4.4 * R, (row + 0.6) * 4.4 * R};
            for (const model::Disk& disk : trio(middle, 0.7 * row + 0.3 * column)) list.push_back(disk);
        }
    }
    scene.bodies.push_back(clusters("heap", list, 3));
    scene.bodies.back().velocity = {0.0, -1.0};
    scene.walls.push_back(test::wall_along("box", {{-4.0 * R, 1.0}, {-4.0 * R, -R}, {95.0 * R, -R}, {95.0 * R, 1.0}}));
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 3}) {
        observe::Simulation sim(scene, {threads, 1});
        sim.run(0.1, {});
        hashes.push_back(sim.hash());
        CHECK(sim.contact_count() > 100);
        const observe::Ledger energy = sim.ledger();
        CHECK(std::fabs(energy.error) < 1e-3 * (energy.friction + energy.contact_damping));
    }
    CHECK(hashes[1] == hashes[0]);
    CHECK(hashes[2] == hashes[0]);
}
