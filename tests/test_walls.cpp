// Walls: search, forces, turning, closed paths, and what stops a run.
#include "engine/model/figure.hpp"
#include "engine/state/state.hpp"
#include "engine/step/wall_parts.hpp"
#include "engine/step/wall_search.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <set>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;

/// Grains a little apart over a rough floor, some between its teeth.
model::Scene over_teeth() {
    model::Scene scene = test::scene_of(test::bouncing(0.5, 0.4));
    scene.materials[0].youngs_modulus = 1e7;
    scene.gravity = {0.0, -9.81};
    scene.walls.push_back(test::wall_along("rough", model::sawtooth({-0.05, -0.01}, {0.45, 0.01}, 1e-3, 1.5e-3)));
    scene.walls.push_back(test::wall_along("box", {{-0.05, 0.4}, {-0.05, -0.01}, {0.45, -0.01}, {0.45, 0.4}}));
    std::vector<model::Disk> list;
    for (int row = 0; row < 32; ++row) {
        for (int column = 0; column < 36; ++column) {
            const double size = R * (0.8 + 0.2 * ((7 * row + 3 * column) % 5) / 5.0);
            list.push_back({{0.013 * column - 0.03, 0.025 + 0.011 * row}, size});
        }
    }
    scene.bodies.push_back(test::disks("bed", list, model::NoBonds{}));
    scene.bodies[0].velocity = {0.3, -1.0};
    return scene;
}

} // namespace

TEST_CASE("walls list every element in reach of their parts, and no other", "[walls]") {
    // Against all pairs of element and part.
    observe::Simulation sim(over_teeth(), 1);
    sim.run(0.02, {});
    state::State state = sim.state();
    std::vector<Vec2> points;
    for (std::size_t e = 0; e < state.elements.size(); ++e) points.push_back(state.elements.position(e));
    for (const double skin : {1e-4, 4e-3, 3e-2}) {
        const step::Places places = step::places_of(state, 2.0 * R + skin);
        CellGrid grid;
        grid.build(places.at, 2.0 * R + skin);
        step::refresh_wall_contacts(state, skin, places, grid);
        using Key = std::array<std::size_t, 3>;
        std::set<Key> wanted;
        for (std::size_t w = 0; w < state.walls.size(); ++w) {
            for (std::size_t e = 0; e < points.size(); ++e) {
                for (std::size_t part = 0; part < state.walls[w].parts(); ++part) {
                    const double gap = step::distance_to_part(state.walls[w], part, points[e]);
                    if (gap < state.elements.radius[e] + skin) wanted.insert({w, e, part});
                }
            }
        }
        std::vector<Key> found;
        for (std::size_t c = 0; c < state.wall_contacts.size(); ++c) {
            found.push_back({state.wall_contacts.wall[c], state.wall_contacts.element[c], state.wall_contacts.part[c]});
        }
        CHECK(found.size() > 20);
        CHECK(found == std::vector<Key>(wanted.begin(), wanted.end()));
    }
}

TEST_CASE("a bed on a rough wall moves the same on any number of threads", "[walls]") {
    std::vector<std::uint64_t> hashes;
    std::vector<double> forces;
    for (const int threads : {1, 2, 3}) {
        observe::Simulation sim(over_teeth(), {threads, 1});
        sim.run(0.03, {});
        CHECK(sim.state().wall_contacts.size() > 1024); // else the loop is not shared
        hashes.push_back(sim.hash());
        forces.push_back(sim.wall_motion(0).force.y);
    }
    CHECK(hashes[1] == hashes[0]);
    CHECK(hashes[2] == hashes[0]);
    CHECK(forces[1] == forces[0]);
    CHECK(forces[2] == forces[0]);
}

