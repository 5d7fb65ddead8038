// Functions that hear of each broken bond, and loads that tell what they are worth now.
#include "tests/catch.hpp"
#include "tests/scene_language.hpp"

#include <cmath>

using namespace demlua;
using namespace demlua::test;
using Catch::Approx;

namespace {

/// Four elements in a row; the speed of each is given, so that every bond is stretched at a known rate (radius 5 mm).
std::string row_pulled(const std::string& speeds) {
    return R"(local concrete = dem.material { name = "concrete", youngs_modulus = 29.7e9, poissons_ratio = 0.3, density = 2400,
  tensile_strength = 3.44e6, fracture_toughness = 1e6 }
local sim = dem.simulation { time_step = "bound" }
local row = sim:body { name = "row", material = concrete, bonds = dem.plateau {},
  packing = dem.disks { { 0, 0, 0.005 }, { 0.01, 0, 0.005 }, { 0.02, 0, 0.005 }, { 0.03, 0, 0.005 } } }
for k, speed in ipairs { )" +
           speeds + R"( } do
  local at = 0.01 * (k - 1)
  sim:move { { row, where = function(x) return math.abs(x - at) < 1e-3 end }, velocity = { speed, 0 }, spin = 0 }
end
)";
}

/// Prints what each event says, and whether it comes in the very step.
const std::string tell =
    R"(sim:on_bond_break { function(event, now)
  print(event.body, event.i, event.j, now.broken_bonds, event.time == now.time)
  dem.result { ["time" .. event.i] = event.time, ["x" .. event.i] = event.x, ["y" .. event.i] = event.y }
end }
)";

// Tavarez & Plesha 2007, eq. 34, for this concrete and radius: the stretch at which a bond breaks, m.
constexpr double stretch_at_breaking = 17.9718e-6;

} // namespace

TEST_CASE("bonds tell of their breaking in the order and at the times in which they are torn", "[scene]") {
    BareHost host;
    // Stretched by 2, 1 and 4 mm/s.
    run(row_pulled("0, 2e-3, 3e-3, 7e-3") + tell +
            "sim:run { duration = 20e-3 }\ndem.result { dt = sim.now.time_step }",
        host);
    CHECK(host.printed == std::vector<std::string>{"row\t2\t3\t1\ttrue", "row\t0\t1\t2\ttrue", "row\t1\t2\t3\ttrue"});
    const double dt = host.number("dt");
    // A bond breaks in the first step that ends beyond the stretch; that is known to six digits.
    const auto torn_at = [&](const char* name, double rate) {
        const double expected = stretch_at_breaking / rate;
        CHECK(host.number(name) > expected * (1.0 - 1e-5));
        CHECK(host.number(name) < expected * (1.0 + 1e-5) + 2.0 * dt);
    };
    torn_at("time0", 2e-3);
    torn_at("time1", 1e-3);
    torn_at("time2", 4e-3);
    // Half way between elements 2 and 3, which have gone 3 and 7 mm/s times the time.
    CHECK(host.number("x2") == Approx(0.025 + 5e-3 * host.number("time2")).epsilon(1e-9));
    CHECK(host.number("y2") == Approx(0.0).margin(1e-12));
}

TEST_CASE("bonds that break in one step are told one by one, by rows, before the next step", "[scene]") {
    BareHost host;
    run(row_pulled("0, 2e-3, 2e-3, 4e-3") + tell +
            "sim:on_bond_break(function(event, now) now:stop(\"torn\") end)\n"
            "local report = sim:run { duration = 20e-3 }\n"
            "dem.result { reason = report.reason, stopped = sim.now.time }\n",
        host);
    CHECK(host.printed == std::vector<std::string>{"row\t0\t1\t2\ttrue", "row\t2\t3\t2\ttrue"});
    CHECK(std::get<std::string>(host.results.at("reason")) == "torn");
    CHECK(host.number("stopped") == host.number("time0"));
    CHECK(host.number("time0") == host.number("time2"));
}

TEST_CASE("a notch is no event, neither at the start nor between runs, and later runs go on listening", "[scene]") {
    BareHost host;
    run(row_pulled("0, 0, 0, 4e-3") + "sim:notch { row, from = { 0.005, -0.01 }, to = { 0.005, 0.01 } }\n" + tell +
            "sim:run { duration = 1e-3 }\n"
            "sim:notch { row, from = { 0.015, -0.01 }, to = { 0.015, 0.01 } }\n"
            "sim:run { duration = 10e-3 }\n",
        host);
    CHECK(host.printed == std::vector<std::string>{"row\t2\t3\t3\ttrue"});
}

TEST_CASE("what goes wrong in a function of events ends the run at its line", "[scene]") {
    BareHost host;
    const auto told = problems_of([&] {
        run(row_pulled("0, 0, 0, 4e-3") +
                "sim:on_bond_break(function(event) print(event.where) end)\nsim:run { duration = 10e-3 }\n",
            host);
    });
    REQUIRE(told.size() == 1);
    CHECK_THAT(told[0], Catch::Matchers::ContainsSubstring("unknown reading of an event \"where\""));
}

TEST_CASE("a load reads as what it is worth now", "[scene]") {
    BareHost host;
    run(block + R"(
local push = sim:force { block, x = dem.ramp { to = 10, over = 1 }, y = function(t) return t * t end }
local pull = sim:traction { block.top, stress_y = { { 0, 1 }, { 2, 5 } } }
local lead = sim:move { block.bottom, velocity_x = 0.25 }
sim:run { duration = 0.5 }
dem.result { x = push.x, y = push.y, none = pull.stress_x, stress = pull.stress_y, speed = lead.velocity_x,
             free = lead.velocity_y == nil, time = sim.now.time }
push:set { x = -3 }
dem.result { set = push.x }
)",
        host);
    const double time = host.number("time");
    CHECK(time == Approx(0.5));
    CHECK(host.number("x") == Approx(10.0 * time));
    CHECK(host.number("y") == Approx(time * time).epsilon(1e-5));
    CHECK(host.number("none") == 0.0);
    CHECK(host.number("stress") == Approx(1.0 + 2.0 * time));
    CHECK(host.number("speed") == 0.25);
    CHECK(std::get<bool>(host.results.at("free")));
    CHECK(host.number("set") == -3.0);
}
