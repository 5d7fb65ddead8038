// Rigid figures that meet each other and walls, with their corners.
#include "engine/state/corners.hpp"
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/outline_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double g = 9.81;
constexpr double pi = std::numbers::pi;

model::Scene soft(double restitution, double friction) { return test::soft_scene(restitution, friction, {9.0, 9.0}); }

Vec2 direction(double angle) { return turned({1.0, 0.0}, angle); }

} // namespace

TEST_CASE("disks in the corners of a figure touch its sides from within", "[outline]") {
    SECTION("a right angle: the middle is a radius from both sides") {
        const auto corners = state::corners_of_path(test::box({1.0, 2.0}, {0.2, 0.1}), 0.01);
        REQUIRE(corners.size() == 4);
        CHECK(corners[0].radius == Approx(0.01).epsilon(1e-12));
        CHECK(norm(corners[0].centre - Vec2{0.91, 1.96}) < 1e-12);
        CHECK(norm(corners[2].centre - Vec2{1.09, 2.04}) < 1e-12);
    }
    SECTION("clockwise as well, and short sides make them smaller") {
        std::vector<Vec2> path = test::box({}, {0.2, 0.02});
        std::reverse(path.begin(), path.end());
        const auto corners = state::corners_of_path(path, 0.01);
        REQUIRE(corners.size() == 4);
        for (const state::Corner& corner : corners) {
            CHECK(corner.radius == Approx(0.005).epsilon(1e-12));
            CHECK(std::fabs(corner.centre.y) == Approx(0.005).epsilon(1e-12));
        }
    }
    SECTION("none where a figure turns inwards or goes straight on") {
        const auto corners = state::corners_of_path(
            {{0.0, 0.0}, {0.1, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.1, 0.1}, {0.1, 0.3}, {0.0, 0.3}}, 0.01);
        REQUIRE(corners.size() == 7);
        for (std::size_t k = 0; k < corners.size(); ++k) CHECK(corners[k].meets == (k != 1 && k != 4));
        CHECK(norm(corners[1].centre - Vec2{0.1, 0.01}) < 1e-12);
        CHECK(norm(corners[4].centre - Vec2{0.09, 0.09}) < 1e-12);
    }
    SECTION("an equilateral triangle: 2 r from the corner, towards the middle") {
        const auto corners =
            state::corners_of_path({direction(0.5 * pi), direction(7.0 * pi / 6.0), direction(11.0 * pi / 6.0)}, 0.1);
        REQUIRE(corners.size() == 3);
        CHECK(norm(corners[0].centre - Vec2{0.0, 0.8}) < 1e-12);
    }
    SECTION("a flat triangle holds them") {
        for (const state::Corner& corner : state::corners_of_path({{-1.0, 0.0}, {1.0, 0.0}, {0.0, 0.01}}, 1.0)) {
            CHECK(corner.centre.y >= (1.0 - 1e-9) * corner.radius);
            CHECK(corner.radius > 1e-4);
        }
    }
}

TEST_CASE("a box comes back from a wall with the restitution asked for", "[outline]") {
    // On a side, two contacts; on a corner under the centre of mass, one. It does not turn.
    const double e = GENERATE(1.0, 0.6, 0.3);
    const bool on_corner = GENERATE(false, true);
    model::Scene scene = soft(e, 0.4);
    scene.step_fraction = 0.02;
    scene.walls.push_back(test::wall_along("floor", {{-1.0, 0.0}, {1.0, 0.0}}));
    const double half = on_corner ? 0.05 * std::numbers::sqrt2 - (std::numbers::sqrt2 - 1.0) * 4e-3 : 0.05;
    scene.outlines.push_back(
        test::rounded_outline("box", test::box({0.0, half + 1e-4}, {0.1, 0.1}, on_corner ? 0.25 * pi : 0.0)));
    const double v = 0.5;
    scene.outlines[0].velocity = {0.0, -v};
    observe::Simulation sim(scene, 1);
    std::size_t most = 0;
    sim.run(0.01, {test::watching(0.0, [&](observe::Simulation& now) { most = std::max(most, now.contact_count()); })});
    const observe::WallMotion after = sim.wall_motion(1);
    CHECK(most == (on_corner ? 1 : 2));
    CHECK(sim.contact_count() == 0);
    CHECK(after.velocity.y == Approx(e * v).epsilon(2e-3));
    CHECK(std::fabs(after.spin) < 1e-9);
    CHECK(std::fabs(after.velocity.x) < 1e-9 * v);
    const double energy = 0.5 * after.mass * v * v;
    CHECK(std::fabs(sim.ledger().error) < 1e-3 * energy);
}

