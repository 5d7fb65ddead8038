// Scenes that run: handles, callbacks, changes between runs, the scenarios.
#include "tests/catch.hpp"
#include "tests/scene_language.hpp"

#include <cmath>
#include <numbers>

using namespace demlua;
using namespace demlua::test;
using Catch::Approx;

namespace {

/// What a scene with one probe of a bond is told when it runs.
std::vector<std::string> told_with(const std::string& probe) {
    const std::string scene = R"(
local rock = dem.material { name = "rock", youngs_modulus = 1e9, poissons_ratio = 0.2, density = 2000 }
local sim = dem.simulation {}
local block = sim:body { name = "block", material = rock, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 }, bonds = dem.elastic {} }
local stone = sim:body { name = "stone", material = rock, packing = dem.disks { { 0.5, 5, 0.1 } } }
local loose = sim:body { name = "loose", material = rock, packing = dem.disks { { 5, 5, 0.1 } }, bonds = dem.elastic {} }
)";
    return problems_of([&] {
        BareHost host;
        run(scene + probe + "\nsim:run { duration = 1e-6 }", host);
    });
}

} // namespace

TEST_CASE("regions combine, move and can be asked", "[scene]") {
    BareHost host;
    run(R"(
local square, hole = dem.rectangle { size = { 2, 2 } }, dem.disc { centre = { 1, 1 }, radius = 0.5 }
local plate = square - hole
print(plate:contains(1, 1), plate:contains(0.1, 0.1), (square * hole):contains(1, 1), (hole + square):contains(0.1, 0.1))
print(square:translated { 5, 0 }:contains(6, 1), square:rotated { math.pi / 2 }:contains(-1, 1), square:rotated { math.pi }:contains(1, 1))
dem.result { area = plate:area() }
)",
        host);
    CHECK(host.printed == std::vector<std::string>{"false\ttrue\ttrue\ttrue", "true\ttrue\tfalse"});
    CHECK(host.number("area") == Approx(4.0 - std::numbers::pi / 4.0).epsilon(1e-6));
}

TEST_CASE("handles answer before anything is packed", "[scene]") {
    BareHost host;
    run(block + R"(
local pressed = sim:body { name = "b", material = rock, region = dem.rectangle { size = { 1, 1 } }, packing = dem.consolidated { count = 300 } }
dem.result { given = block.radius, found = pressed.radius, name = block.name, density = rock.density }
)",
        host);
    CHECK(host.number("given") == 0.1);
    CHECK(host.number("found") == Approx(std::sqrt(0.82 / (300 * std::numbers::pi))));
    CHECK(std::get<std::string>(host.results.at("name")) == "block");
    CHECK(host.number("density") == 2000.0);
}

TEST_CASE("callbacks read, change and stop a run", "[scene]") {
    BareHost host;
    run(stone + R"(
sim:history { every = 0.01, vx = function(now) return now.body.stone.velocity.x end }
sim:every { 0.01, function(now)
  if now.time > 0.5 then now:stop("far enough") end
end }
local report = sim:run { duration = 1 }
dem.result { ending = report.ending, reason = report.reason, time = sim.now.time, mass = stone.mass, x = stone.position.x,
             fall = -sim.now.body.stone.velocity.y / sim.now.time, kinetic = sim.now.ledger.kinetic }
)",
        host);
    CHECK(std::get<std::string>(host.results.at("ending")) == "stopped");
    CHECK(std::get<std::string>(host.results.at("reason")) == "far enough");
    CHECK(host.number("time") == Approx(0.51).margin(0.02));
    CHECK(host.number("x") == Approx(3.0 * host.number("time")));
    CHECK(host.number("fall") == Approx(10.0));
    CHECK(host.number("kinetic") > 0.0);
    REQUIRE(host.columns.at("vx").size() > 50);
    CHECK(host.columns.at("vx").front() == Approx(3.0));
}

TEST_CASE("a scene solves for rest between runs", "[scene]") {
    BareHost host;
    run(rock + R"(
local sim = dem.simulation {}
local block = sim:body { name = "block", material = rock, region = dem.rectangle { size = { 1, 1 } }, packing = dem.close_packed { radius = 0.1 }, bonds = dem.elastic {} }
sim:fix { block.bottom }
local weight = sim:force { block.top, y = function(t) return -1000 end }
sim:history { every = 1e-3, sag = function(now) return now:mean("displacement_y") end }
local report = sim:solve_static { tolerance = 1e-9 }
local first = sim.now:mean("displacement_y")
weight:set { y = -2000 }
sim:solve_static {}
dem.result { solutions = report.solutions, residual = report.residual, first = first, second = sim.now:mean("displacement_y"),
             error = sim.now.ledger.error, work = sim.now.ledger.work, steps = sim.now.step }
sim:run { duration = 1e-3 }
dem.result { later = sim.now:mean("displacement_y") }
)",
        host);
    CHECK(host.number("solutions") >= 1.0);
    CHECK(host.number("residual") <= 1e-9);
    CHECK(host.number("steps") == 2.0);
    CHECK(host.number("second") == Approx(2.0 * host.number("first")).epsilon(1e-4));
    CHECK(host.number("later") == Approx(host.number("second")).epsilon(1e-8));
    CHECK(std::fabs(host.number("error")) < 1e-10 * host.number("work"));
    // A row before and after each solution, then the run's own.
    CHECK(host.columns.at("sag").size() >= 6);
    CHECK(host.columns.at("sag")[1] == host.number("first"));
}