TEST_CASE("a closed path has no open corner", "[walls]") {
    // A disk inside a triangle rests in the lower corner on two sides, each with m g/(2 cos a) at a from the vertical; one
    // that stands on the upper corner of a square meets its point alone.
    const double g = 9.81;
    SECTION("inside a corner") {
        model::Scene scene = test::scene_of(test::bouncing(0.2, 0.0));
        scene.materials[0].youngs_modulus = 1e7;
        scene.gravity = {0.0, -g};
        scene.walls.push_back(test::wall_along("funnel", {{0.0, 0.0}, {0.1, 0.1}, {-0.1, 0.1}, {0.0, 0.0}}));
        scene.bodies.push_back(test::disks("disk", {{{0.0, std::numbers::sqrt2 * R}, R}}, model::NoBonds{}));
        observe::Simulation sim(scene, 1);
        sim.run(0.3, {});
        CHECK(sim.state().walls[0].closed);
        CHECK(sim.state().walls[0].path.size() == 3);
        CHECK(sim.contact_count() == 2);
        const double weight = g * sim.body_motion(0).mass;
        CHECK(-sim.wall_motion(0).force.y == Approx(weight).epsilon(1e-6));
        const double overlap = weight / std::numbers::sqrt2 / sim.state().walls[0].rules[0].Kn;
        CHECK(std::numbers::sqrt2 * (R - overlap) == Approx(sim.body_motion(0).centre.y).epsilon(1e-6));
    }
    SECTION("a circle whose points come back to rounding only") {
        std::vector<Vec2> circle;
        for (int k = 0; k <= 60; ++k) circle.push_back(turned({0.1, 0.0}, 2.0 * std::numbers::pi * k / 60.0));
        REQUIRE_FALSE(circle.front() == circle.back());
        model::Scene scene = test::scene_of(test::bouncing(0.2, 0.0));
        scene.walls.push_back(test::wall_along("drum", circle));
        scene.bodies.push_back(test::disks("disk", {{{}, R}}, model::NoBonds{}));
        const observe::Simulation sim(scene, 1);
        CHECK(sim.state().walls[0].closed);
        CHECK(sim.state().walls[0].path.size() == 60);
    }
    SECTION("on the point where the path begins") {
        model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
        scene.step_fraction = 0.05;
        scene.walls.push_back(
            test::wall_along("square", {{0.0, 0.0}, {0.1, -0.1}, {0.0, -0.2}, {-0.1, -0.1}, {0.0, 0.0}}));
        scene.bodies.push_back(test::disks("disk", {{{0.0, 1.05 * R}, R}}, model::NoBonds{}));
        scene.bodies[0].velocity = {0.0, -1.0};
        observe::Simulation sim(scene, 1);
        std::size_t most = 0;
        sim.run(1e-3,
                {test::watching(0.0, [&](observe::Simulation& now) { most = std::max(most, now.contact_count()); })});
        CHECK(most == 1);
        CHECK(sim.body_motion(0).velocity.x == 0.0);
        CHECK(sim.body_motion(0).velocity.y == Approx(1.0).epsilon(1e-3));
    }
}

TEST_CASE("a wall turns about its centre and drags along what lies on it", "[walls]") {
    SECTION("geometry") {
        // A point at arm r stands at c + v t + r (cos wt, sin wt).
        model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
        model::Wall blade = test::wall_along("blade", {{0.0, 0.0}, {0.2, 0.0}});
        blade.centre = Vec2{0.0, 0.0};
        blade.spin = Signal::constant(30.0);
        blade.velocity_x = Signal::constant(2.0);
        scene.walls.push_back(blade);
        scene.bodies.push_back(test::disks("far", {{{5.0, 0.0}, R}}, model::NoBonds{}));
        observe::Simulation sim(scene, 1);
        sim.run(0.02, {});
        CHECK(sim.wall_motion(0).angle == Approx(0.6).epsilon(1e-12));
        const Vec2 tip = sim.state().walls[0].points[1];
        CHECK(tip.x == Approx(2.0 * 0.02 + 0.2 * std::cos(0.6)).epsilon(1e-12));
        CHECK(tip.y == Approx(0.2 * std::sin(0.6)).epsilon(1e-12));
    }
    SECTION("a bat") {
        // The disk leaves a heavy bat at twice the speed w a of the place where it is hit; that energy is the wall's work.
        model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
        scene.step_fraction = 0.02;
        model::Wall bat = test::wall_along("bat", {{0.0, 0.0}, {1.0, 0.0}});
        bat.centre = Vec2{0.0, 0.0};
        bat.spin = Signal::constant(4.0);
        scene.walls.push_back(bat);
        scene.bodies.push_back(test::disks("disk", {{{0.5, 1.02 * R}, R}}, model::NoBonds{}));
        observe::Simulation sim(scene, 1);
        double moment = 0.0;
        Vec2 force;
        sim.run(1e-3, {test::watching(0.0, [&](observe::Simulation& now) {
                    if (std::fabs(now.wall_motion(0).moment) < std::fabs(moment)) return;
                    moment = now.wall_motion(0).moment;
                    force = now.wall_motion(0).force;
                })});
        CHECK(norm(sim.body_motion(0).velocity) == Approx(2.0 * 4.0 * 0.5).epsilon(1e-3));
        CHECK(moment == Approx(-0.5 * norm(force)).epsilon(1e-3)); // arm by force
        CHECK(sim.ledger().work == Approx(sim.ledger().kinetic).epsilon(1e-3));
        CHECK(std::fabs(sim.ledger().error) < 1e-3 * sim.ledger().kinetic);
    }
    SECTION("a wheel") {
        // A disk pressed into the closed path of a wheel rolls off it: where both surfaces move alike, w R = W r.
        model::Scene scene = test::scene_of(test::bouncing(0.5, 0.8));
        scene.materials[0].youngs_modulus = 1e7;
        scene.step_fraction = 0.1;
        std::vector<Vec2> circle;
        circle.reserve(400);
        for (int k = 0; k < 400; ++k) {
            circle.push_back(0.02 * turned({0.0, 1.0}, 2.0 * std::numbers::pi * k / 400.0));
        }
        circle.push_back(circle.front());
        model::Wall wheel = test::wall_along("wheel", circle);
        wheel.spin = Signal::constant(10.0);
        scene.walls.push_back(wheel);
        scene.bodies.push_back(test::disks("disk", {{{0.0, 0.02 + R}, R}}, model::NoBonds{}));
        model::Motion held;
        held.selection = test::all_of(0);
        held.velocity_x = Signal::constant(0.0);
        scene.motions.push_back(held);
        model::Force push;
        push.selection = test::all_of(0);
        push.x = Signal::constant(0.0);
        push.y = Signal::constant(-50.0);
        scene.forces.push_back(push);
        observe::Simulation sim(scene, 1);
        sim.run(0.5, {});
        CHECK(sim.body_motion(0).spin == Approx(-10.0 * 0.02 / R).epsilon(2e-3));
        CHECK(std::fabs(sim.ledger().error) < 1e-3 * sim.ledger().work);
    }
}

