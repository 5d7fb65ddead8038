// Rigid figures: mass, free and given motion, contact with elements.
#include "engine/model/figure.hpp"
#include "engine/step/time_step.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;
constexpr double pi = std::numbers::pi;

/// Corners of a rectangle of this size about `centre`.
std::vector<Vec2> box(Vec2 centre, Vec2 size) {
    const Vec2 h = 0.5 * size;
    return {centre + Vec2{-h.x, -h.y}, centre + Vec2{h.x, -h.y}, centre + Vec2{h.x, h.y}, centre + Vec2{-h.x, h.y}};
}

model::Outline outline(std::vector<Vec2> path) {
    model::Outline made;
    made.name = "block";
    made.path = std::move(path);
    return made;
}

void hold_all(model::Scene& scene) {
    model::Support held;
    held.selection = test::all_of(0);
    scene.supports.push_back(held);
}

/// Angular momentum of the outline about a point, kg m^2/s.
double angular_about(const observe::WallMotion& motion, Vec2 point) {
    return motion.mass * cross(motion.position - point, motion.velocity) + motion.inertia * motion.spin;
}

} // namespace

TEST_CASE("area, centre and polar moment of figures", "[outline]") {
    const Vec2 away{1e3, -2e3}; // digits must not be lost there
    const auto moved = [&](std::vector<Vec2> corners) {
        for (Vec2& corner : corners) corner += away;
        return model::figure_of(corners);
    };
    SECTION("rectangle: a b (a^2 + b^2)/12") {
        const model::Figure figure = moved(box({}, {0.3, 0.2}));
        CHECK(figure.area == Approx(0.06).epsilon(1e-9));
        CHECK(figure.polar == Approx(0.06 * 0.13 / 12.0).epsilon(1e-9));
        CHECK(norm(figure.centre - away) < 1e-9);
    }
    SECTION("right triangle, clockwise: b h/2, centre at a third, b h (b^2 + h^2)/36") {
        const model::Figure figure = moved({{0.0, 0.0}, {0.0, 0.4}, {0.3, 0.0}});
        CHECK(figure.area == Approx(0.06).epsilon(1e-9));
        CHECK(norm(figure.centre - away - Vec2{0.1, 0.4 / 3.0}) < 1e-9);
        CHECK(figure.polar == Approx(0.12 * 0.25 / 36.0).epsilon(1e-9));
    }
    SECTION("regular hexagon of side s: 3 sqrt(3)/2 s^2, 5 sqrt(3)/8 s^4") {
        std::vector<Vec2> corners;
        corners.reserve(6);
        for (int k = 0; k < 6; ++k) corners.push_back(turned({0.2, 0.0}, pi * k / 3.0));
        const model::Figure figure = moved(corners);
        CHECK(figure.area == Approx(1.5 * std::sqrt(3.0) * 0.04).epsilon(1e-9));
        CHECK(figure.polar == Approx(0.625 * std::sqrt(3.0) * 0.0016).epsilon(1e-9));
    }
    SECTION("an L of two squares' strips, by Steiner") {
        const model::Figure figure = moved({{0.0, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.1, 0.1}, {0.1, 0.3}, {0.0, 0.3}});
        const Vec2 foot{0.1, 0.05};
        const Vec2 leg{0.05, 0.2};
        const Vec2 centre = 0.5 * (foot + leg); // both have 0.02 m^2
        const auto part = [&](Vec2 at) { return 0.02 * (0.05 / 12.0 + dot(at - centre, at - centre)); };
        CHECK(figure.area == Approx(0.04).epsilon(1e-9));
        CHECK(norm(figure.centre - away - centre) < 1e-9);
        CHECK(figure.polar == Approx(part(foot) + part(leg)).epsilon(1e-9));
    }
}

