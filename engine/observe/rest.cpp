#include "engine/observe/rest.hpp"

#include "engine/observe/ledger.hpp"

#include <cstddef>
#include <vector>

namespace demlua::observe {

namespace {

struct Mean {
    double sum = 0.0;
    std::size_t count = 0;

    void add(double value) {
        sum += value;
        ++count;
    }
    [[nodiscard]] double value() const { return count == 0 ? 0.0 : sum / static_cast<double>(count); }
};

double force_in_pairs(const state::State& state) {
    Mean mean;
    const auto add = [&](Vec2 f) {
        if (f != Vec2{}) mean.add(norm(f));
    };
    const auto add_pairs = [&](const auto& pairs) {
        for (std::size_t k = 0; k < pairs.size(); ++k) add(pairs.forces.at(k).f);
    };
    add_pairs(state.contacts);
    for (const state::AnyBondSet& any : state.bond_sets) std::visit(add_pairs, any);
    for (std::size_t c = 0; c < state.wall_contacts.size(); ++c) {
        add({state.wall_contacts.fx[c], state.wall_contacts.fy[c]});
    }
    for (const state::OutlineContact& row : state.outline_contacts.rows) {
        if (row.overlap > 0.0) mean.add(row.rule.Kn * row.overlap);
    }
    return mean.value();
}

std::vector<bool> held_elements(const state::State& state) {
    std::vector<bool> held(state.elements.size());
    for (const state::Drive& drive : state.drives) {
        for (const Index k : drive.element) held[k] = true;
    }
    return held;
}

double force_left(const state::State& state) {
    const std::vector<bool> held = held_elements(state);
    Mean mean;
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        if (!held[k] && !state.rigid_of(k) && !state.is_gone(k)) mean.add(norm(state.elements.force(k)));
    }
    for (const state::RigidBody& rigid : state.rigid_bodies) {
        if (!rigid.empty()) mean.add(norm(rigid.force));
    }
    for (const state::Wall& wall : state.walls) {
        if (!wall.moves_freely()) continue;
        const Vec2 force = wall.force + wall.weight(state.gravity);
        mean.add(norm(Vec2{wall.free_x() ? force.x : 0.0, wall.free_y() ? force.y : 0.0}));
    }
    return mean.value();
}

} // namespace

bool at_rest(const state::State& state, double share) {
    const Ledger energy = ledger_of(state);
    if (energy.kinetic > share * (energy.bonds + energy.contacts)) return false;
    return force_left(state) <= share * force_in_pairs(state);
}

} // namespace demlua::observe
