// A small beam shot to pieces: what must hold however much breaks.
#include "engine/observe/ledger.hpp"
#include "engine/packing/packing.hpp"
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

using namespace demlua;
using Catch::Approx;

namespace {

/// A free concrete beam of consolidated clusters and a steel block that falls on it at 60 m/s.
model::Scene shot_beam(bool rigid, bool break_in_shear, model::Network network) {
    model::Material material = test::concrete();
    material.poissons_ratio = 0.2;
    material.contact_damping = 0.2;
    model::Material steel;
    steel.name = "steel";
    steel.youngs_modulus = 200e9;
    steel.poissons_ratio = 0.3;
    steel.density = 7850.0;
    steel.friction = 0.5;
    steel.contact_damping = 0.2;
    model::Scene scene = test::scene_of(material);
    scene.materials.push_back(steel);

    model::Body beam;
    beam.name = "beam";
    beam.region = model::Region::rectangle({0.0, 0.0}, {0.6, 0.2});
    model::Consolidation pack;
    pack.count = 1500;
    beam.packing = pack;
    beam.bonds = model::PlateauBonds{{0.1, 0.02, network}, break_in_shear};
    scene.bodies.push_back(beam);

    const double R = packing::consolidated_radius(beam.region, pack);
    model::Body shot = test::block("shot", {0.26, 0.2 + 0.1 * R}, {0.08, 0.1}, R, model::ElasticBonds{{0.1, 0.02}});
    shot.material = 1;
    shot.velocity = {3.0, -60.0};
    shot.rigid = rigid;
    scene.bodies.push_back(shot);
    return scene;
}

/// Pairs that overlap and are not held by a bond, by comparing every element with every other.
std::set<std::pair<Index, Index>> overlapping_pairs(const state::State& state) {
    std::set<std::pair<Index, Index>> bonded;
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                // A broken bond keeps its own reference length: it is the subject of another test.
                for (std::size_t k = 0; k < bonds.size(); ++k) bonded.emplace(bonds.i[k], bonds.j[k]);
            },
            any);
    }
    std::set<std::pair<Index, Index>> pairs;
    const state::Elements& elements = state.elements;
    for (Index i = 0; i < elements.size(); ++i) {
        for (Index j = i + 1; j < elements.size(); ++j) {
            const double touch = elements.radius[i] + elements.radius[j];
            if (norm(elements.position(j) - elements.position(i)) < touch && !bonded.contains({i, j})) {
                pairs.emplace(i, j);
            }
        }
    }
    return pairs;
}

} // namespace

TEST_CASE("a beam in pieces keeps its momentum to round-off and its energy in the ledger") {
    const bool rigid = GENERATE(false, true);
    const bool break_in_shear = GENERATE(false, true);
    const model::Network network = GENERATE(model::Network::contacts, model::Network::facets);
    observe::Simulation sim(shot_beam(rigid, break_in_shear, network), 1);
    observe::Momentum first;
    double energy = 0.0;
    sim.run(1.5e-3, {test::watching(1.5e-4, [&](observe::Simulation& now) {
                const observe::Momentum total = now.momentum();
                if (now.step() == 0) {
                    first = total;
                    energy = now.ledger().kinetic;
                }
                CHECK(norm(total.linear - first.linear) < 1e-10 * norm(first.linear));
                // About the origin, so that the measure is the size of what cancels.
                CHECK(std::fabs(total.angular - first.angular) < 1e-10 * norm(first.linear) * 0.6);
                CHECK(std::fabs(now.ledger().error) < 0.01 * energy);
            })});
    CHECK(sim.broken_bonds() > 200);
    CHECK(sim.fragments() > 20);
    const observe::Ledger spent = sim.ledger();
    CHECK(spent.friction > 0.0);
    CHECK(spent.contact_damping > 0.0);
    CHECK(spent.plastic > 0.0);
}

TEST_CASE("the final state is the same to the last bit for any number of threads") {
    const bool rigid = GENERATE(false, true);
    const model::Network network = GENERATE(model::Network::contacts, model::Network::facets);
    std::uint64_t reference = 0;
    for (const int threads : {1, 2, 3}) {
        observe::Simulation sim(shot_beam(rigid, true, network), {threads, 1});
        sim.run(4e-4, {});
        CHECK(sim.broken_bonds() > 50);
        if (threads == 1) reference = sim.hash();
        CHECK(sim.hash() == reference);
    }
}

