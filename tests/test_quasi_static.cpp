// Runs from rest to rest: against closed curves of one bond, the static solution, and slow loads in time.
#include "engine/model/scene.hpp"
#include "engine/observe/simulation.hpp"
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace demlua;
using observe::Ending;
using observe::Simulation;

namespace {

constexpr double R = 5e-3;
constexpr double toughness = 1e6;
constexpr double strength = 3.44e6;

model::Scene breaking_scene() {
    model::Material material = test::concrete();
    material.poissons_ratio = 0.3;
    material.tensile_strength = strength;
    material.fracture_toughness = toughness;
    return test::scene_of(material);
}

/// Two elements on the x axis, the left one held, the right one free to move along x only.
model::Scene pair_with(const model::BondChoice& bonds) {
    model::Scene scene = breaking_scene();
    model::Body body;
    body.name = "pair";
    body.packing = model::ListedDisks{{{{0.0, 0.0}, R}, {{2.0 * R, 0.0}, R}}};
    body.bonds = bonds;
    scene.bodies.push_back(body);
    model::Support left;
    left.selection.body = 0;
    left.selection.where = [](Vec2 at) { return at.x < R; };
    model::Support right;
    right.selection.body = 0;
    right.selection.where = [](Vec2 at) { return at.x > R; };
    right.x = false;
    scene.supports = {left, right};
    return scene;
}

model::Motion drawn(double by, double over) {
    model::Motion motion;
    motion.selection.body = 0;
    motion.selection.where = [](Vec2 at) { return at.x > R; };
    motion.displacement_x = Signal{{0.0, over}, {0.0, by}};
    return motion;
}

model::QuasiStaticRun for_duration(double duration) {
    model::QuasiStaticRun said;
    said.duration = duration;
    return said;
}

double normal_cap(const model::Material& material) {
    const double nu = material.poissons_ratio;
    return R * strength / (2.0 * (1.0 - nu)) *
           (std::numbers::sqrt3 - nu / std::numbers::sqrt3); // Tavarez & Plesha 2007, eq. 32, 1 m thick
}

} // namespace

TEST_CASE("a bond under a growing force has rest up to its strength and none beyond") {
    // Eq. 32 is the greatest force; the shortest way from rest to rest is 1e-4 of the run.
    model::Scene scene = pair_with(model::PlateauBonds{});
    const double cap = normal_cap(scene.materials[0]);
    model::Force pull;
    pull.selection.body = 0;
    pull.selection.where = [](Vec2 at) { return at.x > R; };
    pull.x = Signal{{0.0, 1.0}, {0.0, 2.0 * cap}};
    pull.y = Signal::constant(0.0);
    scene.forces.push_back(pull);
    Simulation simulation(scene, 1);
    const observe::RunReport report = simulation.run_quasi_static(for_duration(1.0), {});
    CHECK(report.ending == Ending::stopped);
    CHECK(report.reason.find("no rest beyond") != std::string::npos);
    INFO(report.reason);
    CHECK(std::fabs(simulation.time() - 0.5) < 0.5 * 0.005 + 1e-4);
}

TEST_CASE("a softening bond drawn apart from rest to rest follows its triangle") {
    // Figure 16: up to cap at e_c = cap/Kn, then straight down to zero at 2 G 2R/cap; plastic work G 2R (1 - q^2), q = force/cap.
    model::Scene scene = pair_with(model::SofteningBonds{});
    const model::Material& material = scene.materials[0];
    const double cap = normal_cap(material);
    const double owed = toughness * toughness / material.youngs_modulus * 2.0 * R;
    const double Kn = material.youngs_modulus / (std::numbers::sqrt3 * (1.0 - material.poissons_ratio));
    const double last = 2.0 * owed / cap;
    const auto force_at = [&](double e) { return std::min(Kn * e, cap * (last - e) / (last - cap / Kn)); };
    scene.motions.push_back(drawn(0.75 * last, 1.0));
    Simulation simulation(scene, 1);
    double worst = 0.0;
    const observe::Watcher watcher{0.05, [&](Simulation& now) {
                                       const double force = force_at(0.75 * last * now.time());
                                       worst =
                                           std::max(worst, std::fabs(now.ledger().bonds - 0.5 * force * force / Kn));
                                   }};
    simulation.run_quasi_static(for_duration(1.0), {watcher});
    CHECK(simulation.time() == Approx(1.0));
    CHECK(worst < 1e-4 * 0.5 * cap * cap / Kn);
    const double q = force_at(0.75 * last) / cap;
    CHECK(std::fabs(simulation.ledger().plastic / (owed * (1.0 - q * q)) - 1.0) < 1e-4);
    CHECK(std::fabs(simulation.ledger().error) < 1e-9 * owed);
}

TEST_CASE("faces of a broken bond pressed and slid rub by what friction does along their slip") {
    // Coulomb: sticking up to mu N/Kt, then slipping under mu N, so that mu N (s - mu N/Kt) is rubbed; N = Kn times the overlap.
    model::Scene scene = pair_with(model::BrittleTensileBonds{});
    const model::Material& material = scene.materials[0];
    const double nu = material.poissons_ratio;
    const double Kn =
        material.youngs_modulus / (std::numbers::sqrt3 * (1.0 - nu)); // eqs 15, 16, plane stress, 1 m thick
    const double Kt = Kn * (1.0 - 3.0 * nu) / (1.0 + nu);
    const double apart = 2.0 * normal_cap(material) / Kn;
    const double overlap = 1e-7;
    const double slid = 2e-6;
    model::Motion motion = drawn(apart, 0.3);
    motion.displacement_x = Signal{{0.0, 0.3, 0.6, 1.0}, {0.0, apart, -overlap, -overlap}};
    motion.displacement_y = Signal{{0.0, 0.6, 1.0}, {0.0, 0.0, slid}};
    scene.supports[1].y = false;
    scene.motions.push_back(motion);
    Simulation simulation(scene, 1);
    double while_open = 0.0;
    const observe::Watcher watcher{0.05, [&](Simulation& now) {
                                       if (now.time() < 0.55) while_open = now.ledger().friction;
                                   }};
    simulation.run_quasi_static(for_duration(1.0), {watcher});
    CHECK(simulation.time() == Approx(1.0));
    CHECK(simulation.state().cracks.size() == 1);
    CHECK(while_open == 0.0);
    const double cap = material.friction * Kn * overlap;
    CHECK(cap / Kt < slid);
    CHECK(std::fabs(simulation.ledger().friction / (cap * (slid - cap / Kt)) - 1.0) < 1e-4);
}