TEST_CASE("a box on a floor comes to rest and bears its weight", "[outline]") {
    // On two springs: it sinks by M g/(2 K). The same across the edge of a box that repeats, on a floor that goes on there.
    const bool repeats = GENERATE(false, true);
    model::Scene scene = soft(0.3, 0.4);
    scene.gravity = {0.0, -g};
    if (repeats) {
        scene.bodies[0] = test::disks("far", {{{0.1, 9.0}, 5e-3}}, model::NoBonds{});
        scene.periodic_x = Vec2{-0.3, 0.7};
    }
    scene.walls.push_back(test::wall_along("floor", {{-0.3, 0.0}, {0.2, 0.0}, {0.7, 0.0}}));
    scene.outlines.push_back(test::rounded_outline("box", test::box({repeats ? -0.31 : 0.18, 0.051}, {0.2, 0.1})));
    observe::Simulation sim(scene, 1);
    sim.run(0.2, {});
    const observe::WallMotion rest = sim.wall_motion(1);
    CHECK(sim.wall_motion(0).force.y == Approx(-rest.mass * g).epsilon(1e-6));
    CHECK(rest.force.y == Approx(rest.mass * g).epsilon(1e-6));
    const double sunk = 0.05 - rest.position.y;
    CHECK(sunk == Approx(rest.mass * g / (2.0 * sim.state().walls[0].rules[0].Kn)).epsilon(1e-4));
    CHECK(std::fabs(rest.position.x - (repeats ? -0.31 : 0.18)) < 1e-9);
    CHECK(sim.ledger().kinetic < 1e-12 * sim.ledger().contacts);
    CHECK(std::fabs(sim.ledger().error) < 5e-3 * rest.mass * g * 1e-3);
}

TEST_CASE("two boxes that collide head-on exchange what masses say", "[outline]") {
    // v1' = (m1 - e m2) v1/(m1 + m2), v2' = (1 + e) m1 v1/(m1 + m2).
    const double e = GENERATE(1.0, 0.5);
    model::Scene scene = soft(e, 0.4);
    scene.step_fraction = 0.02;
    scene.outlines.push_back(test::rounded_outline("left", test::box({0.0, 0.0}, {0.1, 0.06})));
    scene.outlines.push_back(test::rounded_outline("right", test::box({0.1501, 0.0}, {0.2, 0.1})));
    const double v = 0.5;
    scene.outlines[0].velocity = {v, 0.0};
    observe::Simulation sim(scene, 1);
    const observe::Momentum before = sim.momentum();
    sim.run(0.01, {});
    const observe::WallMotion left = sim.wall_motion(0);
    const observe::WallMotion right = sim.wall_motion(1);
    const double together = left.mass + right.mass;
    CHECK(left.velocity.x == Approx((left.mass - e * right.mass) * v / together).margin(2e-3 * v));
    CHECK(right.velocity.x == Approx((1.0 + e) * left.mass * v / together).margin(2e-3 * v));
    CHECK(sim.momentum().linear.x == Approx(before.linear.x).epsilon(1e-12));
    CHECK(std::fabs(sim.momentum().angular - before.angular) < 1e-12 * before.linear.x * 0.1);
    CHECK(std::fabs(left.spin) + std::fabs(right.spin) < 1e-9);
    if (e == 1.0) CHECK(sim.ledger().kinetic == Approx(0.5 * left.mass * v * v).epsilon(1e-3));
}

