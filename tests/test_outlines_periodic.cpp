// Rigid figures in a box that repeats, and figures moved in every way.
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/outline_scenes.hpp"

#include <algorithm>
#include <string>
#include <vector>

using namespace demlua;
using Catch::Approx;

namespace {

void give_all(model::Outline& outline, Vec2 velocity) {
    outline.given_x = Signal::constant(velocity.x);
    outline.given_y = Signal::constant(velocity.y);
    outline.given_spin = Signal::constant(0.0);
}

model::Scene soft() { return test::soft_scene(1.0, 0.4, {0.5, 9.0}); }

model::Scene repeating() {
    model::Scene scene = soft();
    scene.periodic_x = Vec2{0.0, 1.0};
    return scene;
}

std::size_t warnings(const observe::Simulation& sim) {
    const std::vector<std::string> notes = sim.notes();
    return static_cast<std::size_t>(std::count_if(notes.begin(), notes.end(), [](const std::string& note) {
        return note.find("both move as given, so they do not touch") != std::string::npos;
    }));
}

} // namespace

TEST_CASE("two figures meet across the edge of a box that repeats, on both sides", "[outline]") {
    // The one between the other and its image gives all of its motion on, and gets it back from the image: v1' = v2, v2' = v1
    // for equal masses and a restitution of 1.
    model::Scene scene = repeating();
    scene.step_fraction = 0.02;
    scene.outlines.push_back(test::rounded_outline("left", test::box({0.06, 0.0}, {0.1, 0.06})));
    scene.outlines.push_back(test::rounded_outline("right", test::box({0.9399, 0.0}, {0.1, 0.06})));
    const double v = 0.5;
    SECTION("across the edge") {
        scene.outlines[0].velocity = {-v, 0.0};
        observe::Simulation sim(scene, 1);
        sim.run(0.06, {});
        CHECK(sim.wall_motion(0).velocity.x == Approx(0.0).margin(2e-3 * v));
        CHECK(sim.wall_motion(1).velocity.x == Approx(-v).epsilon(2e-3));
    }
    SECTION("a figure as wide as what is left meets it on either side") {
        scene.outlines[1].path = test::box({0.56, 0.0}, {0.898, 0.06});
        scene.outlines[0].velocity = {-v, 0.0};
        observe::Simulation sim(scene, 1);
        const double m1 = sim.wall_motion(0).mass;
        const double m2 = sim.wall_motion(1).mass;
        sim.run(0.01, {});
        // v1' = (m1 - m2) v1/(m1 + m2), then the gap of 2 mm is crossed and it meets the other side.
        const double back = -(m1 - m2) / (m1 + m2) * v;
        double most = 0.0;
        double least = 0.0;
        sim.run(0.1, {test::watching(1e-4, [&](observe::Simulation& now) {
                    most = std::max(most, now.wall_motion(0).velocity.x);
                    least = std::min(least, now.wall_motion(0).velocity.x);
                })});
        CHECK(most == Approx(back).epsilon(5e-3));
        CHECK(least < -0.9 * v);
    }
}

TEST_CASE("a figure that would meet its own image is refused", "[outline]") {
    model::Scene scene = repeating();
    SECTION("one that may turn, by its longest line") {
        scene.outlines.push_back(test::rounded_outline("bar", test::box({0.5, 0.0}, {0.96, 0.4})));
        CHECK_THROWS_WITH(observe::Simulation(scene, 1),
                          Catch::Matchers::ContainsSubstring("\"bar\": is 1.04 m across where it is longest and would "
                                                             "meet its own image"));
        scene.outlines[0].given_spin = Signal::constant(0.0);
        CHECK_NOTHROW(observe::Simulation(scene, 1));
        observe::Simulation sim(scene, 1);
        scene.outlines[0].given_spin.reset();
        CHECK_THROWS_WITH(sim.replace_outline(0, scene.outlines[0]),
                          Catch::Matchers::ContainsSubstring("meet its own image"));
    }
    SECTION("one that does not, by its width") {
        scene.outlines.push_back(test::rounded_outline("platen", test::box({0.5, 0.0}, {1.0, 0.1})));
        give_all(scene.outlines[0], {});
        CHECK_NOTHROW(observe::Simulation(scene, 1));
        scene.outlines[0].path = test::box({0.5, 0.0}, {1.1, 0.1});
        CHECK_THROWS_WITH(observe::Simulation(scene, 1), Catch::Matchers::ContainsSubstring("is 1.1 m across and"));
    }
}

TEST_CASE("a figure across a wall by way of the edge is found", "[outline]") {
    model::Scene scene = repeating();
    scene.walls.push_back(test::wall_along("post", {{0.02, -0.1}, {0.02, 0.1}}));
    scene.outlines.push_back(test::rounded_outline("box", test::box({0.98, 0.0}, {0.1, 0.06})));
    CHECK_THROWS_WITH(observe::Simulation(scene, 1), Catch::Matchers::ContainsSubstring("lies across wall \"post\""));
    SECTION("and so is an element in it") {
        scene.walls.clear();
        scene.bodies.push_back(test::disks("inside", {{{0.01, 0.0}, 5e-3}}, model::NoBonds{}));
        CHECK_THROWS_WITH(observe::Simulation(scene, 1),
                          Catch::Matchers::ContainsSubstring("holds an element of body \"inside\""));
    }
}

TEST_CASE("figures moved in every way pass through walls and each other, and say so once", "[outline]") {
    model::Scene scene = soft();
    scene.walls.push_back(test::wall_along("floor", {{-1.0, 0.0}, {1.0, 0.0}}));
    scene.outlines.push_back(test::rounded_outline("box", test::box({0.0, 0.06}, {0.1, 0.1})));
    scene.outlines.push_back(test::rounded_outline("other", test::box({0.0, -0.2}, {0.1, 0.1})));
    give_all(scene.outlines[0], {0.0, -1.0});
    give_all(scene.outlines[1], {});
    observe::Simulation sim(scene, 1);
    CHECK(warnings(sim) == 0);
    sim.run(0.005, {});
    CHECK(warnings(sim) == 0);
    sim.run(0.02, {});
    CHECK(warnings(sim) == 1);
    CHECK(sim.notes().back().find("outline \"box\" lies across wall \"floor\" at (") != std::string::npos);
    CHECK(sim.wall_motion(0).force == Vec2{});
    sim.run(0.2, {});
    CHECK(warnings(sim) == 2);
    CHECK(sim.notes().back().find("\"box\"") != std::string::npos);
    CHECK(sim.notes().back().find("\"other\"") != std::string::npos);
    CHECK(sim.wall_motion(2).force == Vec2{});
}
