// Loops over several rows at a time give what the loop over one row gives, to the last bit.
#include "engine/base/team.hpp"
#include "engine/law/bond_motion.hpp"
#include "engine/state/assemble.hpp"
#include "engine/step/kernels.hpp"
#include "engine/step/step.hpp"
#include "engine/step/time_step.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <variant>
#include <vector>

using namespace demlua;

namespace {

std::vector<std::size_t> widths() {
    std::vector<std::size_t> found;
    for (std::size_t width = 1; width <= step::widest_kernels(); width *= 2) found.push_back(width);
    return found;
}

/// Pairs in rows, whose columns are read straight; pairs of an irregular pack, looked up one by one; facets of such a pack.
enum class Body { rows, scattered, facets };

/// A block under way, each of its places at a speed of its own: it stretches, turns and hits its own pieces.
state::State torn_block(const model::BondChoice& bonds, Body body, model::Precision precision) {
    model::Scene scene = test::scene_of(test::concrete());
    scene.precision = precision;
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, {0.6, 0.3}, 4e-3, bonds));
    if (body != Body::rows) {
        model::Relaxation pack;
        pack.count = 3001;
        pack.steps = 5;
        scene.bodies.back().packing = pack;
    }
    if (body == Body::scattered) {
        std::visit(
            [](auto& choice) {
                if constexpr (requires { choice.network; }) choice.network = model::Network::delaunay;
            },
            scene.bodies.back().bonds);
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
    return state;
}

/// All that moves, after `steps` steps.
std::vector<double> moved(state::State& state, std::size_t width, int threads, int steps) {
    state::Elements& elements = state.elements;
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

std::vector<double> torn(const model::BondChoice& bonds, std::size_t width, int threads, Body body,
                         model::Precision precision = model::Precision::full) {
    state::State state = torn_block(bonds, body, precision);
    return moved(state, width, threads, 300);
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
        for (const Body body : {Body::rows, Body::scattered, Body::facets}) {
            if (body != Body::facets && std::holds_alternative<model::CohesiveBonds>(law)) continue;
            const std::vector<double> alone = torn(law, 1, 1, body);
            CAPTURE(law.index(), static_cast<int>(body));
            const bool breaks = !std::holds_alternative<model::ElasticBonds>(law);
            CHECK((alone.back() > 100.0) == breaks);
            for (const std::size_t width : widths()) {
                CAPTURE(width);
                CHECK(torn(law, width, width == 8 ? 3 : 1, body) == alone);
            }
        }
    }
}

TEST_CASE("every width moves a breaking body in mixed precision alike, to the last bit", "[lanes][mixed]") {
    const model::BondChoice law = damped<model::PlateauBonds>(0.02);
    for (const Body body : {Body::rows, Body::scattered, Body::facets}) {
        CAPTURE(static_cast<int>(body));
        const std::vector<double> alone = torn(law, 1, 1, body, model::Precision::mixed);
        CHECK(alone.back() > 100.0);
        for (const std::size_t width : widths()) {
            CAPTURE(width);
            CHECK(torn(law, width, width == 8 ? 3 : 1, body, model::Precision::mixed) == alone);
        }
    }
}

TEST_CASE("facets taken band by band move as those taken all at once, to the last bit", "[lanes]") {
    const model::BondChoice law = damped<model::PlateauBonds>(0.02);
    state::State in_bands = torn_block(law, Body::facets, model::Precision::full);
    state::State at_once = in_bands;
    auto& facets = std::get<state::FacetSet<law::Plateau>>(at_once.bond_sets.front());
    CHECK(facets.bands.size() > 3);
    facets.bands = {facets.slots.elements, {0, static_cast<Index>(facets.size())}};
    const std::vector<double> expected = moved(at_once, step::widest_kernels(), 1, 300);
    CHECK(expected.back() > 100.0);
    for (const int threads : {1, 2, 3, 8}) {
        CAPTURE(threads);
        state::State state = in_bands;
        CHECK(moved(state, step::widest_kernels(), threads, 300) == expected);
    }
}

