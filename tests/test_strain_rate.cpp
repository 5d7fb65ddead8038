// Strain-rate factors: the published curve, and what one bond pulled at one rate bears and costs.
#include "engine/law/rate_dependent.hpp"
#include "engine/model/derived_law.hpp"
#include "engine/observe/simulation.hpp"
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;
constexpr double fc = 30e6;
constexpr double fracture_energy = 1e12 / 29.7e9; // of test::concrete, J/m^2
constexpr double cap = 19151.5;                   // of a pair, N: eq. 32 for test::concrete

template <class Bonds>
model::BondChoice with_rates(std::optional<double> window = std::nullopt) {
    Bonds bonds;
    bonds.rate_compressive_strength = fc;
    bonds.rate_window = window;
    return bonds;
}

struct Broken {
    double pull = 0.0;    ///< the greatest, N
    double stretch = 0.0; ///< at breaking, m
    double spent = 0.0;   ///< J
    double factor = 0.0;
};

template <class Law>
Broken pull_apart(const model::BondChoice& bonds, const Signal& along) {
    observe::Simulation sim(test::pulled_pair(bonds, R, along), 1);
    Broken seen;
    sim.run(along.times.back(), {test::watching(0.0, [&](observe::Simulation& now) {
                const observe::Snapshot snapshot = now.snapshot();
                seen.pull = std::max(seen.pull, std::get<std::vector<double>>(snapshot.bond_fields.at(0).values).at(0));
                seen.stretch = now.field("displacement_x", {}).at(1);
                if (now.broken_bonds() > 0) now.stop("broken");
            })});
    CHECK(sim.broken_bonds() == 1);
    const observe::Ledger energy = sim.ledger();
    seen.spent = energy.plastic + energy.fracture;
    CHECK(std::fabs(energy.error) < 1e-3 * energy.work);
    seen.factor = std::get<state::BondSet<law::RateDependent<Law>>>(sim.state().bond_sets[0]).history.at(0).factor;
    return seen;
}

/// Stretched at `rate` (1/s) from the start, for a stretch of 60 um.
Signal at_rate(double rate) {
    const double speed = rate * 2.0 * R;
    return Signal{{0.0, 60e-6 / speed}, {0.0, 60e-6}};
}

law::RateDependent<law::Plateau>::Params rated_caps(double exponent) {
    constexpr law::PlaneModuli plane{29.7e9, 0.3};
    return {law::Plateau::derive(law::strength_caps(law::contact_stiffness(plane, 1.0), plane, 1.0, 3.44e6, 1e6, 1.0),
                                 false),
            {exponent, 1e-5}};
}

} // namespace

TEST_CASE("the factor of Malvar & Crawford rises from 1, bends at 1 /s and does not jump there") {
    for (const double strength : {10e6, 30e6, 50e6, 100e6}) {
        const double d = law::rate_exponent(strength);
        CHECK(d == Approx(1.0 / (1.0 + 0.8 * strength / 1e6)).epsilon(1e-14));
        CHECK(law::tension_factor(d, 0.0) == 1.0);
        CHECK(law::tension_factor(d, 1e-6) == 1.0);
        CHECK(law::tension_factor(d, std::nextafter(1e-6, 1.0)) == Approx(1.0).epsilon(1e-12));
        CHECK(law::tension_factor(d, 1e-3) == Approx(std::pow(10.0, 3.0 * d)).epsilon(1e-13));
        const double at = law::tension_factor(d, 1.0);
        const double beyond = law::tension_factor(d, std::nextafter(1.0, 2.0));
        CHECK(at == Approx(std::pow(10.0, 6.0 * d)).epsilon(1e-13));
        CHECK(std::fabs(beyond / at - 1.0) < 1e-12);
        CHECK(law::tension_factor(d, 8.0) / at == Approx(2.0).epsilon(1e-13));
    }
}

TEST_CASE("a bond pulled at one rate breaks at f s and spends f^0.5 G") {
    // At 0.01 /s it yields 1e4 windows after the start. Figures of a stretch are seen within a step, 1e-4 m/s times 2 us.
    const double rate = 0.01;
    const double f = std::pow(rate / 1e-6, 1.0 / 25.0);
    const double owed = std::sqrt(f) * fracture_energy * 2.0 * R;
    const Signal along = at_rate(rate);
    SECTION("plateau") {
        const Broken seen = pull_apart<law::Plateau>(with_rates<model::PlateauBonds>(), along);
        CHECK(seen.factor == Approx(f).epsilon(1e-4));
        CHECK(seen.pull == Approx(f * cap).epsilon(1e-4));
        CHECK(seen.stretch == Approx(owed / (f * cap) + 0.5 * f * 0.78182e-6).epsilon(1e-3));
        CHECK(seen.spent == Approx(owed).epsilon(1e-3));
    }
    SECTION("softening") {
        const Broken seen = pull_apart<law::Softening>(with_rates<model::SofteningBonds>(), along);
        CHECK(seen.pull == Approx(f * cap).epsilon(1e-3));
        CHECK(seen.stretch == Approx(2.0 * owed / (f * cap)).epsilon(1e-3));
        CHECK(seen.spent == Approx(owed).epsilon(1e-4));
    }
}

