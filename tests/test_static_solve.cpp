// States of rest found by a direct solution: closed forms, published compliances, the same reached by marching, and what
// is refused.
#include "engine/law/stiffness.hpp"
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

using namespace demlua;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr double R = 5e-3;

model::Support held(std::function<bool(Vec2)> where) {
    model::Support support;
    support.selection.where = std::move(where);
    return support;
}

model::Force pull(std::function<bool(Vec2)> where, Vec2 force) {
    model::Force pulling;
    pulling.selection.where = std::move(where);
    pulling.x = Signal::constant(force.x);
    pulling.y = Signal::constant(force.y);
    return pulling;
}

/// Two elements along x: the left one is held, the right one cannot turn (or it would swing on its bond without force).
model::Scene pair_scene(const model::BondChoice& bonds) {
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(test::disks("pair", {{{0.0, 0.0}, R}, {{2.0 * R, 0.0}, R}}, bonds));
    scene.supports.push_back(held([](Vec2 at) { return at.x < R; }));
    model::Support upright = held([](Vec2 at) { return at.x > R; });
    upright.x = upright.y = false;
    scene.supports.push_back(upright);
    return scene;
}

bool right_one(Vec2 at) { return at.x > R; }

law::ContactStiffness concrete_stiffness() {
    return law::contact_stiffness(law::plane_moduli(29.7e9, 0.3, false), 1.0);
}

/// method.md's cantilever: 3^k rows of 9 3^k elements, E = R0 = t = 1, nu = 0.3, R = 3 R0/3^k; its first column is held, or
/// with `wall` one column more to the left of it. The load is shared among the last column.
struct Cantilever {
    model::Scene scene;
    std::vector<std::size_t> tip;
    double length = 54.0;

    Cantilever(int k, bool wall, double load) {
        const int rows = static_cast<int>(std::lround(std::pow(3.0, k)));
        const int columns = 9 * rows;
        const double r = 3.0 / rows;
        model::Material material;
        material.youngs_modulus = 1.0;
        material.poissons_ratio = 0.3;
        material.density = 1.0;
        scene = test::scene_of(material);
        std::vector<model::Disk> disks;
        for (int row = 0; row < rows; ++row) {
            for (int column = wall ? -1 : 0; column < columns; ++column) {
                if (column == columns - 1) tip.push_back(disks.size());
                disks.push_back({{r * (2 * column + row % 2), std::numbers::sqrt3 * r * row}, r});
            }
        }
        scene.bodies.push_back(test::disks("beam", disks, model::ElasticBonds{}));
        const double last_held = wall ? -0.5 * r : 1.5 * r;
        scene.supports.push_back(held([=](Vec2 at) { return at.x < last_held; }));
        const double first_loaded = r * (2 * columns - 2.5);
        scene.forces.push_back(pull([=](Vec2 at) { return at.x > first_loaded; }, {0.0, load}));
    }

    [[nodiscard]] double sag(const observe::Simulation& sim) const {
        double sum = 0.0;
        for (const std::size_t k : tip) sum += sim.state().elements.uy[k];
        return sum / static_cast<double>(tip.size());
    }
};

} // namespace

TEST_CASE("a pulled bond stretches by F/Kn, and the loads' work is F^2/(2 Kn)", "[static]") {
    model::Scene scene = pair_scene(model::ElasticBonds{});
    const double F = 5e3;
    scene.forces.push_back(pull(right_one, {F, 0.0}));
    observe::Simulation sim(scene, 1);
    sim.set_velocity(test::all_of(0), {0.0, 0.0});
    const observe::RunReport report = sim.solve_static({}, {});
    CHECK(report.residual <= 1e-10);
    const double stretch = F / concrete_stiffness().normal;
    CHECK(sim.field("displacement_x", {})[1] == Approx(stretch).epsilon(1e-9));
    CHECK(sim.field("speed", {})[1] == Approx(0.0).margin(1e-15));
    const observe::Ledger energy = sim.ledger();
    CHECK(energy.work == Approx(0.5 * F * stretch).epsilon(1e-8));
    CHECK(std::fabs(energy.error) < 1e-12 * energy.work);
    CHECK(sim.step() == 1);
    // It stays there.
    sim.run(1e-4, {});
    CHECK(sim.field("displacement_x", {})[1] == Approx(stretch).epsilon(1e-9));
    CHECK(std::fabs(sim.ledger().error) < 1e-9 * energy.work);
}

