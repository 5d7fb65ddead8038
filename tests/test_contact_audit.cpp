// The ledger of single contacts (step/contact_audit.hpp): none gives more than it has taken, whatever happens to it.
#include "engine/base/problems.hpp"
#include "engine/base/random.hpp"
#include "engine/state/assemble.hpp"
#include "engine/step/contact_audit.hpp"
#include "engine/step/step.hpp"
#include "engine/step/time_step.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>
#include <vector>

using namespace demlua;

namespace {

constexpr double R = 5e-3;

/// Runs `steps` steps and books each; the number of accounts that were open, step after step together.
std::size_t audited(state::State& state, int steps) {
    Team team(1);
    step::Stepper stepper(team, state, 0.2);
    step::start(state, stepper);
    step::ContactAudit audit;
    std::size_t open = 0;
    for (int k = 0; k < steps; ++k) {
        step::advance(state, stepper);
        audit.book(state);
        open += audit.accounts().size();
    }
    return open;
}

state::State two_disks(double angle, double restitution, double friction, double spin) {
    model::Scene scene = test::scene_of(test::bouncing(restitution, friction));
    scene.materials[0].rolling_friction = 0.1;
    const Vec2 apart = 1.601 * R * Vec2{std::cos(angle), std::sin(angle)};
    scene.bodies.push_back(test::disks("left", {{{0.0, 0.0}, R}}, model::NoBonds{}));
    scene.bodies.push_back(test::disks("right", {{apart, 0.6 * R}}, model::NoBonds{}));
    scene.bodies[0].velocity = {1.0, 0.0};
    scene.bodies[0].spin = spin;
    return state::assemble(scene).state;
}

/// An impact of two disks head-on without dashpot or friction, step by step: overlap at every instant and speed at which they closed
/// over the step before it.
struct Impact {
    std::vector<double> overlap, closing; ///< m, m/s

    [[nodiscard]] std::size_t first() const {
        return static_cast<std::size_t>(std::find_if(overlap.begin(), overlap.end(), [](double d) { return d > 0.0; }) -
                                        overlap.begin());
    }
    [[nodiscard]] std::size_t last() const {
        std::size_t k = overlap.size() - 1;
        while (overlap[k] <= 0.0) --k;
        return k;
    }
};

/// `phase`: of a step, where in it they meet.
Impact impact_at(double share, double phase, double& step, double& mass, double& Kn) {
    model::Scene scene = test::scene_of(test::bouncing(1.0, 0.0));
    scene.bodies.push_back(test::disks("left", {{{0.0, 0.0}, R}}, model::NoBonds{}));
    scene.bodies.push_back(test::disks("right", {{{2.0 * R, 0.0}, R}}, model::NoBonds{}));
    scene.bodies[0].velocity = {1.0, 0.0};
    step = share * step::bound_step(state::assemble(scene).state);
    auto& right = std::get<model::ListedDisks>(scene.bodies[1].packing).disks[0];
    right.centre.x += (2.0 + phase) * step;
    state::State state = state::assemble(scene).state;
    state.dt = step;
    mass = 0.5 * state.elements.mass(0);
    Team team(1);
    step::Stepper stepper(team, state, 0.2);
    step::start(state, stepper);
    Impact seen;
    do {
        step::advance(state, stepper);
        seen.overlap.push_back(2.0 * R - state.distance(0, 1));
        seen.closing.push_back(state.elements.vx[0] - state.elements.vx[1]);
    } while (seen.overlap.back() > 0.0 || seen.closing.back() > 0.0);
    Kn = state.contacts.rules[0].Kn;
    return seen;
}

} // namespace

TEST_CASE("no contact of two disks gives more than it took, from head-on to grazing", "[audit]") {
    for (const double degrees : {0.0, 30.0, 60.0, 80.0, 89.0}) {
        for (const double restitution : {0.2, 0.9, 1.0}) {
            for (const double friction : {0.0, 0.3, 2.0}) {
                for (const double share : {0.1, 0.8}) {
                    const double spin = friction > 1.0 ? -400.0 : 300.0;
                    CAPTURE(degrees, restitution, friction, share);
                    state::State state = two_disks(degrees * std::numbers::pi / 180.0, restitution, friction, spin);
                    state.dt = share * step::bound_step(state);
                    std::size_t open = 0;
                    CHECK_NOTHROW(open = audited(state, 4000));
                    CHECK((open > 0) == (degrees < 88.0));
                }
            }
        }
    }
}

