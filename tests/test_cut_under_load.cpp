// A notch cut between runs, in a body that bears load.
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace demlua;

TEST_CASE("a cut through a strained block sets its halves free, and the ledger knows what that released") {
    constexpr double R = 5e-3;
    const auto network = GENERATE(model::Network::unit_cell, model::Network::facets);
    model::SofteningBonds bonds;
    bonds.network = network;
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, {0.1, 0.1}, R, bonds));
    for (const auto& [side, uy] : {std::pair{model::Side::bottom, -1e-6}, std::pair{model::Side::top, 1e-6}}) {
        model::Motion motion;
        motion.selection = test::side_of(0, side);
        motion.displacement_x = Signal::constant(0.0);
        motion.displacement_y = Signal::constant(uy);
        scene.motions.push_back(motion);
    }
    observe::Simulation sim(scene, 1);
    sim.solve_static({}, {});
    const double stored = sim.ledger().bonds;
    REQUIRE(stored > 0.0);

    model::Notch notch;
    notch.from = {-R, 0.0471};
    notch.to = {0.1 + R, 0.0471};
    scene.notches.push_back(notch);
    sim.take_in(scene);
    CHECK(sim.broken_bonds() > 10);
    CHECK(sim.ledger().fracture > 0.0);
    CHECK(std::fabs(sim.ledger().error) < 1e-12 * stored);
    // Both halves swing about their unstrained shape: within 1e-4 s, some periods, most of what was stored is motion at some
    // instant. Forces that jump are kinetic energy of half a step, sum dt^2 f^2/(8 m) of the elements beside the cut, or
    // (w dt)^2/8 of their share of what was stored, a tenth: below 1e-2. Forces left behind by the cut would do work of the
    // order of what was stored.
    double most = 0.0;
    sim.run(1e-4, {test::watching(0.0, [&](observe::Simulation& now) {
                most = std::max(most, now.ledger().kinetic);
                CHECK(std::fabs(now.ledger().error) < 1e-2 * stored);
            })});
    CHECK(most > 0.5 * (stored - sim.ledger().fracture));
}
