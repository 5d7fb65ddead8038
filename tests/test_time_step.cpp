// Runs on both sides of the stable limit, and the rules a scene can choose from.
#include "engine/state/assemble.hpp"
#include "engine/step/time_step.hpp"
#include "tests/catch.hpp"
#include "tests/exact_limit.hpp"
#include "tests/scenes.hpp"

#include <cmath>
#include <limits>
#include <optional>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;

model::Scene elastic_block(double nu) {
    model::Material material = test::concrete();
    material.poissons_ratio = nu;
    model::Scene scene = test::scene_of(material);
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, {20.5 * R, 20.0 * R}, R, model::ElasticBonds{}));
    return scene;
}

} // namespace

TEST_CASE("a step just below the exact limit is stable and one just above is not", "[step]") {
    // Dashpots of bonds lower the limit, damping of mass does not: it is taken implicitly.
    const double dashpots = GENERATE(0.0, 0.1, 0.7, 2.0);
    const bool mass_damped = GENERATE(false, true);
    model::Scene scene = elastic_block(0.1);
    scene.time_step = model::StepRule::bound;
    scene.bodies[0].region = model::Region::rectangle({0.0, 0.0}, {8.5 * R, 8.0 * R});
    scene.bodies[0].bonds = model::ElasticBonds{{0.1, dashpots}};
    const state::State state = state::assemble(scene).state;
    if (mass_damped) scene.dampings.push_back({0.5, 2000.0, std::nullopt, std::nullopt, {}});
    const double exact = test::exact_limit(test::pencil_of(state));
    const double bound = step::bound_step(state);
    const auto grows = [&](double dt) {
        model::Scene run = scene;
        run.step_fraction = dt / bound;
        observe::Simulation sim(run, 1);
        // A small push, so that the motion stays linear until it has grown a millionfold.
        model::Selection one = test::all_of(0);
        one.where = [](Vec2 at) { return at.x < 1.5 * R && at.y < 1.5 * R; };
        sim.set_velocity(one, {1e-9, 0.3e-9});
        const double pushed = sim.ledger().kinetic;
        try {
            sim.run(20000.5 * dt, {});
        } catch (const RunError&) {
            return true;
        }
        // Of motion that turns at every step m v- v+ is negative.
        return !(sim.ledger().bonds < 1e3 * pushed);
    };
    CHECK_FALSE(grows(0.999 * exact));
    CHECK(grows(1.001 * exact));
}

TEST_CASE("one mode's damped limit is (2/w)(sqrt(1 + xi^2) - xi)", "[step]") {
    // Two elements on one spring along their line: w^2 = 2 Kn/m, and the shear spring held out of it by Kt = 0.
    const double xi = GENERATE(0.0, 0.3, 0.707, 1.0, 2.0);
    model::Material material = test::concrete();
    material.poissons_ratio = 1.0 / 3.0;
    model::Scene scene = test::scene_of(material);
    scene.bodies.push_back(test::disks("pair", {{{0.0, 0.0}, R}, {{2.0 * R, 0.0}, R}}, model::ElasticBonds{{0.1, xi}}));
    const state::State state = state::assemble(scene).state;
    const auto& p = std::get<state::BondSet<law::Elastic>>(state.bond_sets[0]).params;
    const double w = std::sqrt(2.0 * p.Kn * state.elements.inverse_mass[0]);
    CHECK(step::sharp_step(state) == Approx(2.0 / w * (std::sqrt(1.0 + xi * xi) - xi)).epsilon(1e-6));
}

TEST_CASE("the line on the time step shows the rule and what eq. 19 would give", "[step]") {
    const observe::Simulation sharp(elastic_block(0.3), 1);
    CHECK_THAT(sharp.time_step_reason(),
               Catch::Matchers::ContainsSubstring("by Lanczos iteration; the paper's eq. 19 would give"));
    const observe::Simulation unstable(elastic_block(0.05), 1);
    CHECK_THAT(unstable.time_step_reason(), Catch::Matchers::ContainsSubstring("unstable for Kt/Kn above 2/3"));
}

TEST_CASE("the paper's step is taken when asked for and refused where it is unstable") {
    model::Scene scene = elastic_block(0.2);
    scene.time_step = model::StepRule::paper;
    scene.step_fraction = 1.0;
    const observe::Simulation sim(scene, 1);
    const auto& p = std::get<state::BondSet<law::Elastic>>(sim.state().bond_sets[0]).params;
    CHECK(sim.time_step() == Approx(0.5 * std::sqrt(sim.state().elements.mass(0) / p.Kn)).epsilon(1e-12));
    model::Scene refused = elastic_block(0.05);
    refused.time_step = model::StepRule::paper;
    CHECK_THROWS_AS(observe::Simulation(refused, 1), SceneError);
}

TEST_CASE("a run that blows up stops and names the element") {
    model::Scene scene = elastic_block(0.2);
    scene.step_fraction = 1.5;
    observe::Simulation sim(scene, 1);
    model::Selection one = test::all_of(0);
    one.where = [](Vec2 at) { return at.x < 1.5 * R; };
    sim.set_velocity(one, {1e-3, 0.0});
    CHECK_THROWS_WITH(sim.run(1e-3, {}), Catch::Matchers::ContainsSubstring("element") &&
                                             Catch::Matchers::ContainsSubstring("of body \"block\""));
}

TEST_CASE("a velocity that is no number stops the run at once") {
    observe::Simulation sim(elastic_block(0.2), 1);
    model::Selection one = test::all_of(0);
    one.where = [](Vec2 at) { return at.x < 1.5 * R && at.y < 1.5 * R; };
    sim.set_velocity(one, {std::numeric_limits<double>::quiet_NaN(), 0.0});
    CHECK_THROWS_WITH(sim.run(1e-3, {}), Catch::Matchers::ContainsSubstring("element 0 of body \"block\""));
    CHECK(sim.step() == 0);
}
