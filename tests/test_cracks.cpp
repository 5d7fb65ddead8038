// The record of what broke: where, when, how, at what cost, and which breaks make one crack.
#include "engine/observe/cracks.hpp"
#include "engine/output/vtu.hpp"
#include "engine/packing/cells.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;
constexpr Vec2 size{0.2, 0.1};

template <class T>
std::vector<T> crack_field(const observe::Snapshot& seen, const std::string& name) {
    for (const observe::Field& field : seen.crack_fields) {
        if (field.name == name) return std::get<std::vector<T>>(field.values);
    }
    return {};
}

Vec2 middle_of(const std::array<Vec2, 2>& ends) { return 0.5 * (ends[0] + ends[1]); }

model::Notch notch(Vec2 from, Vec2 to) { return {0, from, to, {}}; }

/// A close-packed block, rows horizontal, or an irregular one bonded across facets.
model::Scene block_scene(bool facets) {
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, size, R, model::PlateauBonds{}));
    if (facets) {
        model::Relaxation relaxed;
        relaxed.count = 250;
        scene.bodies[0].packing = relaxed;
    }
    return scene;
}

/// Height of the middle between the fifth and the sixth row of the close-packed block.
const double between_rows = R + 4.5 * std::numbers::sqrt3 * R;

std::size_t cluster_count(const observe::Simulation& sim) {
    const std::vector<std::int32_t> clusters = observe::crack_clusters(sim.state());
    return std::set<std::int32_t>(clusters.begin(), clusters.end()).size();
}

/// Two disks, the left one held, the right one led at a steady velocity without turning.
model::Scene led_pair(Vec2 velocity) {
    model::Scene scene = test::scene_of(test::concrete());
    scene.bodies.push_back(
        test::disks("pair", {{{0.0, 0.0}, R}, {{2.0 * R, 0.0}, R}}, model::PlateauBonds{{0.1, 0.0}, true}));
    model::Support held;
    held.selection = test::all_of(0);
    held.selection.where = [](Vec2 at) { return at.x < R; };
    scene.supports.push_back(held);
    model::Motion led;
    led.selection = test::all_of(0);
    led.selection.where = [](Vec2 at) { return at.x > R; };
    led.velocity_x = Signal::constant(velocity.x);
    led.velocity_y = Signal::constant(velocity.y);
    led.spin = Signal::constant(0.0);
    scene.motions.push_back(led);
    return scene;
}

/// What the record says at the first instant at which a bond is broken.
observe::Snapshot at_breaking(observe::Simulation& sim, double longest) {
    observe::Snapshot seen;
    sim.run(longest, {test::watching(0.0, [&](observe::Simulation& now) {
                if (now.broken_bonds() == 0) return;
                seen = now.snapshot();
                now.stop("broken");
            })});
    return seen;
}

/// An irregular strip with a notch, torn apart.
model::Scene torn_strip(const model::BondChoice& bonds) {
    model::Scene scene = test::scene_of(test::concrete());
    model::Body strip;
    strip.name = "strip";
    strip.region = model::Region::rectangle({0.0, 0.0}, size);
    model::Consolidation pack;
    pack.count = 600;
    pack.solid_fraction = 0.8;
    strip.packing = pack;
    strip.bonds = bonds;
    scene.bodies.push_back(strip);
    for (const auto& [side, vx] : {std::pair{model::Side::left, -1.0}, std::pair{model::Side::right, 1.0}}) {
        model::Motion motion;
        motion.selection = test::side_of(0, side);
        motion.velocity_x = Signal::constant(vx);
        scene.motions.push_back(motion);
    }
    scene.notches.push_back(notch({0.1, 0.0}, {0.1, 0.02}));
    return scene;
}

/// What the broken bonds have spent by their own account: plastic work by bond, fracture work by body.
double spent_by_broken(const state::State& state) {
    double sum = 0.0;
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                if constexpr (std::decay_t<decltype(bonds)>::law::yields) {
                    for (std::size_t k = 0; k < bonds.size(); ++k) {
                        if (bonds.is_broken(k)) sum += bonds.history.at(k).work;
                    }
                }
                sum += bonds.fracture_work;
            },
            any);
    }
    return sum;
}

} // namespace