TEST_CASE("a free outline flies as a stone does", "[outline]") {
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
    scene.gravity = {0.0, -9.81};
    scene.bodies.push_back(test::disks("far", {{{9.0, 9.0}, R}}, model::NoBonds{}));
    scene.outlines.push_back(outline(box({0.3, 2.0}, {0.3, 0.2})));
    scene.outlines[0].velocity = {3.0, 4.0};
    scene.outlines[0].spin = 7.0;
    observe::Simulation sim(scene, 1);
    sim.run(0.02, {});
    const double t = sim.time();
    const observe::WallMotion motion = sim.wall_motion(0);
    CHECK(motion.mass == Approx(2400.0 * 0.06).epsilon(1e-12));
    CHECK(motion.inertia == Approx(2400.0 * 0.06 * 0.13 / 12.0).epsilon(1e-12));
    CHECK(motion.position.x == Approx(0.3 + 3.0 * t).epsilon(1e-10));
    CHECK(motion.position.y == Approx(2.0 + 4.0 * t - 0.5 * 9.81 * t * t).epsilon(1e-10));
    CHECK(motion.velocity.y == Approx(4.0 - 9.81 * t).epsilon(1e-10));
    CHECK(motion.angle == Approx(7.0 * t).epsilon(1e-10));
    CHECK(sim.ledger().kinetic + sim.ledger().potential ==
          Approx(0.5 * motion.mass * 25.0 + 0.5 * motion.inertia * 49.0).epsilon(1e-10));
}

TEST_CASE("an outline hits a disk that is held", "[outline]") {
    // Impulse J = 2 v/(1/M + a^2/I) along the normal at arm a, without friction: v' = v - J/M, w' = J a/I. Energy stays, and
    // so does angular momentum about the disk, through whose centre the force goes.
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
    scene.step_fraction = 0.02;
    scene.bodies.push_back(test::disks("disk", {{{0.0, 0.0}, R}}, model::NoBonds{}));
    hold_all(scene);
    const double a = GENERATE(0.0, 0.01, 0.03); // the disk is hit this far left of the centre of mass
    scene.outlines.push_back(outline(box({a, R + 0.0201}, {0.08, 0.04})));
    const double v = 1.5;
    scene.outlines[0].velocity = {0.0, -v};
    observe::Simulation sim(scene, 1);
    const observe::WallMotion before = sim.wall_motion(0);
    sim.run(2e-3, {});
    const observe::WallMotion after = sim.wall_motion(0);
    const double J = 2.0 * v / (1.0 / before.mass + a * a / before.inertia);
    CHECK(sim.contact_count() == 0);
    CHECK(after.velocity.y == Approx(-v + J / before.mass).margin(2e-3 * v));
    CHECK(after.spin == Approx(-J * a / before.inertia).epsilon(2e-3).margin(1e-9));
    const double energy = 0.5 * before.mass * v * v;
    CHECK(sim.ledger().kinetic == Approx(energy).epsilon(1e-4));
    CHECK(std::fabs(sim.ledger().error) < 1e-4 * energy);
    CHECK(angular_about(after, {}) == Approx(angular_about(before, {})).margin(1e-4 * before.mass * v * 0.04));
}

TEST_CASE("an outline and a disk exchange momentum exactly", "[outline]") {
    // Off centre, with friction and spin: linear and angular momentum of both together stay to rounding.
    model::Scene scene = test::scene_of(test::bouncing(0.6, 0.4));
    scene.step_fraction = 0.02;
    scene.bodies.push_back(test::disks("disk", {{{0.0, 0.0}, 2.0 * R}}, model::NoBonds{}));
    scene.bodies[0].spin = 40.0;
    scene.outlines.push_back(outline({{-0.03, 2.1 * R}, {0.05, 2.1 * R + 0.01}, {0.01, 0.06}}));
    scene.outlines[0].velocity = {0.5, -3.0};
    scene.outlines[0].spin = 5.0;
    observe::Simulation sim(scene, 1);
    const observe::Momentum before = sim.momentum();
    sim.run(2e-3, {});
    const observe::Momentum after = sim.momentum();
    const observe::WallMotion motion = sim.wall_motion(0);
    CHECK(sim.ledger().friction > 0.0);
    CHECK(after.linear.x == Approx(before.linear.x).margin(1e-10 * motion.mass * 3.0));
    CHECK(after.linear.y == Approx(before.linear.y).margin(1e-10 * motion.mass * 3.0));
    CHECK(after.angular == Approx(before.angular).margin(1e-10 * motion.mass * 3.0 * 0.1));
    CHECK(std::fabs(sim.ledger().error) < 2e-3 * (sim.ledger().friction + sim.ledger().contact_damping));
}

