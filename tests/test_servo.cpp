// Walls that seek a stress or a force.
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;
constexpr double g = 9.81;
/// Along a straight line central difference exchanges just what the ledger counts: error over work is rounding, of some 1e5
/// steps of sums.
constexpr double rounding = 1e-9;

model::Material grains() {
    model::Material material = test::concrete();
    material.youngs_modulus = 1e8;
    material.restitution = 0.5;
    return material;
}

/// `count` disks one upon another on a floor, kept from leaving the line, and a lid above them.
model::Scene column_under_lid(std::size_t count, double gap, const model::Servo& servo) {
    model::Scene scene = test::scene_of(grains());
    constexpr double apart = 1.0 + 1e-7; // so that nothing touches before the lid comes
    std::vector<model::Disk> list;
    for (std::size_t k = 0; k < count; ++k)
        list.push_back({{0.0, apart * (2.0 * static_cast<double>(k) + 1.0) * R}, R});
    scene.bodies.push_back(test::disks("column", list, model::NoBonds{}));
    model::Support upright;
    upright.selection = test::all_of(0);
    upright.y = false;
    scene.supports.push_back(upright);
    const double top = 2.0 * static_cast<double>(count) * R + gap;
    scene.walls.push_back(test::wall_along("floor", {{-R, 0.0}, {R, 0.0}}));
    scene.walls.push_back(test::wall_along("lid", {{-R, top}, {R, top}}));
    scene.walls[1].servo = servo;
    return scene;
}

model::Servo stress_along_y(const Signal& stress) {
    model::Servo servo;
    servo.stress_y = stress;
    return servo;
}

} // namespace

TEST_CASE("a servo lid brings a column to its stress and holds it", "[servo]") {
    constexpr std::size_t count = 12;
    const double stress = 100e3;
    const double gap = 0.3 * R;
    observe::Simulation sim(column_under_lid(count, gap, stress_along_y(Signal::constant(stress))), 1);
    sim.run(0.05, {});
    const auto worst_over = [&](double duration) {
        double worst = 0.0;
        sim.run(duration, {test::watching(0.0, [&](observe::Simulation& now) {
                    worst = std::max(worst, std::fabs(now.wall_motion(1).stress.y / stress - 1.0));
                })});
        return worst;
    };
    const double first = worst_over(0.05);
    const double second = worst_over(0.05);
    CHECK(first < 1e-3);
    CHECK(second <= std::max(first, 1e-9));
    // Springs in series: a wall's at both ends and count - 1 between, under F = stress times width times thickness.
    const double F = stress * 2.0 * R;
    const double wall = sim.state().walls[0].rules[0].Kn;
    const double pair = sim.state().contacts.rules[0].Kn;
    const double shortened = F * (2.0 / wall + static_cast<double>(count - 1) / pair);
    const double top = 2.0 * static_cast<double>(count) * R;
    CHECK(sim.wall_motion(1).position.y == Approx(top - shortened).margin(1e-3 * shortened));
    CHECK(sim.wall_motion(0).stress.y == Approx(stress).epsilon(1e-3));
    CHECK(sim.ledger().contacts == Approx(0.5 * F * shortened).epsilon(3e-3));
    CHECK(std::fabs(sim.ledger().error) < rounding * sim.ledger().work);
}

TEST_CASE("a servo follows a stress that changes, and lets go", "[servo]") {
    // Slow against the column's own motion: then the lid keeps up.
    const Signal stress{{0.0, 0.1, 0.4, 0.5, 0.8}, {50e3, 50e3, 200e3, 200e3, 20e3}};
    observe::Simulation sim(column_under_lid(6, 0.1 * R, stress_along_y(stress)), 1);
    sim.run(0.1, {});
    double worst = 0.0;
    double stored = 0.0;
    sim.run(0.8, {test::watching(1e-3, [&](observe::Simulation& now) {
                stored = std::max(stored, now.ledger().contacts);
                worst = std::max(worst, std::fabs(now.wall_motion(1).stress.y - stress.at(now.time())));
            })});
    CHECK(worst < 0.01 * 200e3);
    CHECK(std::fabs(sim.ledger().error) < rounding * stored); // what the lid put in, and took back
}