TEST_CASE("what watches a run does not change it") {
    observe::Simulation quiet(shot_beam(false, true, model::Network::facets), 1);
    quiet.run(1e-4, {});
    observe::Simulation watched(shot_beam(false, true, model::Network::facets), 1);
    watched.run(1e-4, {test::watching(0.0, [](observe::Simulation& now) {
                    if (now.step() % 7 == 0) (void)now.snapshot();
                })});
    CHECK(watched.hash() == quiet.hash());
}

TEST_CASE("no overlapping pair is ever missing from the contact list") {
    const model::Network network = GENERATE(model::Network::contacts, model::Network::facets);
    observe::Simulation sim(shot_beam(false, true, network), 1);
    std::size_t seen = 0;
    sim.run(1.2e-3, {test::watching(0.0, [&](observe::Simulation& now) {
                if (now.step() % 97 != 0) return;
                const state::Contacts& contacts = now.state().contacts;
                std::set<std::pair<Index, Index>> listed;
                for (std::size_t c = 0; c < contacts.size(); ++c) listed.emplace(contacts.i[c], contacts.j[c]);
                const auto pairs = overlapping_pairs(now.state());
                seen = std::max(seen, pairs.size());
                CHECK(std::includes(listed.begin(), listed.end(), pairs.begin(), pairs.end()));
            })});
    // Across facets every neighbour held a bond, so fewer strangers meet.
    CHECK(seen >= (network == model::Network::contacts ? 10U : 5U));
}

TEST_CASE("a bond that breaks leaves a contact without a jump in force or energy") {
    // Two elements bonded across a gap, pressed together, then cut by shear: the contact must hold the same pressure
    // from the bond's unstressed length, and not push the elements back to the sum of their radii.
    constexpr double R = 5e-3;
    model::Scene scene = test::scene_of(test::concrete());
    scene.step_fraction = 0.1;
    scene.bodies.push_back(
        test::disks("pair", {{{0.0, 0.0}, R}, {{1.96 * R, 0.0}, R}}, model::PlateauBonds{{0.1, 0.0}, true}));
    model::Support held;
    held.selection = test::all_of(0);
    held.selection.where = [](Vec2 at) { return at.x < R; };
    scene.supports.push_back(held);
    model::Motion sheared;
    sheared.selection = test::all_of(0);
    sheared.selection.where = [](Vec2 at) { return at.x > R; };
    sheared.displacement_x = Signal{{0.0, 1e-3}, {0.0, -20e-6}};
    sheared.displacement_y = Signal{{0.0, 1e-3, 2e-2}, {0.0, 0.0, 4e-4}};
    sheared.spin = Signal::constant(0.0);
    scene.motions.push_back(sheared);
    observe::Simulation sim(scene, 1);
    double before = 0.0;
    double largest_jump = 0.0;
    sim.run(2e-2, {test::watching(0.0, [&](observe::Simulation& now) {
                const state::State& state = now.state();
                const auto& bonds = std::get<state::BondSet<law::Plateau>>(state.bond_sets[0]);
                const double pressure = now.broken_bonds() == 0
                                            ? -bonds.forces.at(0).f.x
                                            : (state.contacts.size() > 0 ? -state.contacts.forces.at(0).f.x : 0.0);
                if (now.step() > 0) largest_jump = std::max(largest_jump, std::fabs(pressure - before));
                before = pressure;
            })});
    REQUIRE(sim.broken_bonds() == 1);
    const double K = std::get<state::BondSet<law::Plateau>>(sim.state().bond_sets[0]).params.Kn;
    CHECK(largest_jump < 0.05 * K * 1e-6);
    CHECK(sim.state().contacts.reference[0] == Approx(1.96 * R).epsilon(1e-12));
    const observe::Ledger energy = sim.ledger();
    CHECK(std::fabs(energy.error) < 1e-3 * energy.work);
}
