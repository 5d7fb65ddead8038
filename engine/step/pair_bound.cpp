#include "engine/step/pair_bound.hpp"

#include "engine/base/cell_grid.hpp"

#include "engine/law/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <type_traits>
#include <variant>

namespace demlua::step {

namespace {

/// D_i of the bonds of one element, stiffness and damping.
struct Block {
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d damping = Eigen::Matrix3d::Zero();
};

std::vector<Block> blocks_of(const Springs& springs) {
    std::vector<Block> blocks(static_cast<std::size_t>(springs.freedoms() / 3));
    for (std::size_t spring = 0; spring < springs.size(); ++spring) {
        const auto ends = springs.ends(spring);
        const auto sharing = static_cast<double>(ends.size());
        for (const SpringEnd& end : ends) {
            const Eigen::Vector3d b{end.x, end.y, end.turn};
            const Eigen::Matrix3d square = sharing * b * b.transpose();
            Block& block = blocks[static_cast<std::size_t>(springs.row(end.element) / 3)];
            block.stiffness += springs.stiffness(spring) * square;
            block.damping += springs.damping(spring) * square;
        }
    }
    return blocks;
}

double largest_eigenvalue(const Eigen::Matrix3d& block) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(block, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

double step_of(Block block, const Felt& contacts) {
    block.stiffness.diagonal() += contacts.stiffness;
    block.damping.diagonal() += contacts.damping;
    return law::stable_step(largest_eigenvalue(block.stiffness), largest_eigenvalue(block.damping));
}

/// Of each element of a rigid body, the elements of the same body beside it.
void count_rigid_neighbours(const state::State& state, std::vector<std::size_t>& neighbours) {
    if (state.rigid_members.empty()) return;
    constexpr double near = 1.05; // of touching
    const state::Elements& elements = state.elements;
    std::vector<Vec2> points;
    double largest = 0.0;
    for (const Index k : state.rigid_members) {
        points.push_back(elements.position(k));
        largest = std::max(largest, elements.radius[k]);
    }
    CellGrid grid;
    grid.build(points, 2.0 * near * largest);
    grid.for_each_pair(2.0 * near * largest, [&](Index a, Index b) {
        const Index i = state.rigid_members[a];
        const Index j = state.rigid_members[b];
        const double touch = elements.radius[i] + elements.radius[j];
        if (state.rigid_row[i] != state.rigid_row[j] || norm(points[a] - points[b]) > near * touch) return;
        ++neighbours[i];
        ++neighbours[j];
    });
}

std::vector<double> heaviest_of_bodies(const state::State& state) {
    std::vector<double> heaviest(state.bodies.size());
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        double& mass = heaviest[state.elements.body[k]];
        mass = std::max(mass, state.pushed_mass(k));
    }
    return heaviest;
}

} // namespace

Facts facts_of(const state::State& state) {
    Facts facts;
    const Column<double>& radius = state.elements.radius;
    facts.smallest_radius = *std::min_element(radius.begin(), radius.end());
    facts.has_company = state.bodies.size() > 1 || !state.walls.empty();
    facts.neighbours.resize(state.elements.size());
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                for (std::size_t k = 0; k < bonds.size(); ++k) {
                    if (bonds.is_broken(k)) continue;
                    ++facts.neighbours[bonds.i[k]];
                    ++facts.neighbours[bonds.j[k]];
                }
            },
            any);
    }
    count_rigid_neighbours(state, facts.neighbours);
    return facts;
}

bool can_loosen(const state::State& state, std::size_t body) {
    bool bonded = false;
    bool breaks = false;
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                if (bonds.body != body) return;
                bonded = true;
                breaks = breaks || std::decay_t<decltype(bonds)>::law::breaks;
            },
            any);
    }
    return breaks || !bonded || state.bodies[body].in_clusters;
}

Felt beside_bonds(const state::State& state, const Facts& facts, std::size_t k, bool loosens) {
    if (!facts.has_company) return {};
    const double room = room_around(state.elements.radius[k], facts.smallest_radius);
    const double free = std::max(room - static_cast<double>(facts.neighbours[k]), 0.0);
    return hardest_contacts(state, k, free, loosens);
}

Tightest bound_of(const state::State& state, const Facts& facts, std::size_t body, const Springs& springs) {
    const bool loosens = can_loosen(state, body);
    Tightest tightest;
    const std::vector<Block> blocks = blocks_of(springs);
    const std::size_t first = state.bodies[body].first;
    for (std::size_t k = first; k < state.bodies[body].last; ++k) {
        tightest.offer(step_of(blocks[k - first], beside_bonds(state, facts, k, loosens)), k,
                       facts.has_company ? "its bonds and contacts" : "its bonds");
        if (!loosens || state.bodies[body].size() == 1) continue;
        const double room = room_around(state.elements.radius[k], facts.smallest_radius);
        tightest.offer(step_of({}, hardest_contacts(state, k, room, true)), k,
                       "contacts all round once its bonds are gone");
    }
    return tightest;
}

Tightest bound_of_rigid(const state::State& state, const Facts& facts) {
    Tightest tightest;
    if (state.rigid_row.empty()) return tightest;
    const std::vector<double> heaviest = heaviest_of_bodies(state);
    for (const state::RigidBody& rigid : state.rigid_bodies) {
        if (rigid.empty()) continue;
        double stiffness = 0.0;
        double damping = 0.0;
        for (const Index k : state.members(rigid)) {
            const double room = room_around(state.elements.radius[k], facts.smallest_radius);
            const double free = std::max(room - static_cast<double>(facts.neighbours[k]), 0.0);
            const RigidlyFelt felt = hardest_contacts_on(state, rigid, k, free, heaviest);
            stiffness += felt.stiffness;
            damping += felt.damping;
        }
        tightest.offer(law::stable_step(stiffness, damping), state.members(rigid).front(),
                       "contacts of its rigid body");
    }
    for (const Index k : state.single) {
        const double room = room_around(state.elements.radius[k], facts.smallest_radius);
        tightest.offer(step_of({}, hardest_contacts(state, k, room, true)), k, "contacts all round");
    }
    return tightest;
}

double bound_of_bonds(const Springs& springs) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Block& block : blocks_of(springs)) shortest = std::min(shortest, step_of(block, {}));
    return shortest;
}

} // namespace demlua::step