TEST_CASE("a box slides to rest over disks that are held", "[outline]") {
    // Both loads of the supports slide, so that the box loses mu g a second whichever way they share its weight.
    const double g = 9.81;
    const double mu = 0.2;
    model::Scene scene = test::scene_of(test::bouncing(0.2, mu));
    scene.materials[0].youngs_modulus = 1e7;
    scene.gravity = {0.0, -g};
    scene.bodies.push_back(test::disks("feet", {{{-0.03, 0.0}, R}, {{0.03, 0.0}, R}}, model::NoBonds{}));
    hold_all(scene);
    scene.outlines.push_back(outline(box({0.0, R + 0.01}, {0.16, 0.02})));
    const double v = 0.2;
    scene.outlines[0].velocity = {v, 0.0};
    observe::Simulation sim(scene, 1);
    const double time = v / (mu * g);
    sim.run(0.7 * time, {});
    CHECK(sim.wall_motion(0).velocity.x == Approx(0.3 * v).epsilon(0.02));
    sim.run(0.6 * time, {});
    CHECK(std::fabs(sim.wall_motion(0).velocity.x) < 0.02 * v);
    CHECK(sim.wall_motion(0).position.x == Approx(0.5 * v * time).epsilon(0.02));
    CHECK(sim.wall_motion(0).force.y == Approx(g * sim.wall_motion(0).mass).epsilon(1e-3));
    CHECK(sim.ledger().friction == Approx(0.5 * sim.wall_motion(0).mass * v * v).epsilon(0.02));
    CHECK(std::fabs(sim.ledger().error) < 2e-3 * sim.ledger().friction);
}

TEST_CASE("an outline that is moved does the work, one let go keeps its speed", "[outline]") {
    // Lifted at speed v for a time t against its weight: M g v t, then a throw of v^2/(2 g).
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
    const double g = 9.81;
    scene.gravity = {0.0, -g};
    scene.bodies.push_back(test::disks("far", {{{9.0, 9.0}, R}}, model::NoBonds{}));
    hold_all(scene);
    scene.outlines.push_back(outline(box({}, {0.2, 0.1})));
    scene.outlines[0].given_x = Signal::constant(0.0);
    scene.outlines[0].given_y = Signal::constant(0.3);
    observe::Simulation sim(scene, 1);
    sim.run(0.02, {});
    const double M = sim.wall_motion(0).mass;
    CHECK(sim.wall_motion(0).position.y == Approx(0.006).epsilon(1e-9));
    CHECK(sim.ledger().potential == Approx(M * g * 0.006).epsilon(1e-9));
    CHECK(sim.ledger().work == Approx(M * g * 0.006).epsilon(1e-9));
    scene.outlines[0].given_x.reset();
    scene.outlines[0].given_y.reset();
    sim.replace_outline(0, scene.outlines[0]);
    double highest = 0.0;
    sim.run(0.05, {test::watching(0.0, [&](observe::Simulation& now) {
                highest = std::max(highest, now.wall_motion(0).position.y);
            })});
    CHECK(highest == Approx(0.006 + 0.3 * 0.3 / (2.0 * g)).epsilon(1e-4));
    CHECK(std::fabs(sim.ledger().error) < 1e-6 * sim.ledger().potential);
}

