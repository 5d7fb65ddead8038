// Loops over several rows at a time give what the loop over one row gives, to the last bit.
#include "engine/base/team.hpp"
#include "engine/state/assemble.hpp"
#include "engine/step/kernels.hpp"
#include "engine/step/step.hpp"
#include "engine/step/time_step.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>
#include <vector>

using namespace demlua;

namespace {

std::vector<std::size_t> widths() {
    std::vector<std::size_t> found;
    for (std::size_t width = 1; width <= step::widest_kernels(); width *= 2) found.push_back(width);
    return found;
}

/// All that moves, after `steps` steps of a block that is torn apart: it stretches, turns and hits its own pieces.
std::vector<double> torn(const model::BondChoice& bonds, std::size_t width, int threads, int steps, bool facets,
                         model::Precision precision = model::Precision::full) {
    model::Scene scene = test::scene_of(test::concrete());
    scene.precision = precision;
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, {0.6, 0.3}, 4e-3, bonds));
    if (facets) {
        model::Relaxation pack;
        pack.count = 3001;
        pack.steps = 5;
        scene.bodies.back().packing = pack;
    }
    scene.gravity = {0.0, -9.81};
    state::State state = state::assemble(scene).state;
    state.dt = 0.8 * step::bound_step(state);
    state::Elements& elements = state.elements;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const Vec2 at{elements.reference_x[k] - 0.3, elements.reference_y[k] - 0.15};
        elements.vx[k] = 30.0 * std::sin(20.0 * at.x) - 60.0 * at.y;
        elements.vy[k] = 10.0 * std::cos(15.0 * at.x) + 60.0 * at.x;
    }
    Team team({threads, 1});
    step::Stepper stepper(team, state, 0.2);
    stepper.kernels = &step::kernels_of(width);
    step::start(state, stepper);
    for (int k = 0; k < steps; ++k) step::advance(state, stepper);
    std::vector<double> all;
    for (const Column<double>* column : {&elements.ux, &elements.uy, &elements.rotation, &elements.vx, &elements.vy}) {
        all.insert(all.end(), column->begin(), column->end());
    }
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit([&](const auto& set) { all.push_back(static_cast<double>(set.broken_count)); }, any);
    }
    return all;
}

template <class Bonds>
Bonds damped(double damping) {
    Bonds bonds;
    bonds.damping = damping;
    return bonds;
}

} // namespace

TEST_CASE("every width and every number of threads moves a breaking body alike, to the last bit", "[lanes]") {
    const std::vector<model::BondChoice> laws{
        damped<model::ElasticBonds>(0.0),          damped<model::PlateauBonds>(0.02),
        damped<model::SofteningBonds>(0.0),        damped<model::BrittleTensileBonds>(0.02),
        damped<model::BrittleToughnessBonds>(0.0), damped<model::CohesiveBonds>(0.02)};
    for (const model::BondChoice& law : laws) {
        for (const bool facets : {false, true}) {
            const bool pairs_too = !std::holds_alternative<model::CohesiveBonds>(law);
            if (!facets && !pairs_too) continue;
            const std::vector<double> alone = torn(law, 1, 1, 300, facets);
            CAPTURE(law.index(), facets);
            const bool breaks = !std::holds_alternative<model::ElasticBonds>(law);
            CHECK((alone.back() > 100.0) == breaks);
            for (const std::size_t width : widths()) {
                CAPTURE(width);
                CHECK(torn(law, width, width == 8 ? 3 : 1, 300, facets) == alone);
            }
        }
    }
}

TEST_CASE("every width moves a breaking body in mixed precision alike, to the last bit", "[lanes][mixed]") {
    const model::BondChoice law = damped<model::PlateauBonds>(0.02);
    for (const bool facets : {false, true}) {
        CAPTURE(facets);
        const std::vector<double> alone = torn(law, 1, 1, 300, facets, model::Precision::mixed);
        CHECK(alone.back() > 100.0);
        for (const std::size_t width : widths()) {
            CAPTURE(width);
            CHECK(torn(law, width, width == 8 ? 3 : 1, 300, facets, model::Precision::mixed) == alone);
        }
    }
}

TEST_CASE(
    "the angle of a vector is that of the standard library to 4.5e-16 rad, or of itself where it is more than one",
    "[lanes]") {
    for (int k = -1800; k <= 1800; ++k) {
        const double angle = k * std::numbers::pi / 1800.5;
        const double expected = std::atan2(std::sin(angle), std::cos(angle));
        CHECK(std::fabs(angle_of(3.0 * std::cos(angle), 3.0 * std::sin(angle)) - expected) <=
              4.5e-16 * std::max(1.0, std::fabs(expected)));
    }
}

TEST_CASE("series of small motions meet the functions they stand for at the end of their range", "[lanes]") {
    for (const double share : {-1.0, -0.3, 0.3, 1.0}) {
        const double x = share * small_growth;
        CHECK(root_growth(x) == Catch::Approx(std::expm1(0.5 * std::log1p(x))).epsilon(3e-16));
        CHECK(inverse_growth(x) == Catch::Approx(1.0 / (1.0 + x)).epsilon(4e-16));
        const double sine = share * small_sine;
        CHECK(angle_of_small(sine) == Catch::Approx(std::asin(sine)).epsilon(3e-16));
    }
}
