// The search misses nothing: against all pairs, at every step, while a body goes to pieces and its debris flies.
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/scenes.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <variant>

using namespace demlua;

namespace {

std::uint64_t key(std::size_t i, std::size_t j) {
    return (static_cast<std::uint64_t>(std::min(i, j)) << 32U) | std::max(i, j);
}

/// A brittle block and a fast disk that goes through it.
model::Scene burst_block() {
    model::Material glass = test::concrete();
    glass.tensile_strength = 1e6;
    glass.contact_damping = 0.1;
    model::Scene scene = test::scene_of(glass);
    scene.bodies.push_back(test::block("block", {0.0, 0.0}, {0.1, 0.08}, 3e-3, model::BrittleTensileBonds{}));
    scene.bodies.push_back(test::disks("shot", {{{0.05, 0.1}, 6e-3}}, model::NoBonds{}));
    scene.bodies[1].velocity = {10.0, -250.0};
    return scene;
}

/// Distance at which elements whose bond is broken touch, and pairs that a bond still holds.
struct Bonded {
    std::unordered_map<std::uint64_t, double> reference;
    std::unordered_set<std::uint64_t> held;
};

Bonded bonded_pairs(const state::State& state) {
    Bonded pairs;
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                for (std::size_t k = 0; k < bonds.size(); ++k) {
                    const std::uint64_t pair = key(bonds.i[k], bonds.j[k]);
                    if (!bonds.is_broken(k)) {
                        pairs.held.insert(pair);
                    } else {
                        pairs.reference[pair] = bonds.contact_length[k];
                    }
                }
            },
            any);
    }
    return pairs;
}

/// Pairs that press on each other and are not on the list.
std::size_t missed(const state::State& state) {
    std::unordered_set<std::uint64_t> listed;
    for (std::size_t c = 0; c < state.contacts.size(); ++c)
        listed.insert(key(state.contacts.i[c], state.contacts.j[c]));
    const Bonded bonded = bonded_pairs(state);
    const state::Elements& elements = state.elements;
    std::size_t count = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        for (std::size_t j = i + 1; j < elements.size(); ++j) {
            const Vec2 span = elements.position(j) - elements.position(i);
            const double touch = elements.radius[i] + elements.radius[j];
            if (dot(span, span) >= 1.5 * touch * touch) continue;
            const auto broken = bonded.reference.find(key(i, j));
            const double reference = broken == bonded.reference.end() ? touch : broken->second;
            if (norm(span) >= reference || bonded.held.contains(key(i, j))) continue;
            if (!listed.contains(key(i, j))) ++count;
        }
    }
    return count;
}

} // namespace

TEST_CASE("no contact is ever missed while a block bursts", "[search]") {
    observe::Simulation sim(burst_block(), 1);
    std::size_t in_all = 0;
    std::size_t steps = 0;
    sim.run(4e-4, {test::watching(0.0, [&](observe::Simulation& now) {
                in_all += missed(now.state());
                ++steps;
            })});
    CHECK(in_all == 0);
    CHECK(steps > 300);
    CHECK(sim.broken_bonds() > sim.bond_count() / 4);
    CHECK(sim.fragments() > 20);
}