TEST_CASE("no contact in a heap that falls down gives more than it took", "[audit]") {
    model::Scene scene = test::scene_of(test::bouncing(0.6, 0.4));
    scene.materials[0].youngs_modulus = 1e7;
    scene.materials[0].rolling_friction = 0.05;
    scene.gravity = {0.0, -9.81};
    scene.walls.push_back(test::wall_along("box", {{0.0, 1.0}, {0.0, 0.0}, {26.0 * R, 0.0}, {26.0 * R, 1.0}}));
    std::vector<model::Disk> heap;
    std::uint64_t drawn = 0;
    for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 10; ++column) {
            const double shift = R * uniform(7, 0, drawn++);
            heap.push_back(
                {{2.4 * R * (column + 0.6) + shift, 2.4 * R * (row + 0.6)}, R * (1.0 - 0.2 * uniform(7, 0, drawn++))});
        }
    }
    scene.bodies.push_back(test::disks("heap", heap, model::NoBonds{}));
    state::State state = state::assemble(scene).state;
    state.dt = 0.8 * step::bound_step(state);
    CHECK(audited(state, 6000) > 100000);
}

TEST_CASE("the contacts that broken bonds leave give no more than was left in them", "[audit]") {
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, {0.1, 0.05}, 4e-3, model::PlateauBonds{}));
    state::State state = state::assemble(scene).state;
    state.dt = 0.5 * step::bound_step(state);
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        const Vec2 at = state.elements.position(k) - Vec2{0.05, 0.025};
        state.elements.vx[k] = 300.0 * at.x * std::sin(60.0 * at.y);
        state.elements.vy[k] = -400.0 * at.y;
    }
    CHECK(audited(state, 3000) > 100);
    CHECK(state.cracks.size() > 20);
}

TEST_CASE("an elastic contact keeps the scheme's energy, and takes when met in the mean what it gives when let go",
          "[audit]") {
    // Between the instants of touch the energy of central difference, m v- v+/2 + Kn d^2/2, stays. At the first overlap d it
    // is less than what came by Kn d (s - d)/2, s the path in a step, at the last one more is left by the same expression.
    const double share = GENERATE(0.2, 0.8);
    constexpr int phases = 100;
    double sum = 0.0;
    double w_dt = 0.0;
    for (int k = 0; k < phases; ++k) {
        double dt = 0.0;
        double m = 0.0;
        double Kn = 0.0;
        const Impact seen = impact_at(share, (k + 0.5) / phases, dt, m, Kn);
        const auto& d = seen.overlap;
        const auto& v = seen.closing;
        w_dt = dt * std::sqrt(Kn / m);
        const double energy = 0.5 * m * v.front() * v.front();
        const auto kept = [&](std::size_t n) { return 0.5 * (m * v[n] * v[n + 1] + Kn * d[n] * d[n]); };
        const auto crossed = [&](std::size_t n, double s) { return 0.5 * Kn * d[n] * (s - d[n]); };
        // Places of 1e-2 m are rounded by 1e-18 m, steps in them are of 1e-6 m and longer.
        constexpr double rounding = 1e-10;
        const std::size_t first = seen.first();
        const std::size_t last = seen.last();
        for (std::size_t n = first; n <= last; ++n) CHECK(std::fabs(kept(n) - kept(first)) < rounding * energy);
        const double change = 0.5 * m * v.back() * v.back() - energy;
        const double lost = crossed(first, v.front() * dt);
        const double gained = crossed(last, -v.back() * dt);
        CHECK(std::fabs(change - (gained - lost)) < rounding * energy);
        CHECK(lost >= -rounding * energy);
        CHECK(lost <= (0.25 * w_dt * w_dt + rounding) * energy);
        CHECK(gained <= 0.25 * w_dt * w_dt * 0.5 * m * v.back() * v.back() + rounding * energy);
        sum += change / energy;
    }
    CHECK(w_dt > share * 0.4);
    // The two are alike but for the speed after, which differs by the same order.
    CHECK(std::fabs(sum / phases) < std::pow(0.5 * w_dt, 4));
}

TEST_CASE("a contact that pushes apart harder than it was pushed is found out", "[audit]") {
    state::State state = two_disks(0.0, 1.0, 0.0, 0.0);
    state.dt = 0.1 * step::bound_step(state);
    Team team(1);
    step::Stepper stepper(team, state, 0.2);
    step::start(state, stepper);
    step::ContactAudit audit;
    const auto run = [&] {
        for (int k = 0; k < 4000; ++k) {
            step::advance(state, stepper);
            const bool parting = state.contacts.size() > 0 && state.elements.vx[1] > state.elements.vx[0];
            if (parting) {
                state::PairForce stronger = state.contacts.forces.at(0);
                stronger.f.x *= 1.1;
                state.contacts.forces.set(0, stronger);
            }
            audit.book(state);
        }
    };
    CHECK_THROWS_AS(run(), RunError);
}
