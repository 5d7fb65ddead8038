// Bonds across the edge of a box that repeats.
#include "engine/base/team.hpp"
#include "engine/observe/stress.hpp"
#include "engine/state/assemble.hpp"
#include "engine/step/step.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <variant>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;
constexpr double width = 20.0 * R;

/// A strip as wide as the box, which begins at `left`; its rows lie along it.
model::Scene strip(double left, const model::BondChoice& bonds) {
    model::Scene scene = test::scene_of(test::concrete());
    scene.periodic_x = Vec2{left, left + width};
    scene.bodies.push_back(test::block("strip", {left, 0.0}, {width, 16.0 * R}, R, bonds));
    return scene;
}

/// The same height of an irregular pack, bonded across facets.
model::Scene irregular(const model::BondChoice& bonds) {
    model::Scene scene = strip(0.0, bonds);
    model::Relaxation pack;
    pack.count = 150;
    pack.steps = 20;
    scene.bodies[0].packing = pack;
    return scene;
}

/// Strip with rows across the box, a whole number of pairs of them.
model::Scene upright() {
    model::Scene scene = strip(0.0, model::ElasticBonds{});
    const double wide = 6.0 * 2.0 * std::sqrt(3.0) * R;
    scene.periodic_x = Vec2{0.0, wide};
    scene.bodies[0].region = model::Region::rectangle({0.0, 0.0}, {wide, 16.0 * R});
    scene.bodies[0].packing = model::ClosePacking{R, model::Rows::vertical, model::Fit::inside, std::nullopt};
    return scene;
}

/// Its top and bottom pulled apart at `speed`, m/s.
void pull_apart(model::Scene& scene, double speed) {
    for (const model::Side side : {model::Side::top, model::Side::bottom}) {
        model::Motion motion;
        motion.selection = test::side_of(0, side);
        motion.velocity_x = Signal::constant(0.0);
        motion.velocity_y = Signal::constant(side == model::Side::top ? speed : -speed);
        scene.motions.push_back(motion);
    }
}

/// How many broken bonds had joined elements on both sides of the edge.
std::size_t broken_across(const state::State& state) {
    return static_cast<std::size_t>(
        std::count_if(state.cracks.begin(), state.cracks.end(), [&](const state::Crack& crack) {
            return std::fabs(state.elements.reference_x[crack.j] - state.elements.reference_x[crack.i]) >
                   0.5 * state.period.length;
        }));
}

} // namespace

TEST_CASE("a strip bonded across the edge has Hooke's stress in every element under a uniform strain") {
    const int which = GENERATE(0, 1, 2);
    const model::Scene scene =
        which == 0 ? strip(0.0, model::ElasticBonds{}) : (which == 1 ? upright() : irregular(model::ElasticBonds{}));
    state::State state = state::assemble(scene).state;
    // The motions of a plane that repeats along x: u = (shear y, stretch y), elements turning by -shear/2.
    const double stretch = 1e-7;
    const double shear = 0.4e-7;
    state::Elements& elements = state.elements;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        elements.ux[k] = shear * elements.reference_y[k];
        elements.uy[k] = stretch * elements.reference_y[k];
        elements.rotation[k] = -0.5 * shear;
    }
    Team team(1);
    step::Stepper stepper(team, state, 0.2);
    step::compute_forces(state, stepper);
    const std::vector<double> stress = observe::stress_of_elements(state);
    const double nu = 0.3;
    const double E = 29.7e9;
    const double yy = E / (1.0 - nu * nu) * stretch;
    const double xy = E / (2.0 * (1.0 + nu)) * shear;
    const double largest = *std::max_element(elements.radius.begin(), elements.radius.end());
    std::size_t seen = 0;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const double y = elements.position(k).y;
        if (std::min(y, 16.0 * R - y) < 4.0 * largest) continue;
        // Finite kinematics leave errors of the order of the strain.
        CHECK(std::fabs(stress[3 * k] - nu * yy) < 1e-5 * yy);
        CHECK(std::fabs(stress[3 * k + 1] - yy) < 1e-5 * yy);
        CHECK(std::fabs(stress[3 * k + 2] - xy) < 1e-5 * yy);
        CHECK(norm(elements.force(k)) < 1e-5 * yy * 2.0 * elements.radius[k]);
        ++seen;
    }
    CHECK(seen > 30);
}

