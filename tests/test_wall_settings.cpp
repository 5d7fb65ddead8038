// Walls, servos and outlines as scenes say them.
#include "tests/catch.hpp"
#include "tests/scene_language.hpp"

#include <string>
#include <vector>

using namespace demlua;
using Catch::Approx;

TEST_CASE("a wall is moved, turned, stopped and read from a scene", "[walls]") {
    test::BareHost host;
    test::run(test::stone + R"(
        local blade = sim:wall { name = "blade", path = { { 5, 0 }, { 6, 0 } }, velocity = { 1, 0 }, centre = { 5, 0 } }
        local teeth = sim:wall { name = "teeth", path = dem.sawtooth { from = { 5, 3 }, to = { 6, 3 }, height = 0.1, pitch = 0.25 } }
        sim:run { duration = 0.1 }
        dem.result { x1 = blade.position.x }
        blade:move { spin = function(t) return 2 end }
        sim:run { duration = 0.1 }
        dem.result { x2 = sim.now.wall.blade.position.x, angle = blade.angle, spin = blade.spin }
        blade:move { stop = true, velocity_y = 1 }
        sim:run { duration = 0.1 }
        dem.result { x3 = blade.position.x, y3 = blade.position.y, angle3 = blade.angle, force = teeth.force.y })",
              host);
    CHECK(host.number("x1") == Approx(5.1));
    CHECK(host.number("x2") == Approx(5.2));
    CHECK(host.number("angle") == Approx(0.2));
    CHECK(host.number("spin") == Approx(2.0));
    CHECK(host.number("x3") == Approx(5.2));
    CHECK(host.number("y3") == Approx(0.1));
    CHECK(host.number("angle3") == Approx(0.2));
    CHECK(host.number("force") == 0.0);
}

TEST_CASE("a rough wall can be made of elements that move as one", "[walls]") {
    // A disk in the dip between two disks of a rigid row is carried along, and the row bears its weight.
    test::BareHost host;
    test::run(R"(
        local sand = dem.material { name = "sand", youngs_modulus = 1e7, poissons_ratio = 0.2, density = 2000, friction = 0.5, restitution = 0.3 }
        local sim = dem.simulation { gravity = { 0, -10 } }
        local list = {}
        for k = 0, 9 do list[k + 1] = { 0.1 * k, 0, 0.05 } end
        local row = sim:body { name = "row", material = sand, rigid = true, packing = dem.disks(list) }
        local top = sim:body { name = "top", material = sand, packing = dem.disks { { 0.45, 0.05 * math.sqrt(3), 0.05 } }, velocity = { 0.2, 0 } }
        sim:move { row, velocity = { 0.2, 0 }, spin = 0 }
        sim:run { duration = 0.5 }
        dem.result { row = row.position.x - 0.45, top = top.position.x - 0.45, weight = row:sum("force_y"), speed = top.velocity.x })",
              host);
    CHECK(host.number("row") == Approx(0.1).epsilon(1e-6));
    CHECK(host.number("top") == Approx(0.1).epsilon(1e-3));
    CHECK(host.number("speed") == Approx(0.2).epsilon(1e-3));
}

TEST_CASE("servos are said, changed and ended in a scene", "[servo]") {
    test::BareHost host;
    test::run(test::rock + R"(
        local sim = dem.simulation {}
        local disk = sim:body { name = "disk", material = rock, packing = dem.disks { { 0, 0, 0.1 } } }
        sim:fix { disk }
        local lid = sim:wall { name = "lid", path = { { -1, 0.11 }, { 1, 0.11 } }, servo = { stress_y = function(t) return 1e4 end } }
        sim:run { duration = 0.2 }
        dem.result { one = lid.stress.y }
        lid:move { servo = { force_y = 3e4 } }
        sim:run { duration = 0.2 }
        dem.result { two = sim.now.wall.lid.force.y }
        lid:move { stop = true, velocity_y = 0.1 }
        sim:run { duration = 0.2 }
        dem.result { three = lid.force.y, speed = lid.velocity.y })",
              host);
    CHECK(host.number("one") == Approx(1e4).epsilon(1e-3));
    CHECK(host.number("two") == Approx(3e4).epsilon(1e-3));
    CHECK(host.number("three") == 0.0);
    CHECK(host.number("speed") == Approx(0.1));
}

TEST_CASE("servos that cannot be are refused", "[servo]") {
    const auto problems = [](const std::string& servo) {
        return test::problems_of([&] {
            test::checked(test::stone + "sim:wall { name = 'lid', path = { { 5, 0 }, { 6, 0 } }, servo = " + servo +
                          " }\nsim:run { duration = 1 }");
        });
    };
    const auto contains = [](const std::vector<std::string>& messages, const std::string& words) {
        return messages.size() == 1 && messages[0].find(words) != std::string::npos;
    };
    CHECK(problems("{ stress_y = 1e5 }").empty());
    CHECK(contains(problems("{}"), "wall.servo: seeks nothing"));
    CHECK(contains(problems("{ stress_x = 1 }"), "wall.servo.stress_x: needs a wall with a height"));
    CHECK(contains(problems("{ stress_y = 1, force_y = 1 }"), "wall.servo.force_y: must not be given beside stress_y"));
    CHECK(contains(problems("{ stress_y = 1, gain = 2 }"), "wall.servo.gain"));
    CHECK(contains(problems("{ strain_y = 1 }"), "wall.servo.strain_y"));
}

TEST_CASE("outlines are said, moved and read in a scene", "[outline]") {
    test::BareHost host;
    test::run(test::rock + R"(
        local sim = dem.simulation { gravity = { 0, -10 } }
        local disk = sim:body { name = "disk", material = rock, packing = dem.disks { { 0, 0, 0.1 } } }
        sim:fix { disk }
        local block = sim:outline { name = "block", material = rock, region = dem.rectangle { at = { 1, 1 }, size = { 0.2, 0.1 } }, velocity = { 0, 1 } }
        sim:run { duration = 0.1 }
        dem.result { y1 = block.position.y, mass = block.mass, inertia = sim.now.wall.block.inertia }
        block:move { velocity = { 0, 0.5 }, spin = 1 }
        sim:run { duration = 0.1 }
        dem.result { y2 = block.position.y, angle = block.angle }
        block:move { free = true }
        sim:run { duration = 0.1 }
        dem.result { y3 = block.position.y, spin = block.spin })",
              host);
    CHECK(host.number("mass") == Approx(2000.0 * 0.02));
    CHECK(host.number("inertia") == Approx(2000.0 * 0.02 * 0.05 / 12.0));
    CHECK(host.number("y1") == Approx(1.05 + 0.1 - 0.05).epsilon(1e-6));
    CHECK(host.number("y2") == Approx(1.15).epsilon(1e-6));
    CHECK(host.number("angle") == Approx(0.1).epsilon(1e-6));
    CHECK(host.number("y3") == Approx(1.15).epsilon(1e-3));
    CHECK(host.number("spin") == Approx(1.0).epsilon(1e-6));
}