TEST_CASE("what would pass a wall unseen stops the run", "[walls]") {
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
    scene.walls.push_back(test::wall_along("floor", {{-1.0, 0.0}, {1.0, 0.0}}));
    scene.bodies.push_back(test::disks("shot", {{{0.0, 2.0 * R}, R}}, model::NoBonds{}));
    SECTION("a wall too fast") {
        scene.walls[0].velocity_y = Signal::constant(2e4);
        observe::Simulation sim(scene, 1);
        CHECK_THROWS_WITH(sim.run(1e-3, {}),
                          Catch::Matchers::ContainsSubstring("wall \"floor\" moved at (0, 20000) m/s"));
    }
    SECTION("a wall that turns too fast") {
        scene.walls[0].spin = Signal::constant(2e4);
        observe::Simulation sim(scene, 1);
        CHECK_THROWS_WITH(sim.run(1e-3, {}), Catch::Matchers::ContainsSubstring("wall \"floor\" moved"));
    }
    SECTION("an element pressed through") {
        // Overlap v sqrt(m/K) would be more than half the radius.
        scene.materials[0].youngs_modulus = 1e6;
        scene.bodies[0].velocity = {0.0, -20.0};
        scene.step_fraction = 0.1;
        observe::Simulation sim(scene, 1);
        CHECK_THROWS_WITH(sim.run(1.0, {}), Catch::Matchers::ContainsSubstring("element 0 of body \"shot\"") &&
                                                Catch::Matchers::ContainsSubstring("into wall \"floor\""));
        CHECK(sim.body_motion(0).centre.y > 0.0);
    }
    SECTION("at the greatest moves allowed nothing gets through") {
        // Wall and element at nearly half a radius in a step each, from all phases of a step.
        scene.greatest_move = 0.5;
        scene.materials[0].youngs_modulus = 1e3;
        for (int phase = 0; phase < 20; ++phase) {
            model::Scene fast = scene;
            fast.bodies[0] = test::disks("shot", {{{0.0, (1.05 + 0.05 * phase) * R}, R}}, model::NoBonds{});
            const double dt = observe::Simulation(fast, 1).state().dt;
            fast.bodies[0].velocity = {0.0, -0.499 * R / dt};
            fast.walls[0].velocity_y = Signal::constant(0.499 * R / dt);
            observe::Simulation sim(fast, 1);
            CHECK_THROWS_WITH(sim.run(10.0 * dt, {}), Catch::Matchers::ContainsSubstring("into wall \"floor\""));
        }
    }
    SECTION("an element across a wall at the start") {
        scene.bodies[0] = test::disks("shot", {{{0.0, 0.8 * R}, R}}, model::NoBonds{});
        CHECK_THROWS_WITH(observe::Simulation(scene, 1),
                          Catch::Matchers::ContainsSubstring("\"floor\"") &&
                              Catch::Matchers::ContainsSubstring("\"shot\", by 20 % of its radius"));
    }
}

TEST_CASE("teeth are whole and rise to the left", "[walls]") {
    const std::vector<Vec2> points = model::sawtooth({1.0, 0.0}, {1.0, 0.3}, 0.02, 0.096);
    REQUIRE(points.size() == 7); // three teeth
    CHECK(points.front() == Vec2{1.0, 0.0});
    CHECK(points.back() == Vec2{1.0, 0.3});
    for (const std::size_t peak : {1U, 3U, 5U}) {
        CHECK(points[peak].x == Approx(0.98).epsilon(1e-12));
        CHECK(points[peak].y == Approx(0.05 * static_cast<double>(peak)).epsilon(1e-12));
    }
}