TEST_CASE("a wave does not notice where the edges of a periodic strip are") {
    // Two strips that are the same but for the place of the edge, which the wave of one has to pass.
    const double moved = 6.0 * R;
    const auto pushed = [](double left) {
        model::Scene scene = strip(left, model::ElasticBonds{});
        auto sim = std::make_unique<observe::Simulation>(scene, 1);
        model::Selection middle;
        middle.where = [](Vec2 at) { return at.x > 8.0 * R && at.x < 12.0 * R; };
        sim->set_velocity(middle, {1e-3, 0.5e-3});
        return sim;
    };
    const auto here = pushed(0.0);
    const auto there = pushed(moved);
    const observe::Momentum before = here->momentum();
    const double kinetic = here->ledger().kinetic;
    // P waves of 3.7 km/s go once around.
    for (observe::Simulation* sim : {here.get(), there.get()}) sim->run(width / 3700.0, {});
    const state::Elements& a = here->state().elements;
    const state::Elements& b = there->state().elements;
    REQUIRE(a.size() == b.size());
    std::size_t met = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Vec2 apart{b.reference_x[j] - a.reference_x[i], b.reference_y[j] - a.reference_y[i]};
            if (norm(here->state().period.shortest(apart)) > 1e-3 * R) continue;
            // Rounding alone: 1e-16 of the places, 0.1 m, in each of some tens of steps, against moves of 1e-8 m.
            CHECK(norm(b.displacement(j) - a.displacement(i)) < 1e-14);
            ++met;
        }
    }
    CHECK(met == a.size());
    CHECK(here->momentum().linear.x == Approx(before.linear.x).epsilon(1e-12));
    CHECK(here->momentum().linear.y == Approx(before.linear.y).epsilon(1e-12));
    CHECK(std::fabs(here->ledger().error) < 1e-9 * kinetic);
}

TEST_CASE("a strip that breaks across the edge keeps its ledger, whatever the number of threads") {
    const bool facets = GENERATE(false, true);
    model::Scene scene = facets ? irregular(model::CohesiveBonds{}) : strip(0.0, model::BrittleTensileBonds{});
    pull_apart(scene, 0.5);
    std::uint64_t hash = 0;
    for (const int threads : {1, 2, 3, 8}) {
        observe::Simulation sim(scene, {threads, 1});
        sim.run(2e-4, {});
        if (threads == 1) {
            hash = sim.hash();
            CHECK(broken_across(sim.state()) > 0);
            CHECK(std::fabs(sim.ledger().error) < 1e-2 * sim.ledger().work);
            for (const auto& ends : sim.snapshot().crack_ends) {
                const double middle = 0.5 * (ends[0].x + ends[1].x);
                CHECK((middle >= 0.0 && middle < width));
            }
        }
        CHECK(sim.hash() == hash);
    }
}

TEST_CASE("a cluster across the edge moves as one inside") {
    const bool rigid = GENERATE(false, true);
    const auto turning = [rigid](double at) {
        model::Scene scene = test::scene_of(test::concrete());
        scene.periodic_x = Vec2{0.0, width};
        const double left = at - 0.8 * R; // 1.6 R and 1.2 R from each other: 2 R
        model::Body body =
            test::disks("pair", {{{left < 0.0 ? left + width : left, 0.0}, R}, {{at + 0.8 * R, 1.2 * R}, R}},
                        rigid ? model::BondChoice{model::NoBonds{}} : model::ElasticBonds{});
        std::get<model::ListedDisks>(body.packing).clusters = {0, 0};
        body.in_clusters = true;
        body.rigid = rigid;
        body.velocity = {-3.0, 1.0};
        body.spin = 40.0;
        scene.bodies.push_back(body);
        return scene;
    };
    observe::Simulation across(turning(0.0), 1);
    observe::Simulation amid(turning(0.5 * width), 1);
    REQUIRE(across.bond_count() == (rigid ? 0 : 1));
    for (observe::Simulation* sim : {&across, &amid}) {
        sim->run(2e-3, {});
    }
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec2 apart = across.state().elements.displacement(k) - amid.state().elements.displacement(k);
        CHECK(norm(apart) < 1e-12);
    }
    CHECK(across.state().elements.vx[0] == Approx(amid.state().elements.vx[0]).epsilon(1e-9));
}
