// Loose elements: impacts, friction, walls, free flight.
#include "engine/law/restitution.hpp"
#include "engine/law/stiffness.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <cmath>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;

model::Wall floor_wall() { return test::wall_along("floor", {{-1.0, 0.0}, {1.0, 0.0}}); }

} // namespace

TEST_CASE("two disks part with the restitution asked for") {
    const double e = GENERATE(1.0, 0.8, 0.5, 0.2);
    model::Scene scene = test::scene_of(test::bouncing(e, 0.0));
    scene.step_fraction = 0.02;
    scene.bodies.push_back(test::disks("left", {{{0.0, 0.0}, R}}, model::NoBonds{}));
    scene.bodies.push_back(test::disks("right", {{{2.05 * R, 0.0}, R}}, model::NoBonds{}));
    scene.bodies[0].velocity = {1.0, 0.0};
    observe::Simulation sim(scene, 1);
    sim.run(2e-3, {});
    const double after = sim.body_motion(1).velocity.x - sim.body_motion(0).velocity.x;
    CHECK(after == Approx(e).margin(1e-3));
    CHECK(sim.body_motion(0).velocity.x + sim.body_motion(1).velocity.x == Approx(1.0).epsilon(1e-13));
    const double m = sim.body_motion(0).mass;
    CHECK(sim.ledger().contact_damping == Approx(0.25 * m * (1.0 - e * e)).margin(2e-3 * 0.25 * m));
    CHECK(std::fabs(sim.ledger().error) < 2e-3 * 0.5 * m);
}

TEST_CASE("a head-on contact reaches the overlap and duration of a linear spring") {
    // Greatest overlap v sqrt(m_eff/k), duration pi sqrt(m_eff/k).
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
    scene.step_fraction = 0.02;
    scene.bodies.push_back(test::disks("left", {{{0.0, 0.0}, R}}, model::NoBonds{}));
    scene.bodies.push_back(test::disks("right", {{{2.01 * R, 0.0}, R}}, model::NoBonds{}));
    scene.bodies[0].velocity = {1.0, 0.0};
    observe::Simulation sim(scene, 1);
    double deepest = 0.0;
    double touching = 0.0;
    sim.run(3e-4, {test::watching(0.0, [&](observe::Simulation& now) {
                const double gap = now.body_motion(1).centre.x - now.body_motion(0).centre.x;
                deepest = std::max(deepest, 2.0 * R - gap);
                if (gap < 2.0 * R) touching += now.time_step();
            })});
    const double m = sim.body_motion(0).mass;
    const double K = law::contact_stiffness(law::plane_moduli(29.7e9, 0.3, false), 1.0).normal;
    const double time = std::sqrt(0.5 * m / K);
    CHECK(deepest == Approx(time).epsilon(1e-3));
    CHECK(touching == Approx(std::numbers::pi * time).margin(2.0 * sim.time_step()));
}

TEST_CASE("a disk that slides on impact keeps to the closed form of gross sliding") {
    // v_t' = v_t - mu (1 + e) v_n, omega' = 2 mu (1 + e) v_n / R
    const double mu = 0.1;
    const double e = 0.6;
    model::Scene scene = test::scene_of(test::bouncing(e, mu));
    scene.step_fraction = 0.02;
    scene.walls.push_back(floor_wall());
    scene.bodies.push_back(test::disks("disk", {{{0.0, 1.05 * R}, R}}, model::NoBonds{}));
    const double vn = 1.0;
    const double vt = 4.0;
    scene.bodies[0].velocity = {vt, -vn};
    observe::Simulation sim(scene, 1);
    sim.run(1e-3, {});
    const observe::BodyMotion after = sim.body_motion(0);
    CHECK(after.velocity.y == Approx(e * vn).epsilon(2e-3));
    CHECK(after.velocity.x == Approx(vt - mu * (1.0 + e) * vn).epsilon(1e-3));
    CHECK(after.spin == Approx(-2.0 * mu * (1.0 + e) * vn / R).epsilon(2e-3));
    const observe::Ledger energy = sim.ledger();
    CHECK(std::fabs(energy.error) < 1e-3 * energy.friction);
}