TEST_CASE("a bond sheared between elements that cannot turn gives way by Q/Kt", "[static]") {
    model::Scene scene = pair_scene(model::ElasticBonds{});
    const double Q = 10.0;
    scene.forces.push_back(pull(right_one, {0.0, Q}));
    observe::Simulation sim(scene, 1);
    model::StaticSolve said;
    said.linear = true;
    sim.solve_static(said, {});
    CHECK(sim.field("displacement_y", {})[1] == Approx(Q / concrete_stiffness().shear).epsilon(1e-12));
    CHECK(sim.field("displacement_x", {})[1] == Approx(0.0).margin(1e-20));
}

TEST_CASE("a weight hangs m g/Kn below, and a given displacement is met", "[static]") {
    model::Scene scene = pair_scene(model::ElasticBonds{});
    scene.gravity = {9.81, 0.0};
    observe::Simulation hanging(scene, 1);
    hanging.solve_static({}, {});
    const double m = hanging.state().elements.mass(1);
    CHECK(hanging.field("displacement_x", {})[1] == Approx(m * 9.81 / concrete_stiffness().normal).epsilon(1e-8));
    CHECK(std::fabs(hanging.ledger().error) < 1e-12 * hanging.ledger().bonds);

    scene.gravity = {};
    model::Motion motion;
    motion.selection.where = right_one;
    motion.displacement_x = Signal::constant(1e-6);
    motion.displacement_y = Signal::constant(0.0);
    scene.motions.push_back(motion);
    observe::Simulation moved(scene, 1);
    for (int time = 0; time < 2; ++time) {
        moved.solve_static({}, {});
        CHECK(moved.field("displacement_x", {})[1] == Approx(1e-6).epsilon(1e-14));
        CHECK(moved.ledger().work == Approx(0.5 * concrete_stiffness().normal * 1e-12).epsilon(1e-6));
    }
}

TEST_CASE("the cantilever's compliance is the published one", "[static]") {
    struct Published {
        int k;
        bool wall;
        double compliance; // to two decimals
    };
    const auto known =
        GENERATE(Published{1, false, 4795.56}, Published{2, false, 4471.19}, Published{3, false, 4486.13},
                 Published{1, true, 5364.13}, Published{2, true, 4640.19}, Published{3, true, 4541.75});
    const double load = 1e-7;
    const Cantilever cantilever(known.k, known.wall, load);
    observe::Simulation sim(cantilever.scene, 1);
    model::StaticSolve said;
    said.linear = true;
    sim.solve_static(said, {});
    CHECK(std::fabs(cantilever.sag(sim) / load - known.compliance) <= 0.005);
}

TEST_CASE("marching to rest and solving for it agree, also where rotations are large", "[static]") {
    const double load = GENERATE(1e-6, 3e-3); // a sag of 0.005 and of about 13, of a length of 54
    const Cantilever cantilever(1, false, load);
    observe::Simulation solved(cantilever.scene, 1);
    const observe::RunReport report = solved.solve_static({}, {});
    CHECK(report.residual <= 1e-10);

    model::Scene damped = cantilever.scene;
    damped.dampings.push_back({1.0, 3.0e-4, std::nullopt, std::nullopt, {}}); // about critical for the first mode
    observe::Simulation marched(damped, 1);
    marched.run(40e3, {});
    const double sag = cantilever.sag(solved);
    CHECK((load < 1e-3 || sag > 0.2 * cantilever.length));
    CHECK(cantilever.sag(marched) == Approx(sag).epsilon(1e-8));
    const std::vector<double> turned = solved.field("rotation", {});
    CHECK(marched.field("rotation", {}).back() == Approx(turned.back()).epsilon(1e-8));
    CHECK(std::fabs(solved.ledger().error) < 1e-10 * solved.ledger().bonds);
}