TEST_CASE("a rate that jumps after the first yield changes nothing") {
    // It has yielded at 1.2 um: f is at most 1.45 and the slow cap is reached at 0.782 um.
    const double speed = 0.01 * 2.0 * R;
    const double until = 1.2e-6 / speed;
    const Signal jumping{{0.0, until, until + 58.8e-6 / (10.0 * speed)}, {0.0, 1.2e-6, 60e-6}};
    const model::BondChoice bonds = with_rates<model::PlateauBonds>();
    const Broken even = pull_apart<law::Plateau>(bonds, at_rate(0.01));
    const Broken jumped = pull_apart<law::Plateau>(bonds, jumping);
    // The first yield falls in the same step, as both runs are the same up to there.
    CHECK(jumped.factor == Approx(even.factor).epsilon(1e-12));
    CHECK(jumped.pull == Approx(even.pull).epsilon(1e-12));
    CHECK(jumped.stretch == Approx(even.stretch).epsilon(1e-3));
    CHECK(jumped.spent == Approx(even.spent).epsilon(1e-3));
}

TEST_CASE("the mean rate follows a jump with the time constant it was given") {
    // r = rate (1 - exp(-t/window)) after a start at rate, in steps of dt: exact at the instants.
    const double window = 1e-3;
    const double rate = 1e-5;
    observe::Simulation sim(test::pulled_pair(with_rates<model::PlateauBonds>(window), R, at_rate(rate)), 1);
    sim.run(2e-3, {});
    const auto& bonds = std::get<state::BondSet<law::RateDependent<law::Plateau>>>(sim.state().bond_sets[0]);
    // A drive gives the motion from the first half step on: a step more or less of a window.
    const double dt = sim.state().dt;
    CHECK(bonds.history.at(0).rate == Approx(rate * (1.0 - std::exp(-sim.time() / window))).epsilon(2.0 * dt / window));
}

TEST_CASE("slow bonds are those without factors, and no factor makes a bond unable to run its course") {
    law::RateDependent<law::Plateau>::Params p = rated_caps(law::rate_exponent(fc));
    law::RateDependent<law::Plateau>::History<double> slow;
    slow.rate = 1e-6;
    CHECK(law::RateDependent<law::Plateau>::caps(p, R, slow).normal == Approx(cap).epsilon(1e-5));
    law::RateDependent<law::Plateau>::History<double> fast;
    fast.rate = 1e9;
    const double f = law::RateDependent<law::Plateau>::factor(p, R, fast);
    const law::StrengthCaps high = law::scaled(p, f, law::energy_factor(f));
    CHECK(law::Plateau::largest_radius(high) > R);
    CHECK(law::Plateau::largest_radius(high) < 1.02 * R);
}

TEST_CASE("a block drawn to pieces under strain rates keeps its ledger, with pairs and with facets") {
    const bool facets = GENERATE(false, true);
    const model::BondChoice chosen = GENERATE(with_rates<model::PlateauBonds>(), with_rates<model::SofteningBonds>());
    model::BondChoice bonds = chosen;
    std::visit(
        [&](auto& each) {
            if constexpr (model::takes_rates<std::decay_t<decltype(each)>>) {
                each.damping = 0.02;
                each.network = facets ? model::Network::facets : model::Network::unit_cell;
            }
        },
        bonds);
    model::Scene scene = test::scene_of(test::concrete());
    scene.step_fraction = 0.4;
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, {0.2, 0.1}, R, bonds));
    for (const auto& [side, vx] : {std::pair{model::Side::left, -0.02}, std::pair{model::Side::right, 0.02}}) {
        model::Motion motion;
        motion.selection = test::side_of(0, side);
        motion.velocity_x = Signal{{0.0, 1e-3}, {0.0, vx}};
        scene.motions.push_back(motion);
    }
    const auto drawn = [&](int threads) {
        auto sim = std::make_unique<observe::Simulation>(scene, Threads{threads, 1});
        double most = 0.0;
        sim->run(6e-3, {test::watching(1e-4, [&](observe::Simulation& now) {
                     const observe::Ledger energy = now.ledger();
                     most = std::max(most, energy.work);
                     const bool elastic = energy.plastic == 0.0 && now.broken_bonds() == 0;
                     CHECK(std::fabs(energy.error) <= (elastic ? 1e-6 : 1e-3) * most);
                 })});
        return sim;
    };
    const auto alone = drawn(1);
    CHECK(alone->broken_bonds() > 10);
    CHECK(drawn(2)->hash() == alone->hash());
}