TEST_CASE("loads and velocities change between runs", "[scene]") {
    BareHost host;
    run(stone + R"(
local push = sim:force { stone, x = 0 }
sim:run { duration = 0.1 }
stone:set_velocity { 0, 0 }
push:set { x = 2 * stone.mass }
sim:run { duration = 0.5 }
local with_push = stone.velocity.x
push:set { x = function(t) return t < 0.8 and 0 or 100 * stone.mass end }
sim:run { duration = 0.1 }
dem.result { with_push = with_push, after = stone.velocity.x, mean = stone:mean("velocity_x"), sum = sim.now:sum("kinetic_energy", stone) }
)",
        host);
    CHECK(host.number("with_push") == Approx(1.0).epsilon(1e-2));
    CHECK(host.number("after") == Approx(host.number("with_push")).epsilon(1e-2));
    CHECK(host.number("mean") == Approx(host.number("after")));
    CHECK(host.number("sum") > 0.0);
}

TEST_CASE("a callback that fails stops the run with file, line and traceback", "[scene]") {
    BareHost host;
    const auto told = problems_of([&] {
        run(stone + R"(local function read(now)
  return now.body.stone.velocty.x
end
sim:every { 0.1, function(now) read(now) end }
pcall(function() sim:run { duration = 1 } end)
dem.result { reached = true }
)",
            host);
    });
    REQUIRE(told.size() == 1);
    CHECK(told[0].rfind(scene_name + ":6: unknown reading of a body \"velocty\"; did you mean "
                                     "\"velocity\"?\nstack traceback:",
                        0) == 0);
    CHECK(host.simulation()->time() == 0.0);
}

TEST_CASE("a wrong value in a callback is a problem of the scene", "[scene]") {
    BareHost host;
    const auto told = problems_of([&] {
        run(stone +
                "sim:history { every = 0.1, speed = function(now) return \"fast\" end }\nsim:run { duration = 1 }\n",
            host);
    });
    CHECK(told == std::vector<std::string>{scene_name + ":5: history.speed = \"fast\": must return a number"});
}

TEST_CASE("random numbers are the same at every run", "[scene]") {
    const std::string text = "dem.result { x = math.random() }";
    BareHost first;
    BareHost second;
    run(text, first);
    run(text, second);
    CHECK(first.number("x") == second.number("x"));
}

TEST_CASE("the small scenarios show what they say", "[scene]") {
    BareHost pair;
    run_scene(source_folder / "scenarios/bonded_pair.lua", {}, pair);
    CHECK(std::abs(pair.number("error")) < 2e-3);

    BareHost collision;
    run_scene(source_folder / "scenarios/colliding_disks.lua", {{"restitution", "0.7"}}, collision);
    CHECK(collision.number("measured") == Approx(0.7).epsilon(5e-3));
    CHECK(std::abs(collision.number("momentum")) < 1e-12);

    BareHost tension;
    run_scene(source_folder / "scenarios/tension_test.lua", {}, tension);
    CHECK(tension.number("modulus") == Approx(tension.number("modulus_reference")).epsilon(0.05));
    CHECK(tension.number("strength") == Approx(tension.number("strength_reference")).epsilon(0.08));
    CHECK(tension.simulation()->fragments() >= 2);
}

TEST_CASE("the projectile of the penetration scene has exactly 351 elements", "[scene]") {
    BareHost host;
    run_scene(source_folder / "scenarios/penetration.lua", {{"elements", "1200"}, {"duration", "1e-9"}}, host);
    model::Selection projectile;
    projectile.body = 1;
    CHECK(host.simulation()->field("id", projectile).size() == 351);
}

TEST_CASE("a probe that means no bond is told why", "[scene]") {
    const std::string place = scene_name + ":8: ";
    using Messages = std::vector<std::string>;
    CHECK(told_with(R"(sim:bond_probe { block, name = "a", at = { 3, 3 } })") ==
          Messages{place + "bond_probe.at = { 3, 3 }: must lie no farther from the middle of a bond of body \"block\" "
                           "than that bond is long"});
    CHECK(told_with(R"(sim:bond_probe { block, name = "a", between = { 0, 900 } })") ==
          Messages{place + "bond_probe.between = { 0, 900 }: must be two bonded elements of body \"block\""});
    CHECK(told_with(R"(sim:bond_probe { stone, name = "a", at = { 0, 0 } })") ==
          Messages{place + "bond_probe.body = \"stone\": has no bonds"});
    CHECK(told_with(R"(sim:bond_probe { loose, name = "a", at = { 0, 0 } })") ==
          Messages{place + "bond_probe.body = \"loose\": has no bonds"});
    CHECK(told_with(R"(sim:bond_probe { block, name = "a" })") ==
          Messages{place + "bond_probe.at: exactly one of at and between must be given"});
    CHECK(told_with(R"(sim:bond_probe { block, name = "a", between = { 0, 1.5 } })") ==
          Messages{place + "bond_probe.between = { 0, 1.5 }: must be whole numbers from 0 on"});
}