TEST_CASE("a notch between close-packed rows is a zigzag of segments square to its bonds", "[cracks]") {
    model::Scene scene = block_scene(false);
    scene.notches.push_back(notch({-0.01, between_rows}, {0.101, between_rows}));
    const observe::Simulation sim(scene, 1);
    const observe::Snapshot seen = sim.snapshot();
    const auto i = crack_field<std::int32_t>(seen, "i");
    const auto j = crack_field<std::int32_t>(seen, "j");
    // Two bonds for each element of the lower row up to the notch's end, but one at an end of the row.
    REQUIRE(seen.crack_ends.size() >= 19);
    REQUIRE(seen.crack_ends.size() == sim.broken_bonds());
    std::vector<double> middles;
    for (std::size_t k = 0; k < seen.crack_ends.size(); ++k) {
        const Vec2 along = seen.crack_ends[k][1] - seen.crack_ends[k][0];
        const Vec2 bond = seen.position[static_cast<std::size_t>(j[k])] - seen.position[static_cast<std::size_t>(i[k])];
        CHECK(norm(along) == Approx(2.0 * R).epsilon(1e-12));
        CHECK(std::fabs(dot(along, bond)) < 1e-12 * R * R);
        CHECK(middle_of(seen.crack_ends[k]).y == Approx(between_rows).epsilon(1e-12));
        middles.push_back(middle_of(seen.crack_ends[k]).x);
    }
    std::sort(middles.begin(), middles.end());
    for (std::size_t k = 1; k < middles.size(); ++k) CHECK(middles[k] - middles[k - 1] == Approx(R).epsilon(1e-9));
    for (const double energy : crack_field<double>(seen, "energy")) CHECK(energy == 0.0);
    for (const double time : crack_field<double>(seen, "time")) CHECK(time == 0.0);
    for (const std::int32_t mode : crack_field<std::int32_t>(seen, "mode")) CHECK(mode == 2);
    CHECK(cluster_count(sim) == 1);
    CHECK(sim.surface_energy() == 0.0);
}

TEST_CASE("across facets the pieces of a crack are the facets of the cells", "[cracks]") {
    model::Scene scene = block_scene(true);
    scene.notches.push_back(notch({0.02, 0.03}, {0.17, 0.08}));
    const observe::Simulation sim(scene, 1);
    const observe::Snapshot seen = sim.snapshot();
    const packing::Cells cells =
        packing::cells_of(seen.position, sim.field("radius", {}), model::Region::rectangle({0.0, 0.0}, size));
    std::map<std::pair<std::int32_t, std::int32_t>, packing::Facet> facets;
    for (const packing::Facet& facet : cells.facets) facets[{facet.i, facet.j}] = facet;
    const auto i = crack_field<std::int32_t>(seen, "i");
    const auto j = crack_field<std::int32_t>(seen, "j");
    REQUIRE(seen.crack_ends.size() > 10);
    double length = 0.0;
    for (std::size_t k = 0; k < seen.crack_ends.size(); ++k) {
        const packing::Facet& facet = facets.at({i[k], j[k]});
        CHECK(norm(seen.crack_ends[k][0] - facet.from) < 1e-9 * size.x);
        CHECK(norm(seen.crack_ends[k][1] - facet.to) < 1e-9 * size.x);
        length += norm(facet.to - facet.from);
    }
    CHECK(sim.crack_length() == Approx(length).epsilon(1e-9));
}

TEST_CASE("two cracks have two numbers, those of their earliest breaks, until they join", "[cracks]") {
    const bool facets = GENERATE(false, true);
    const double y = facets ? 0.05 : between_rows;
    model::Scene scene = block_scene(facets);
    scene.notches.push_back(notch({0.13, y}, {0.17, y}));
    scene.notches.push_back(notch({0.03, y}, {0.07, y}));
    observe::Simulation sim(scene, 1);
    const std::vector<std::int32_t> apart = observe::crack_clusters(sim.state());
    CHECK(cluster_count(sim) == 2);
    CHECK(apart.front() == 0);
    for (std::size_t k = 0; k < apart.size(); ++k) {
        const bool right = middle_of(sim.state().cracks[k].ends).x > 0.1;
        const auto first_left = static_cast<std::int32_t>(std::count(apart.begin(), apart.end(), 0));
        CHECK(apart[k] == (right ? 0 : first_left));
    }
    // A straight cut crosses neighbouring bonds one after the other, so nothing is left between.
    scene.notches.push_back(notch({0.07, y}, {0.13, y}));
    sim.take_in(scene);
    CHECK(sim.state().cracks.size() > apart.size());
    CHECK(cluster_count(sim) == 1);
    CHECK(observe::crack_clusters(sim.state()).front() == 0);
}