TEST_CASE("figures that collide askew with friction exchange momentum exactly", "[outline]") {
    // To rounding; energy goes to friction and dashpots alone.
    model::Scene scene = soft(0.6, 0.3);
    scene.step_fraction = 0.02;
    scene.outlines.push_back(test::rounded_outline("box", test::box({0.0, 0.0}, {0.1, 0.06}, 0.3)));
    scene.outlines.push_back(test::rounded_outline("wedge", {{0.07, 0.03}, {0.2, 0.0}, {0.18, 0.12}}));
    scene.outlines[0].velocity = {1.0, 0.4};
    scene.outlines[1].spin = 3.0;
    observe::Simulation sim(scene, 1);
    const observe::Momentum before = sim.momentum();
    const double energy = sim.ledger().kinetic;
    sim.run(0.03, {});
    const observe::Momentum after = sim.momentum();
    CHECK(sim.ledger().friction > 0.0);
    CHECK(sim.ledger().kinetic < energy);
    CHECK(norm(after.linear - before.linear) < 1e-10 * norm(before.linear));
    CHECK(std::fabs(after.angular - before.angular) < 1e-10 * norm(before.linear) * 0.1);
    CHECK(std::fabs(sim.ledger().error) < 2e-3 * energy);
}

TEST_CASE("a box holds on an incline below the angle of friction and slides above", "[outline]") {
    // Above: it gains g (sin a - mu cos a) a second along the slope, however its two corners share the load.
    const double mu = 0.4;
    const bool slides = GENERATE(false, true);
    const double a = std::atan(mu) + (slides ? 0.1 : -0.05);
    model::Scene scene = soft(0.2, mu);
    scene.gravity = {0.0, -g};
    scene.walls.push_back(
        test::wall_along("slope", {-1.0 * direction(-a), {}, 0.3 * direction(-a), 1.0 * direction(-a)}));
    scene.outlines.push_back(
        test::rounded_outline("box", test::box(0.025 * turned_left(direction(-a)), {0.2, 0.05}, -a)));
    observe::Simulation sim(scene, 1);
    sim.run(0.1, {});
    const auto along = [&] { return dot(sim.wall_motion(1).velocity, direction(-a)); };
    const double before = along();
    const Vec2 place = sim.wall_motion(1).position;
    sim.run(0.2, {});
    if (slides) {
        CHECK((along() - before) / 0.2 == Approx(g * (std::sin(a) - mu * std::cos(a))).epsilon(2e-3));
        CHECK(std::fabs(sim.wall_motion(1).angle) < 1e-4);
    } else {
        CHECK(std::fabs(along()) < 1e-8);
        CHECK(norm(sim.wall_motion(1).position - place) < 1e-8);
    }
    CHECK(std::fabs(sim.ledger().error) < 2e-3 * (sim.ledger().friction + sim.ledger().contact_damping));
}

TEST_CASE("a stack of boxes under a servo lid stands, in any order of saying", "[outline]") {
    // Three boxes, the middle one narrower: every face bears the lid's force and the weight above it.
    const bool reversed = GENERATE(false, true);
    model::Scene scene = soft(0.3, 0.5);
    scene.gravity = {0.0, -g};
    scene.walls.push_back(test::wall_along("floor", {{-0.3, 0.0}, {0.3, 0.0}}));
    scene.walls.push_back(test::wall_along("lid", {{-0.3, 0.152}, {0.3, 0.152}}));
    scene.walls[1].servo.emplace();
    const double F = 2000.0;
    scene.walls[1].servo->force_y = Signal::constant(F);
    scene.outlines.push_back(test::rounded_outline("low", test::box({0.0, 0.0251}, {0.2, 0.05})));
    scene.outlines.push_back(test::rounded_outline("middle", test::box({0.01, 0.0752}, {0.1, 0.05})));
    scene.outlines.push_back(test::rounded_outline("high", test::box({0.0, 0.1253}, {0.2, 0.05})));
    for (model::Outline& each : scene.outlines) each.given_x.reset();
    if (reversed) std::reverse(scene.outlines.begin(), scene.outlines.end());
    // What presses is found by the middle of all elements.
    scene.bodies[0] = test::disks("far", {{{9.0, 0.07}, 5e-3}}, model::NoBonds{});
    observe::Simulation sim(scene, 1);
    sim.run(0.5, {});
    double weight = 0.0;
    for (std::size_t row = 2; row < 5; ++row) weight += g * sim.wall_motion(row).mass;
    CHECK(sim.wall_motion(1).force.y == Approx(F).epsilon(1e-3));
    CHECK(-sim.wall_motion(0).force.y == Approx(F + weight).epsilon(1e-3));
    CHECK(sim.contact_count() == 8);
}