TEST_CASE("a sliding disk ends up rolling at two thirds of its speed") {
    // u = 2 u0/3, reached at u0/(3 mu g)
    const double g = 9.81;
    const double u0 = 0.5;
    const double mu = 0.3;
    model::Scene scene = test::scene_of(test::bouncing(0.3, mu));
    scene.materials[0].youngs_modulus = 1e7; // soft enough for a long run; the motion does not depend on it
    scene.gravity = {0.0, -g};
    scene.walls.push_back(floor_wall());
    scene.bodies.push_back(test::disks("disk", {{{0.0, R}, R}}, model::NoBonds{}));
    scene.bodies[0].velocity = {u0, 0.0};
    observe::Simulation sim(scene, 1);
    const double until_rolling = u0 / (3.0 * mu * g);
    sim.run(0.5 * until_rolling, {});
    CHECK(sim.body_motion(0).velocity.x == Approx(u0 - 0.5 * mu * g * until_rolling).epsilon(5e-3));
    sim.run(1.0 * until_rolling, {});
    CHECK(sim.body_motion(0).velocity.x == Approx(2.0 * u0 / 3.0).epsilon(5e-3));
    CHECK(sim.body_motion(0).spin == Approx(-2.0 * u0 / 3.0 / R).epsilon(5e-3));
    CHECK(std::fabs(sim.ledger().error) < 1e-3 * sim.ledger().friction);
}

TEST_CASE("free flight follows the parabola and turns at a constant rate") {
    model::Scene scene = test::scene_of(test::concrete());
    scene.gravity = {0.0, -9.81};
    scene.bodies.push_back(test::disks("disk", {{{0.3, 2.0}, R}}, model::NoBonds{}));
    scene.bodies[0].velocity = {3.0, 4.0};
    scene.bodies[0].spin = 7.0;
    observe::Simulation sim(scene, 1);
    sim.run(0.5, {});
    const double t = sim.time();
    const observe::BodyMotion motion = sim.body_motion(0);
    CHECK(motion.centre.x == Approx(0.3 + 3.0 * t).epsilon(1e-12));
    CHECK(motion.centre.y == Approx(2.0 + 4.0 * t - 0.5 * 9.81 * t * t).epsilon(1e-12));
    CHECK(sim.field("rotation", {})[0] == Approx(7.0 * t).epsilon(1e-12));
    CHECK(std::fabs(sim.ledger().error) < 1e-12 * sim.ledger().kinetic);
}

TEST_CASE("a wall that moves pushes a disk to twice its speed") {
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
    scene.step_fraction = 0.02;
    model::Wall wall = test::wall_along("piston", {{-1.1 * R, -1.0}, {-1.1 * R, 1.0}});
    wall.velocity_x = Signal::constant(2.0);
    scene.walls.push_back(wall);
    scene.bodies.push_back(test::disks("disk", {{{0.0, 0.0}, R}}, model::NoBonds{}));
    observe::Simulation sim(scene, 1);
    sim.run(1e-3, {});
    CHECK(sim.body_motion(0).velocity.x == Approx(4.0).epsilon(1e-4));
    CHECK(sim.ledger().work == Approx(sim.ledger().kinetic).epsilon(1e-3));
}

TEST_CASE("a disk rests on the corner of a wall and on the joint of two segments alike") {
    // The same floor in one piece and with a joint under the disk: one contact each, the same force.
    for (const bool jointed : {false, true}) {
        model::Scene scene = test::scene_of(test::bouncing(0.3, 0.5));
        scene.gravity = {0.0, -9.81};
        scene.materials[0].youngs_modulus = 1e7;
        model::Wall wall = floor_wall();
        if (jointed) wall.path.insert(wall.path.begin() + 1, {0.0, 0.0});
        scene.walls.push_back(wall);
        scene.bodies.push_back(test::disks("disk", {{{0.0, R}, R}}, model::NoBonds{}));
        observe::Simulation sim(scene, 1);
        sim.run(0.3, {});
        CHECK(sim.contact_count() == 1);
        CHECK(-sim.wall_force(0).y == Approx(9.81 * sim.body_motion(0).mass).epsilon(1e-3));
    }
}