TEST_CASE("a bond pulled apart breaks in tension, where its elements are, and for G_f 2Rt", "[cracks]") {
    observe::Simulation sim(led_pair({1e-3, 0.0}), 1);
    const observe::Snapshot seen = at_breaking(sim, 25e-3);
    REQUIRE(seen.crack_ends.size() == 1);
    CHECK(crack_field<std::int32_t>(seen, "mode")[0] == 0);
    CHECK(crack_field<double>(seen, "time")[0] == seen.time);
    CHECK(crack_field<double>(seen, "step")[0] == static_cast<double>(seen.step));
    const Vec2 between = 0.5 * (seen.position[0] + seen.position[1]);
    CHECK(norm(middle_of(seen.crack_ends[0]) - between) < 1e-15);
    CHECK(between.x > R); // displaced, by half of d_max
    // K_Ic^2/E* = 33.670 J/m^2; the last step opens the bond past d_max by at most a step of motion.
    CHECK(crack_field<double>(seen, "energy")[0] == Approx(33.670 * 2.0 * R).epsilon(1e-4));
    CHECK(sim.surface_energy() == crack_field<double>(seen, "energy")[0]);

    sim.run(1e-3, {});
    CHECK(sim.snapshot().crack_ends == seen.crack_ends);
}

TEST_CASE("a bond that only slides breaks in shear", "[cracks]") {
    observe::Simulation sim(led_pair({0.0, 2e-2}), 1);
    const observe::Snapshot seen = at_breaking(sim, 25e-3);
    REQUIRE(seen.crack_ends.size() == 1);
    CHECK(crack_field<std::int32_t>(seen, "mode")[0] == 1);
    const observe::Ledger energy = sim.ledger();
    CHECK(sim.surface_energy() == Approx(energy.plastic + energy.fracture).epsilon(1e-12));
}

TEST_CASE("the energies of broken bonds add up to the ledger's, the same for any number of threads", "[cracks]") {
    const model::Network network = GENERATE(model::Network::contacts, model::Network::facets);
    const model::BondSettings settings{0.1, 0.02, network};
    const model::BondChoice bonds = GENERATE_COPY(model::BondChoice(model::PlateauBonds{settings, true}),
                                                  model::BondChoice(model::SofteningBonds{settings}),
                                                  model::BondChoice(model::BrittleTensileBonds{settings}));
    std::string reference;
    for (const int threads : {1, 2, 3}) {
        observe::Simulation sim(torn_strip(bonds), {threads, 1});
        REQUIRE(sim.bond_count() >= 1024); // shorter loops are not shared
        sim.run(4e-4, {});
        CHECK(sim.state().cracks.size() == sim.broken_bonds());
        CHECK(sim.broken_bonds() > 20);
        CHECK(sim.surface_energy() > 0.0);
        CHECK(sim.surface_energy() == Approx(spent_by_broken(sim.state())).epsilon(1e-12));
        CHECK(sim.ledger().fracture + sim.ledger().plastic >= sim.surface_energy());
        double length = 0.0;
        double before = 0.0;
        for (const state::Crack& crack : sim.state().cracks) {
            length += norm(crack.ends[1] - crack.ends[0]);
            CHECK(crack.time >= before);
            before = crack.time;
        }
        CHECK(length == Approx(sim.crack_length()).epsilon(1e-12));
        const std::string written = output::cracks_vtu(sim.snapshot());
        if (threads == 1) reference = written;
        CHECK(written == reference);
    }
}

TEST_CASE("bonds that cannot break leave no record", "[cracks]") {
    model::Scene scene = block_scene(false);
    scene.bodies[0].bonds = model::ElasticBonds{};
    const observe::Simulation sim(scene, 1);
    CHECK(sim.snapshot().crack_fields.empty());
    for (const auto& [name, value] : sim.history_row()) CHECK(name != "surface_energy");
}