TEST_CASE("figures that would pass through each other stop the run", "[outline]") {
    model::Scene scene = soft(0.6, 0.3);
    scene.walls.push_back(test::wall_along("floor", {{-1.0, 0.0}, {1.0, 0.0}}));
    scene.outlines.push_back(test::rounded_outline("box", test::box({0.0, 0.06}, {0.1, 0.1})));
    SECTION("pressed in") {
        // Overlap v sqrt(M/2 K) is beyond half the rounding.
        scene.materials[0].youngs_modulus = 1e6;
        scene.outlines[0].velocity = {0.0, -5.0};
        scene.step_fraction = 0.02;
        observe::Simulation sim(scene, 1);
        CHECK_THROWS_WITH(sim.run(0.1, {}), Catch::Matchers::ContainsSubstring(
                                                "a corner of outline \"box\" has been pressed into wall \"floor\""));
    }
    SECTION("too fast") {
        scene.outlines[0].velocity = {0.0, -1e3};
        observe::Simulation sim(scene, 1);
        CHECK_THROWS_WITH(sim.run(0.1, {}),
                          Catch::Matchers::ContainsSubstring("outline \"box\" moved at (0, -1000) m/s"));
    }
    SECTION("at the greatest moves allowed nothing gets through") {
        scene.materials[0].youngs_modulus = 1e3;
        scene.greatest_move = 0.5;
        const double dt = observe::Simulation(scene, 1).state().dt;
        for (int phase = 0; phase < 10; ++phase) {
            model::Scene fast = scene;
            fast.outlines[0].path = test::box({0.0, 0.05 + 1e-4 * phase}, {0.1, 0.1});
            fast.outlines[0].velocity = {0.0, -0.499 * 4e-3 / dt};
            observe::Simulation sim(fast, 1);
            CHECK_THROWS_WITH(sim.run(20.0 * dt, {}), Catch::Matchers::ContainsSubstring("into wall \"floor\""));
        }
    }
    SECTION("across a wall at the start") {
        scene.outlines[0].path = test::box({0.0, 0.02}, {0.1, 0.1});
        CHECK_THROWS_WITH(observe::Simulation(scene, 1),
                          Catch::Matchers::ContainsSubstring("lies across wall \"floor\""));
    }
    SECTION("one in the other at the start") {
        scene.outlines.push_back(test::rounded_outline("inner", test::box({0.0, 0.06}, {0.02, 0.02})));
        CHECK_THROWS_WITH(observe::Simulation(scene, 1),
                          Catch::Matchers::ContainsSubstring("\"inner\": lies across outline \"box\""));
    }
    SECTION("a corner in a wall at the start") {
        scene.outlines[0].path = test::box({0.0, 0.049}, {0.1, 0.1});
        CHECK_THROWS_WITH(observe::Simulation(scene, 1),
                          Catch::Matchers::ContainsSubstring("\"floor\" with a corner, by 25 % of its rounding"));
    }
    SECTION("not where one stands in the notch of another") {
        scene.outlines.push_back(
            test::rounded_outline("ell", {{0.2, 0.0}, {0.5, 0.0}, {0.5, 0.05}, {0.25, 0.05}, {0.25, 0.3}, {0.2, 0.3}}));
        scene.outlines.push_back(test::rounded_outline("inner", test::box({0.3, 0.1}, {0.1, 0.1})));
        CHECK_NOTHROW(observe::Simulation(scene, 1));
    }
    SECTION("let go where it lies across a wall") {
        scene.outlines[0].path = test::box({0.0, 0.02}, {0.1, 0.1});
        scene.outlines[0].given_x = scene.outlines[0].given_y = scene.outlines[0].given_spin = Signal::constant(0.0);
        observe::Simulation sim(scene, 1); // what is moved in every way meets no wall
        sim.run(1e-4, {});
        CHECK(sim.wall_motion(0).force == Vec2{});
        scene.outlines[0].given_y.reset();
        CHECK_THROWS_WITH(sim.replace_outline(0, scene.outlines[0]),
                          Catch::Matchers::ContainsSubstring("\"box\" and \"floor\" meet"));
    }
}