TEST_CASE("what is held by nothing is named", "[static]") {
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(test::disks("plate",
                                       {{{0.0, 0.0}, R},
                                        {{2.0 * R, 0.0}, R},
                                        {{10.0 * R, 0.0}, R},
                                        {{12.0 * R, 0.0}, R},
                                        {{11.0 * R, std::numbers::sqrt3 * R}, R}},
                                       model::ElasticBonds{}));
    scene.supports.push_back(held([](Vec2 at) { return at.x < R; }));
    observe::Simulation sim(scene, 1);
    CHECK_THAT(
        sim.notes().back(),
        ContainsSubstring("plate: its bonds leave 2 separate parts; beside the largest of 3 elements: elements 0, 1 "
                          "of body \"plate\""));
    const std::uint64_t before = sim.hash();
    CHECK_THROWS_WITH(sim.solve_static({}, {}),
                      ContainsSubstring("elements 2, 3, 4 of body \"plate\" are held by nothing"));
    CHECK(sim.hash() == before);

    // One freedom short: a support in x and y lets the part turn.
    model::Support pin = held([](Vec2 at) { return at.x > 11.5 * R; });
    pin.rotation = false;
    scene.supports.push_back(pin);
    observe::Simulation pinned(scene, 1);
    CHECK_THROWS_WITH(pinned.solve_static({}, {}), ContainsSubstring("elements 2, 3, 4"));
    model::Support roller = held([](Vec2 at) { return at.x > 9.0 * R && at.x < 10.5 * R; });
    roller.rotation = roller.x = false;
    scene.supports.push_back(roller);
    // Now all parts are held, but element 1 swings on its one bond without force.
    scene.gravity = {0.0, -9.81};
    observe::Simulation swinging(scene, 1);
    CHECK_THROWS_WITH(swinging.solve_static({}, {}), ContainsSubstring("motion that takes no force"));
}

TEST_CASE("what a static solution cannot do is refused, and changes nothing", "[static]") {
    model::Scene yielding = pair_scene(model::PlateauBonds{});
    yielding.forces.push_back(pull(right_one, {0.9 * 19151.5, 0.0}));
    observe::Simulation sound(yielding, 1);
    CHECK_NOTHROW(sound.solve_static({}, {}));
    yielding.forces[0].x = Signal::constant(1.1 * 19151.5);
    observe::Simulation weak(yielding, 1);
    CHECK_THROWS_WITH(weak.solve_static({}, {}), ContainsSubstring("the bond of elements 0 and 1 would yield"));
    CHECK(weak.broken_bonds() == 0);
    CHECK(weak.step() == 0);

    model::Scene walled = pair_scene(model::ElasticBonds{});
    model::Wall wall;
    wall.name = "floor";
    wall.path = {{-1.0, -1.0}, {1.0, -1.0}};
    walled.walls.push_back(wall);
    observe::Simulation on_wall(walled, 1);
    CHECK_THROWS_WITH(on_wall.solve_static({}, {}), ContainsSubstring("knows no walls"));

    model::Scene rigid = pair_scene(model::ElasticBonds{});
    rigid.bodies.push_back(test::disks("stone", {{{0.0, 10.0 * R}, R}}, model::NoBonds{}));
    rigid.bodies[1].rigid = true;
    observe::Simulation with_stone(rigid, 1);
    CHECK_THROWS_WITH(with_stone.solve_static({}, {}), ContainsSubstring("knows no rigid bodies"));
}

TEST_CASE("elements that come to touch are no longer a matter of bonds", "[static]") {
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(test::disks("left", {{{0.0, 0.0}, R}}, model::NoBonds{}));
    scene.bodies.push_back(test::disks("right", {{{2.1 * R, 0.0}, R}}, model::NoBonds{}));
    scene.supports.push_back(held([](Vec2) { return true; }));
    model::Motion motion;
    motion.selection.where = right_one;
    motion.displacement_x = Signal::constant(-0.2 * R);
    scene.motions.push_back(motion);
    observe::Simulation sim(scene, 1);
    CHECK_THROWS_WITH(sim.solve_static({}, {}), ContainsSubstring("at rest elements 0 and 1 press on each other"));
}

TEST_CASE("elements at one place are refused before they are bonded", "[static]") {
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(
        test::disks("twice", {{{0.0, 0.0}, R}, {{2.0 * R, 0.0}, R}, {{0.0, 0.0}, R}}, model::ElasticBonds{}));
    CHECK_THROWS_WITH(observe::Simulation(scene, 1), ContainsSubstring("elements 0 and 2 are both at (0, 0) m"));
}