TEST_CASE("a servo presses towards the elements along either axis and from either side", "[servo]") {
    const double side = GENERATE(-1.0, 1.0);
    const bool along_x = GENERATE(false, true);
    const double F = 300.0;
    const auto placed = [&](double along, double across) {
        return along_x ? Vec2{along, across} : Vec2{across, along};
    };
    model::Scene scene = test::scene_of(grains());
    scene.bodies.push_back(test::disks("disk", {{{0.0, 0.0}, R}}, model::NoBonds{}));
    model::Support held;
    held.selection = test::all_of(0);
    scene.supports.push_back(held);
    const double at = 1.2 * side * R;
    model::Wall wall = test::wall_along("press", {placed(at, -0.1), placed(at, 0.1)});
    wall.servo.emplace();
    (along_x ? wall.servo->force_x : wall.servo->force_y) = Signal::constant(F);
    (along_x ? wall.velocity_y : wall.velocity_x) = Signal::constant(0.2); // goes on along the other
    scene.walls.push_back(wall);
    scene.materials[0].friction = 0.0;
    observe::Simulation sim(scene, 1);
    sim.run(0.1, {});
    const observe::WallMotion motion = sim.wall_motion(0);
    const auto component = [&](Vec2 v) { return along_x ? v.x : v.y; };
    const auto other = [&](Vec2 v) { return along_x ? v.y : v.x; };
    CHECK(component(motion.force) == Approx(side * F).epsilon(1e-6)); // the element pushes the wall back
    CHECK(component(motion.stress) == Approx(F / 0.2).epsilon(1e-6));
    CHECK(other(motion.position) == Approx(0.2 * 0.1).epsilon(1e-9));
    CHECK(std::fabs(sim.ledger().error) < rounding * sim.ledger().work);
}

TEST_CASE("a bed in a box comes to rest under a servo lid", "[servo]") {
    model::Scene scene = test::scene_of(grains());
    scene.gravity = {0.0, -g};
    std::vector<model::Disk> list;
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 9; ++column) {
            const double size = R * (0.75 + 0.25 * ((5 * row + 3 * column) % 7) / 7.0);
            list.push_back({{(2.05 * column + 1.1) * R + (row % 2 == 0 ? 0.0 : R), (2.0 * row + 1.01) * R}, size});
        }
    }
    scene.bodies.push_back(test::disks("bed", list, model::NoBonds{}));
    const double width = 20.0 * R;
    scene.walls.push_back(test::wall_along("box", {{0.0, 0.2}, {0.0, 0.0}, {width, 0.0}, {width, 0.2}}));
    scene.walls.push_back(test::wall_along("lid", {{0.0, 17.0 * R}, {width, 17.0 * R}}));
    const double stress = 50e3;
    scene.walls[1].servo = stress_along_y(Signal::constant(stress));
    observe::Simulation sim(scene, 1);
    sim.run(0.4, {});
    CHECK(sim.wall_motion(1).stress.y == Approx(stress).epsilon(1e-3));
    CHECK(std::fabs(sim.wall_motion(1).velocity.y) < 1e-4);
    // What the lid presses with and the bed weighs is what the box bears.
    const double F = stress * width + g * sim.body_motion(0).mass;
    CHECK(-sim.wall_motion(0).force.y == Approx(F).epsilon(1e-3));
    // Normals that turn by v dt/d leave N (v dt)^2/(2 d) a step: v dt is below 1e-4 d where N is the stress's.
    CHECK(std::fabs(sim.ledger().error) < 1e-4 * sim.ledger().work);
}

TEST_CASE("a servo wall that meets nothing stops the run", "[servo]") {
    model::Servo servo = stress_along_y(Signal::constant(1e5));
    servo.travel = 0.05;
    model::Scene scene = column_under_lid(2, 0.2, servo);
    observe::Simulation sim(scene, 1);
    CHECK_THROWS_WITH(sim.run(10.0, {}),
                      Catch::Matchers::ContainsSubstring("wall \"lid\" has met nothing on its way of 0.05"));
    CHECK(sim.wall_motion(1).position.y == Approx(4.0 * R + 0.15).margin(1e-3));
}