TEST_CASE("a light outline is allowed for in the time step", "[outline]") {
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.3));
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].density = 20.0;
    std::vector<model::Disk> list;
    list.reserve(8);
    for (int k = 0; k < 8; ++k) list.push_back({{2.2 * R * k, 0.0}, R});
    scene.bodies.push_back(test::disks("row", list, model::NoBonds{}));
    scene.bodies[0].velocity = {0.0, 0.5};
    const double heavy = step::bound_step(observe::Simulation(scene, 1).state());
    scene.outlines.push_back(outline(box({8.0 * R, 2.1 * R}, {20.0 * R, 2.0 * R})));
    scene.outlines[0].material = 1;
    observe::Simulation sim(scene, 1);
    CHECK(step::bound_step(sim.state()) < heavy);
    CHECK(sim.time_step_reason().find("outline block") != std::string::npos);
    const double energy = sim.ledger().kinetic;
    sim.run(5e-3, {});
    CHECK(sim.wall_motion(0).velocity.y > 0.5);
    CHECK(std::fabs(sim.ledger().error) < 0.02 * energy);
}

TEST_CASE("an outline counts in the time step by its free motions only", "[outline]") {
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.3));
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].density = 2.0;
    scene.bodies.push_back(test::disks("disk", {{{0.0, 0.0}, R}}, model::NoBonds{}));
    scene.outlines.push_back(outline(box({8.0 * R, 2.1 * R}, {20.0 * R, 2.0 * R})));
    scene.outlines[0].material = 1;
    const auto critical = [&] { return step::bound_step(observe::Simulation(scene, 1).state()); };
    const double free = critical();
    scene.outlines[0].given_spin = Signal::constant(0.0);
    const double along = critical();
    CHECK(along > free);
    scene.outlines[0].given_x = scene.outlines[0].given_y = Signal::constant(0.0);
    const double given = critical();
    CHECK(given > along);
    model::Outline moved = scene.outlines[0];
    scene.outlines.clear();
    scene.walls.push_back(test::wall_along("wall", {{-1.0, -R}, {1.0, -R}}));
    CHECK(given == critical());
    scene.walls.clear();
    scene.outlines.push_back(moved);

    observe::Simulation sim(scene, 1);
    sim.run(1e-4, {});
    const double before = sim.state().dt;
    moved.given_x.reset();
    moved.given_y.reset();
    moved.given_spin.reset();
    sim.replace_outline(0, moved);
    CHECK(sim.state().dt == 0.8 * free);
    CHECK(sim.state().dt < before);
}

TEST_CASE("outlines that cannot be are refused", "[outline]") {
    const auto fault = [](const model::Region& region) {
        model::Outline said;
        said.region = region;
        return model::outline_fault(said);
    };
    using model::Region;
    const Region square = Region::rectangle({0.0, 0.0}, {1.0, 1.0});
    CHECK(fault(square).empty());
    CHECK(fault(square.united(Region::rectangle({0.5, 0.5}, {1.0, 1.0}))).empty());
    CHECK(fault(Region::disc({0.0, 0.0}, 1.0)).find("straight sides") != std::string::npos);
    CHECK(fault(square.without(Region::rectangle({0.4, 0.4}, {0.2, 0.2}))).find("holes") != std::string::npos);
    CHECK(fault(square.united(Region::rectangle({3.0, 0.0}, {1.0, 1.0}))).find("one piece") != std::string::npos);
    CHECK(fault(Region::half_plane({0.0, 0.0}, {1.0, 0.0})).find("an end") != std::string::npos);
    model::Outline crossed = outline({{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}});
    CHECK(model::outline_fault(crossed).find("cross") != std::string::npos);
    crossed.region = square;
    CHECK(model::outline_fault(crossed).find("exactly one") != std::string::npos);
    SECTION("round an element") {
        model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
        scene.bodies.push_back(test::disks("disk", {{{0.0, 0.0}, R}}, model::NoBonds{}));
        scene.outlines.push_back(outline(box({}, {0.1, 0.1})));
        CHECK_THROWS_WITH(observe::Simulation(scene, 1),
                          Catch::Matchers::ContainsSubstring("holds an element of body \"disk\""));
    }
}