TEST_CASE("forces in quads and in columns give the same sums, to the last bit, and no force on the whole", "[lanes]") {
    constexpr std::size_t elements = 37;
    constexpr std::size_t pairs = 111;
    Column<Index> i;
    Column<Index> j;
    for (std::size_t k = 0; k < pairs; ++k) {
        i.push_back(static_cast<Index>(k % elements));
        j.push_back(static_cast<Index>((7 * k + 3) % elements));
    }
    state::PairForces columns;
    state::PairForces quads;
    columns.lay_out_columns(pairs + 1);
    quads.lay_out_quads(pairs + 1);
    for (std::size_t k = 0; k < pairs; ++k) {
        const double x = static_cast<double>(k);
        const state::PairForce force{{std::sin(x), std::cos(1.7 * x)}, std::sin(0.3 * x), 0.1 * std::cos(x)};
        columns.set(k, force);
        quads.set(k, force);
    }
    const state::PairSlots slots = state::slots_of(i, j, 0, elements);
    const auto sums = [&](const state::PairForces& forces, std::size_t width) {
        std::vector<double> x(elements);
        std::vector<double> y(elements);
        std::vector<double> moment(elements);
        const step::PairSums rows{forces.rows(), slots.start.data(), slots.row.data(),
                                  x.data(),      y.data(),           moment.data()};
        step::run_rows(step::kernels_of(width), {0, elements, 0},
                       [&](const step::Kernels& kernels, std::size_t begin, std::size_t end) {
                           kernels.sum_pairs(rows, begin, end);
                       });
        CHECK(std::fabs(std::accumulate(x.begin(), x.end(), 0.0)) < 1e-13);
        CHECK(std::fabs(std::accumulate(y.begin(), y.end(), 0.0)) < 1e-13);
        x.insert(x.end(), y.begin(), y.end());
        x.insert(x.end(), moment.begin(), moment.end());
        return x;
    };
    const std::vector<double> expected = sums(columns, 1);
    double moments = 0.0;
    for (std::size_t k = 0; k < pairs; ++k) moments += columns.at(k).moment_i + columns.at(k).moment_j;
    CHECK(std::accumulate(expected.begin() + 2 * elements, expected.end(), 0.0) == Catch::Approx(moments));
    for (const std::size_t width : widths()) {
        CAPTURE(width);
        CHECK(sums(columns, width) == expected);
        CHECK(sums(quads, width) == expected);
    }
}

TEST_CASE("a rotation is that of the standard library to 2e-15, up to a hundred turns", "[lanes]") {
    for (int k = -2000; k <= 2000; ++k) {
        const double angle = 0.3142 * k;
        const Rotation<double> by = rotation_by(angle);
        CHECK(std::fabs(by.cosine - std::cos(angle)) < 2e-15);
        CHECK(std::fabs(by.sine - std::sin(angle)) < 2e-15);
    }
}

TEST_CASE("a bond that has turned is measured as by the exact form, through any number of turns", "[lanes]") {
    const Vec2 D{0.8e-3, -0.6e-3};
    const double l = norm(D);
    for (int k = 0; k <= 400; ++k) {
        const double turn = 0.77 * k;
        const double strain = 1e-3 * std::sin(2.0 * k);
        const double slip = 5e-3 * std::cos(3.0 * k);
        const double c = (1.0 + strain) * std::cos(turn + slip);
        const double s = (1.0 + strain) * std::sin(turn + slip);
        const Vec2 du{c * D.x - s * D.y - D.x, s * D.x + c * D.y - D.y};
        const law::BondMotion<double> motion = law::bond_motion(D, l, 1.0 / l, du, turn);
        const law::BondMotion<double> exact = law::large_motion(D, l, du, turn);
        CAPTURE(turn);
        CHECK(std::fabs(motion.stretch - exact.stretch) < 4e-15 * l);
        // An angle of k turns is known to the rounding of k turns.
        CHECK(std::fabs(motion.shear - exact.shear) < (4e-15 + 4e-16 * turn) * l);
        CHECK(std::fabs(motion.shear - slip * l) < (4e-15 + 4e-16 * turn) * l);
        CHECK(norm(motion.normal - exact.normal) < 4e-15);
        CHECK(motion.inverse_length == Catch::Approx(exact.inverse_length).epsilon(4e-15));
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
        const double slope = share * small_slope;
        CHECK(angle_of_small(slope) == Catch::Approx(std::atan(slope)).epsilon(3e-16));
    }
}
