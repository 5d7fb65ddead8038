// Bonds whose numbers are kept in single precision: what that costs in accuracy.
#include "engine/observe/ledger.hpp"
#include "engine/state/assemble.hpp"
#include "engine/step/step.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <cmath>
#include <cstddef>

using namespace demlua;

namespace {

constexpr double L = 0.1; // m, side of the block
constexpr int steps = 2000;

/// An elastic block that swings, close packed or irregular with facets.
model::Scene swinging(model::Precision precision, bool facets) {
    model::Scene scene = test::scene_of(test::concrete());
    scene.precision = precision;
    model::Body body = test::block("block", {0.0, 0.0}, {L, L}, 0.03 * L, model::ElasticBonds{});
    if (facets) {
        model::Relaxation pack;
        pack.count = 300;
        body.packing = pack;
    }
    scene.bodies.push_back(body);
    return scene;
}

struct End {
    state::State state;
    double energy_at_start = 0.0;
    double energy = 0.0;
    Vec2 momentum;
};

double energy_of(const state::State& state) {
    const observe::Ledger ledger = observe::ledger_of(state);
    return ledger.kinetic + ledger.bonds;
}

End swung(model::Precision precision, bool facets) {
    End end;
    end.state = state::assemble(swinging(precision, facets)).state;
    state::State& state = end.state;
    state.dt = 2e-7;
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        const Vec2 at = state.elements.position(k);
        state.elements.vx[k] = 0.1 * std::sin(31.0 * at.x) * std::cos(31.0 * at.y);
    }
    Team team(1);
    step::Stepper stepper(team, state, 0.2);
    step::start(state, stepper);
    end.energy_at_start = energy_of(state);
    for (int k = 0; k < steps; ++k) step::advance(state, stepper);
    end.energy = energy_of(state);
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        end.momentum += state.elements.mass(k) * state.elements.velocity(k);
    }
    return end;
}

} // namespace

TEST_CASE("bonds in single precision move a body as those in double do, but for their rounding", "[mixed]") {
    // A number that a step reads of a bond is off by at most 2^-24 of itself. Stiffness and so frequencies are off by no more,
    // phases after n steps by n w dt 2^-24 with w dt < 2; energy, which every step changes by the rounding of forces times the
    // displacement of the step, by no more than 2^-24 of what is exchanged: twice itself a step at most.
    const double rounding = std::ldexp(1.0, -24);
    for (const bool facets : {false, true}) {
        CAPTURE(facets);
        const End full = swung(model::Precision::full, facets);
        const End mixed = swung(model::Precision::mixed, facets);
        double apart = 0.0;
        double swing = 0.0;
        for (std::size_t k = 0; k < full.state.elements.size(); ++k) {
            apart = std::max(apart, norm(full.state.elements.displacement(k) - mixed.state.elements.displacement(k)));
            swing = std::max(swing, norm(full.state.elements.displacement(k)));
        }
        CHECK(apart > 0.0);
        CHECK(apart < 2.0 * steps * rounding * swing);
        CHECK(std::fabs(mixed.energy - full.energy) < 2.0 * steps * rounding * full.energy);
        CHECK(norm(mixed.momentum - full.momentum) < 1e-12 * norm(full.momentum));
    }
}

TEST_CASE("bonds in single precision take less room", "[mixed]") {
    const state::State full = state::assemble(swinging(model::Precision::full, false)).state;
    const state::State mixed = state::assemble(swinging(model::Precision::mixed, false)).state;
    const auto& wide = std::get<state::BondSet<law::Elastic>>(full.bond_sets.front());
    const auto& narrow = std::get<state::BondSet<law::Elastic>>(mixed.bond_sets.front());
    CHECK(wide.forces.rows().fx.narrow == nullptr);
    CHECK(narrow.forces.rows().fx.wide == nullptr);
    CHECK(wide.length.even());
    CHECK(narrow.length[0] == wide.length[0]);
    CHECK(narrow.Dx[0] == static_cast<double>(static_cast<float>(wide.Dx[0])));
}
