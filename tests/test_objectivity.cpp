// Bonds in total form: nothing depends on how the body as a whole has moved and turned.
#include "engine/base/random.hpp"
#include "engine/observe/ledger.hpp"
#include "engine/state/assemble.hpp"
#include "engine/step/static_solve.hpp"
#include "engine/step/step.hpp"
#include "engine/step/time_step.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace demlua;

namespace {

constexpr double R = 5e-3;

state::State block_state() {
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, {8.5 * R, 8.0 * R}, R, model::ElasticBonds{}));
    return state::assemble(scene).state;
}

Vec2 centre_of_mass(const state::State& state) { return observe::motion_of_body(state, 0).centre; }

/// Loads m W^2 (x - centre) on every element where it stands now.
void add_centrifugal_loads(state::State& state, Vec2 centre, double W2) {
    state.loads.clear();
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        const Vec2 force = state.elements.mass(k) * W2 * (state.elements.position(k) - centre);
        state.loads.push_back({{static_cast<Index>(k)}, {1.0}, Signal::constant(force.x), Signal::constant(force.y)});
    }
}

/// Moves the block to where its bonds carry the centrifugal forces of central difference turning it by `angle` a step:
/// x(n+1) - 2 x(n) + x(n-1) = -2 (1 - cos angle) x(n). Each repetition mends what the loads moved since the last.
void stretch_for_spinning(state::State& state, step::Stepper& stepper, double angle) {
    const Vec2 centre = centre_of_mass(state);
    const double W2 = 2.0 * (1.0 - std::cos(angle)) / (state.dt * state.dt);
    for (const state::Freedom freedom : {state::Freedom::x, state::Freedom::y, state::Freedom::rotation}) {
        state::Drive hold;
        hold.element = {0};
        hold.reaction = {0.0};
        hold.freedom = freedom;
        hold.value = Signal::constant(0.0);
        state.drives.push_back(hold);
    }
    model::StaticSolve said;
    said.tolerance = 1e-11;
    for (int time = 0; time < 4; ++time) {
        add_centrifugal_loads(state, centre_of_mass(state), W2);
        step::solve_static(state, stepper, said);
    }
    // Held at one corner it has moved as a whole.
    const Vec2 away = centre_of_mass(state) - centre;
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        state.elements.ux[k] -= away.x;
        state.elements.uy[k] -= away.y;
    }
    state.loads.clear();
    state.drives.clear();
    step::compute_forces(state, stepper);
}

double energy_of(const state::State& state) {
    const observe::Ledger ledger = observe::ledger_of(state);
    return ledger.kinetic + ledger.bonds;
}

struct Forces {
    std::vector<Vec2> force;
    std::vector<double> moment;
};

/// Forces of a strained block that has been turned by `angle` about the origin and moved by `shift`.
Forces forces_after(double angle, Vec2 shift) {
    state::State state = block_state();
    state::Elements& elements = state.elements;
    Team team(1);
    step::Stepper stepper(team, state, 0.2);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const auto random = [&](std::uint64_t stream) { return 1e-4 * R * (uniform(7, stream, k) - 0.5); };
        const Vec2 X{elements.reference_x[k], elements.reference_y[k]};
        const Vec2 u = turned(X + Vec2{random(0), random(1)}, angle) + shift - X;
        elements.ux[k] = u.x;
        elements.uy[k] = u.y;
        elements.rotation[k] = angle + random(2) / R;
    }
    step::put_in_doubt(stepper.search);
    step::compute_forces(state, stepper);
    Forces forces;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        forces.force.push_back(turned(elements.force(k), -angle));
        forces.moment.push_back(elements.moment[k]);
    }
    return forces;
}

} // namespace

TEST_CASE("a block that spins a hundred turns at 0.8 of the limit keeps energy and angular momentum", "[bonded]") {
    // It starts with the strain of its spin, so that nothing rings: what is left is what the scheme itself does.
    state::State state = block_state();
    Team team(1);
    step::Stepper stepper(team, state, 0.2);
    state.dt = 0.8 * step::sharp_step(state);
    const int steps_a_turn = 4000;
    const double angle = 2.0 * std::numbers::pi / steps_a_turn;
    step::refresh_contacts(state, stepper.search, stepper.team);
    stretch_for_spinning(state, stepper, angle);
    const Vec2 centre = centre_of_mass(state);
    state::Elements& elements = state.elements;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const Vec2 arm = elements.position(k) - centre;
        const Vec2 v = (arm - turned(arm, -angle)) / state.dt;
        elements.vx[k] = v.x;
        elements.vy[k] = v.y;
        elements.spin[k] = angle / state.dt;
    }
    const double energy = energy_of(state);
    const double momentum = observe::momentum_of(state).angular;
    const double kinetic = observe::ledger_of(state).kinetic;
    CHECK(observe::ledger_of(state).bonds > 1e-6 * kinetic); // there is something to lose
    double energy_drift = 0.0;
    double momentum_drift = 0.0;
    for (int step = 1; step <= 100 * steps_a_turn; ++step) {
        step::advance(state, stepper);
        if (step % 500 != 0) continue;
        energy_drift = std::max(energy_drift, std::fabs(energy_of(state) / energy - 1.0));
        momentum_drift = std::max(momentum_drift, std::fabs(observe::momentum_of(state).angular / momentum - 1.0));
    }
    CHECK(std::fabs(elements.rotation[0] - 200.0 * std::numbers::pi) < 1e-3);
    CHECK(energy_drift < 1e-10);
    CHECK(momentum_drift < 1e-12);
}

TEST_CASE("a scene moved and turned as a whole has the same forces to round-off", "[bonded]") {
    const Forces still = forces_after(0.0, {0.0, 0.0});
    const double angle = GENERATE(1e-3, 0.7, 3.2, 40.0);
    const Vec2 shift{300.0 * R, -170.0 * R};
    const Forces moved = forces_after(angle, shift);
    // A displacement is kept to half a unit of its last place; a bond's force is Kn times that, six bonds add up, and an
    // angle of forty has its own last place.
    const double Kn = law::contact_stiffness(law::plane_moduli(29.7e9, 0.3, false), 1.0).normal;
    const double length = norm(shift) + std::fabs(angle) * 2.0 * R;
    const double tolerance = 6.0 * 4.0 * Kn * std::numeric_limits<double>::epsilon() * length;
    double largest = 0.0;
    double difference = 0.0;
    for (std::size_t k = 0; k < still.force.size(); ++k) {
        largest = std::max(largest, norm(still.force[k]));
        difference = std::max(difference, norm(moved.force[k] - still.force[k]));
        difference = std::max(difference, std::fabs(moved.moment[k] - still.moment[k]) / R);
    }
    CHECK(difference < tolerance);
    CHECK(tolerance < 1e-6 * largest);
}
