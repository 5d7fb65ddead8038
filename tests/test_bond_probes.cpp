// Why a bond broke, or did not: one bond followed in the history.
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;

std::map<std::string, double> columns_of(const observe::Simulation& sim) {
    const observe::HistoryRow row = sim.history_row();
    return {row.begin(), row.end()};
}

model::BondProbe probe_at(const std::string& name, Vec2 at) { return {name, 0, at, std::nullopt, {}}; }

/// Three disks in a row: the first bond is pulled apart, the second only follows.
model::Scene pulled_chain(const model::BondChoice& bonds) {
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(test::disks("chain", {{{0.0, 0.0}, R}, {{2.0 * R, 0.0}, R}, {{4.0 * R, 0.0}, R}}, bonds));
    for (const auto& [low, high, speed] : {std::tuple{-R, R, 0.0}, std::tuple{R, 5.0 * R, 1e-3}}) {
        model::Motion led;
        led.selection = test::all_of(0);
        led.selection.where = [low = low, high = high](Vec2 at) { return at.x > low && at.x < high; };
        led.velocity_x = Signal::constant(speed);
        led.velocity_y = Signal::constant(0.0);
        led.spin = Signal::constant(0.0);
        scene.motions.push_back(led);
    }
    scene.bond_probes.push_back(probe_at("tip", {0.9 * R, 0.1 * R}));
    scene.bond_probes.push_back({"far", 0, std::nullopt, model::IdPair{2, 1}, {}});
    return scene;
}

} // namespace

TEST_CASE("a probed bond tells its force, its caps and its state up to breaking", "[bond_probe]") {
    observe::Simulation sim(pulled_chain(model::PlateauBonds{}), 1);
    // fn_crit and d_max of eqs 32 and 34, as the plateau test has them; it yields at fn_crit/Kn.
    constexpr double cap = 19151.5;
    constexpr double greatest_stretch = 17.9718e-6;
    const double Kn = std::get<state::BondSet<law::Plateau>>(sim.state().bond_sets[0]).params.Kn;
    std::set<double> states;
    sim.run(25e-3, {test::watching(2e-5, [&](observe::Simulation& now) {
                auto columns = columns_of(now);
                const double stretch = now.field("displacement_x", {})[1];
                states.insert(columns.at("tip_state"));
                CHECK(columns.at("tip_stretch") == Approx(stretch).margin(1e-15));
                CHECK(columns.at("tip_slide") == 0.0);
                CHECK(columns.at("tip_shear") == 0.0);
                const bool broken = now.broken_bonds() > 0;
                if (!broken) CHECK(stretch < 1.0001 * greatest_stretch);
                CHECK(columns.at("tip_cap_normal") == Approx(broken ? 0.0 : cap).epsilon(1e-5));
                CHECK(columns.at("tip_normal") == Approx(broken ? 0.0 : std::min(cap, Kn * stretch)).epsilon(1e-5));
                CHECK((columns.at("tip_state") == 2.0) == broken);
                CHECK((columns.at("tip_damage") == 1.0) == broken);
                if (!broken && stretch > 1.0001 * cap / Kn) CHECK(columns.at("tip_state") == 1.0);
                // Elements led alike: the bond between them bears nothing.
                CHECK(columns.at("far_normal") == Approx(0.0).margin(1e-9 * cap));
                CHECK(columns.at("far_state") == 0.0);
                CHECK(columns.at("far_cap_normal") == Approx(cap).epsilon(1e-5));
            })});
    CHECK(states == std::set<double>{0.0, 1.0, 2.0});
}

TEST_CASE("a bond that cannot break has no caps to tell", "[bond_probe]") {
    const observe::Simulation sim(pulled_chain(model::ElasticBonds{}), 1);
    const auto columns = columns_of(sim);
    CHECK(columns.count("tip_normal") == 1);
    CHECK(columns.count("tip_slide") == 1);
    for (const char* name : {"tip_cap_normal", "tip_cap_shear", "tip_damage", "tip_state"}) {
        CHECK(columns.count(name) == 0);
    }
}

TEST_CASE("a brittle bond has a cap in tension alone, and loses it by breaking", "[bond_probe]") {
    observe::Simulation sim(pulled_chain(model::BrittleTensileBonds{}), 1);
    auto columns = columns_of(sim);
    // eq. 21: s 2R t
    CHECK(columns.at("tip_cap_normal") == Approx(3.44e6 * 2.0 * R).epsilon(1e-12));
    CHECK(columns.count("tip_cap_shear") == 0);
    sim.run(25e-3, {});
    columns = columns_of(sim);
    CHECK(columns.at("tip_state") == 2.0);
    CHECK(columns.at("tip_cap_normal") == 0.0);
    CHECK(columns.count("tip_cap_shear") == 0);
    CHECK(columns.at("far_state") == 0.0);
}

TEST_CASE("a facet's caps are strength times area", "[bond_probe]") {
    model::Scene scene = test::scene_of(test::concrete());
    scene.thickness = 0.5;
    model::Body body = test::block("block", {0.0, 0.0}, {0.2, 0.1}, R, model::PlateauBonds{});
    model::Relaxation relaxed;
    relaxed.count = 200;
    body.packing = relaxed;
    scene.bodies.push_back(body);
    scene.bond_probes.push_back(probe_at("inner", {0.1, 0.05}));
    const observe::Simulation sim(scene, 1);
    const auto& bonds = std::get<state::FacetSet<law::Plateau>>(sim.state().bond_sets[0]);
    double least = 1.0;
    double area = 0.0;
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        const state::Elements& elements = sim.state().elements;
        const Vec2 middle = 0.5 * (elements.position(bonds.i[k]) + elements.position(bonds.j[k]));
        if (norm(middle - Vec2{0.1, 0.05}) >= least) continue;
        least = norm(middle - Vec2{0.1, 0.05});
        area = bonds.area[k];
    }
    const auto columns = columns_of(sim);
    CHECK(columns.at("inner_cap_normal") == Approx(3.44e6 * area * 0.5).epsilon(1e-12));
    CHECK(columns.at("inner_cap_shear") == Approx(std::sqrt(3.0 / 7.0) * 3.44e6 * area * 0.5).epsilon(1e-12));
    CHECK(columns.at("inner_normal") == Approx(0.0).margin(1e-6));
}