TEST_CASE("where nothing fails a run from rest to rest ends where the static solution does") {
    // Both solve the same linear system: first order in displacements from bonding.
    const bool facets = GENERATE(false, true);
    model::Scene scene = breaking_scene();
    model::Body body;
    body.name = "bar";
    body.region = model::Region::rectangle({0.0, 0.0}, {0.12, 0.05});
    model::ClosePacking lattice;
    lattice.radius = R;
    body.packing = lattice;
    model::PlateauBonds bonds;
    bonds.network = facets ? model::Network::facets : model::Network::automatic;
    body.bonds = bonds;
    scene.bodies.push_back(body);
    model::Support left;
    left.selection.body = 0;
    left.selection.side = model::Side::left;
    scene.supports.push_back(left);
    model::Traction pull;
    pull.selection.body = 0;
    pull.selection.side = model::Side::right;
    pull.stress_x = Signal{{0.0, 1.0}, {0.0, 1e5}};
    pull.stress_y = Signal{{0.0, 1.0}, {0.0, 3e4}};
    scene.tractions.push_back(pull);

    Simulation slowly(scene, 1);
    slowly.run_quasi_static(for_duration(1.0), {});
    scene.tractions[0].stress_x = Signal::constant(1e5);
    scene.tractions[0].stress_y = Signal::constant(3e4);
    Simulation once(scene, 1);
    model::StaticSolve solve;
    solve.linear = true;
    once.solve_static(solve, {});
    double farthest = 0.0;
    double apart = 0.0;
    for (std::size_t k = 0; k < once.element_count(); ++k) {
        farthest = std::max(farthest, norm(once.state().elements.displacement(k)));
        apart = std::max(apart, norm(once.state().elements.displacement(k) - slowly.state().elements.displacement(k)));
    }
    CHECK(farthest > 0.0);
    CHECK(apart < 1e-9 * farthest);
}

TEST_CASE("a notched strip drawn apart breaks at the load a slow pull in time finds") {
    // The same laws either way. What a pull in time bears more than a slow one falls with its rate: two rates give the limit.
    const bool cohesive = GENERATE(false, true);
    model::Scene scene = breaking_scene();
    model::Body body;
    body.name = "strip";
    body.region = model::Region::rectangle({0.0, 0.0}, {0.12, 0.2});
    model::ClosePacking lattice;
    lattice.radius = R;
    body.packing = lattice;
    if (cohesive) {
        body.bonds = model::CohesiveBonds{};
    } else {
        body.bonds = model::PlateauBonds{};
    }
    scene.bodies.push_back(body);
    model::Notch notch;
    notch.body = 0;
    notch.from = {-R, 0.1};
    notch.to = {0.04, 0.1};
    scene.notches.push_back(notch);
    model::Support anchor;
    anchor.selection.body = 0;
    anchor.selection.side = model::Side::bottom;
    anchor.x = true;
    anchor.rotation = true;
    scene.supports.push_back(anchor);
    const double most = 3.5e6;
    model::Traction pull;
    pull.selection.body = 0;
    pull.selection.side = model::Side::top;
    pull.stress_x = Signal::constant(0.0);

    pull.stress_y = Signal{{0.0, 1.0}, {0.0, most}};
    scene.tractions = {pull};
    Simulation at_rest(scene, 1);
    const observe::RunReport report = at_rest.run_quasi_static(for_duration(1.0), {});
    CHECK(report.ending == Ending::stopped);
    const double bears = most * at_rest.time();
    // The strip is drawn apart along the crack's normal: its faces only open.
    CHECK(at_rest.ledger().friction == 0.0);

    model::Damping damping;
    damping.fraction = 0.5;
    damping.frequency = 4400.0; // a quarter wave over 0.2 m at 3500 m/s
    scene.dampings = {damping};
    const auto borne_in_time = [&](double slow) {
        const double early = 4e-3;
        pull.stress_y = Signal{{0.0, early, early + slow}, {0.0, 0.88 * bears, 1.12 * bears}};
        scene.tractions = {pull};
        Simulation in_time(scene, 1);
        double broke = std::numeric_limits<double>::quiet_NaN();
        const observe::Watcher watch{0.0, [&](Simulation& now) {
                                         if (now.fragments() < 2 && now.crack_length() < 0.09) return;
                                         broke = pull.stress_y.at(now.time());
                                         now.stop("apart");
                                     }};
        in_time.run(early + slow, {watch});
        return broke;
    };
    const double fast = borne_in_time(40e-3);
    const double slow = borne_in_time(80e-3);
    const double broke = 2.0 * slow - fast;
    INFO((cohesive ? "cohesive" : "plateau") << ": in time " << fast << " and " << slow << ", at rest " << bears);
    CHECK(std::fabs(broke / bears - 1.0) < 0.005);
}
