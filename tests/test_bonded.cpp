// Bonded elements in motion: closed forms, conservation laws, and a strip with Young's modulus and Poisson's ratio.
#include "engine/law/stiffness.hpp"
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <cmath>
#include <numbers>
#include <variant>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;

model::Scene pair_scene(const model::BondChoice& bonds) {
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(test::disks("pair", {{{0.0, 0.0}, R}, {{2.0 * R, 0.0}, R}}, bonds));
    return scene;
}

model::Motion given_velocity(std::size_t body, double x_from, double vx) {
    model::Motion motion;
    motion.selection = test::all_of(body);
    motion.selection.where = [=](Vec2 at) { return at.x >= x_from; };
    motion.velocity_x = Signal::constant(vx);
    motion.velocity_y = Signal::constant(0.0);
    motion.spin = Signal::constant(0.0);
    return motion;
}

/// Least-squares slope of a field of displacements over a coordinate of the selected elements.
template <class Coordinate>
double slope_over_place(const observe::Simulation& sim, const std::string& field, const model::Selection& selection,
                        Coordinate coordinate) {
    const std::vector<double> u = sim.field(field, selection);
    const std::vector<Vec2> all = sim.snapshot().position;
    const std::vector<double> ids = sim.field("id", selection);
    double s = 0.0;
    double su = 0.0;
    double ss = 0.0;
    double ssu = 0.0;
    for (std::size_t k = 0; k < u.size(); ++k) {
        const double c = coordinate(all[static_cast<std::size_t>(ids[k])]);
        s += c;
        su += u[k];
        ss += c * c;
        ssu += c * u[k];
    }
    const auto n = static_cast<double>(u.size());
    return (n * ssu - s * su) / (n * ss - s * s);
}

} // namespace

TEST_CASE("two bonded elements oscillate with the period of two masses on a spring") {
    model::Scene scene = pair_scene(model::ElasticBonds{});
    scene.step_fraction = 0.02;
    observe::Simulation sim(scene, 1);
    const double speed = 1e-3;
    const auto at_right = [](Vec2 at) { return at.x > R; };
    sim.set_velocity({std::nullopt, std::nullopt, std::nullopt, at_right}, {speed, 0.0});
    const double m = sim.body_motion(0).mass / 2.0;
    const double K = law::contact_stiffness(law::plane_moduli(29.7e9, 0.3, false), 1.0).normal;
    const double period = 2.0 * std::numbers::pi * std::sqrt(m / (2.0 * K));

    // Crossings of zero stretch, found between instants.
    std::vector<double> crossings;
    double before = 0.0;
    double time_before = 0.0;
    sim.run(10.2 * period, {test::watching(0.0, [&](observe::Simulation& now) {
                const auto x = now.field("displacement_x", {});
                const double stretch = x[1] - x[0];
                if (before < 0.0 && stretch >= 0.0) {
                    crossings.push_back(time_before - before * (now.time() - time_before) / (stretch - before));
                }
                before = stretch;
                time_before = now.time();
            })});
    REQUIRE(crossings.size() >= 9);
    const double measured = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    CHECK(measured == Approx(period).epsilon(1e-4));
    CHECK(std::fabs(sim.ledger().error) < 1e-9 * 0.5 * m * speed * speed);
}

TEST_CASE("a pulled bond follows the plateau, breaks at d_max, and has spent G_f 2Rt") {
    model::Scene scene = pair_scene(model::PlateauBonds{});
    scene.motions.push_back(given_velocity(0, R, 1e-3));
    model::Support held;
    held.selection = test::all_of(0);
    held.selection.where = [](Vec2 at) { return at.x < R; };
    scene.supports.push_back(held);
    observe::Simulation sim(scene, 1);
    double largest_force = 0.0;
    double broke_at = 0.0;
    sim.run(25e-3, {test::watching(0.0, [&](observe::Simulation& now) {
                const observe::Snapshot seen = now.snapshot();
                largest_force = std::max(largest_force, std::get<std::vector<double>>(seen.bond_fields[0].values)[0]);
                broke_at = now.field("displacement_x", {})[1];
                if (now.broken_bonds() > 0) now.stop("broken");
            })});
    CHECK(largest_force == Approx(19151.5).epsilon(1e-5));
    CHECK(broke_at == Approx(17.9718e-6).epsilon(1e-4));
    const observe::Ledger energy = sim.ledger();
    CHECK(energy.plastic + energy.fracture == Approx(33.670 * 2.0 * R).epsilon(1e-4));
    CHECK(energy.work == Approx(33.670 * 2.0 * R).epsilon(1e-4));
    CHECK(std::fabs(energy.error) < 1e-4 * energy.work);
}

TEST_CASE("a close-packed strip in tension has the material's stress, strain and contraction") {
    // Both orientations of the lattice; plane stress: strain = s/E along, -nu s/E across.
    const model::Rows rows = GENERATE(model::Rows::horizontal, model::Rows::vertical);
    model::Material material = test::concrete();
    material.poissons_ratio = 0.2;
    model::Scene scene = test::scene_of(material);
    model::Body strip = test::block("strip", {0.0, 0.0}, {0.12, 0.36}, R, model::ElasticBonds{});
    std::get<model::ClosePacking>(strip.packing).rows = rows;
    scene.bodies.push_back(strip);
    const double stress = 1e6;
    for (const auto& [side, value] : {std::pair{model::Side::bottom, -stress}, std::pair{model::Side::top, stress}}) {
        model::Traction traction;
        traction.selection = test::side_of(0, side);
        traction.stress_y = {{0.0, 5e-3}, {0.0, value}};
        traction.hold_rotation = true;
        scene.tractions.push_back(traction);
    }
    scene.dampings.push_back({0.7, 4000.0, std::nullopt, std::nullopt, {}});
    observe::Simulation sim(scene, 2);
    sim.run(10e-3, {});

    // Far from the loaded ends and from the sides. The load is spread over the width of the disks, and carried by one
    // between that and the width of the outer centres; so the modulus is taken from the stress in the elements.
    model::Selection middle = test::all_of(0);
    middle.within = model::Region::rectangle({0.03, 0.14}, {0.06, 0.08});
    const double strain_x = slope_over_place(sim, "displacement_x", middle, [](Vec2 at) { return at.x; });
    const double strain_y = slope_over_place(sim, "displacement_y", middle, [](Vec2 at) { return at.y; });
    const double carried = sim.measure("stress_yy", middle);
    const double width = sim.body_motion(0).extent.size().x;
    CHECK(carried > 0.99 * stress);
    CHECK(carried < 1.01 * stress * width / (width - 2.0 * R));
    CHECK(std::fabs(sim.measure("stress_xx", middle)) < 0.02 * stress);
    CHECK(carried / strain_y == Approx(29.7e9).epsilon(2e-3));
    CHECK(-strain_x / strain_y == Approx(0.2).epsilon(2e-2));
}
