#include "engine/state/cluster_assembly.hpp"

#include "engine/packing/disk_union.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

namespace demlua::state {

namespace {

/// Mass, middle and inertia of some elements together.
RigidBody as_one(const State& state, std::span<const Index> rows) {
    const Elements& elements = state.elements;
    RigidBody rigid;
    for (const Index k : rows) {
        rigid.mass += elements.mass(k);
        rigid.centre += elements.mass(k) * elements.position(k);
    }
    rigid.centre = rigid.centre / rigid.mass;
    for (const Index k : rows) {
        const Vec2 arm = elements.position(k) - rigid.centre;
        rigid.inertia += elements.mass(k) * dot(arm, arm) + elements.inertia(k);
    }
    return rigid;
}

/// Rows of one body.
Column<Index> rows_of(const Body& body) {
    Column<Index> rows(body.size());
    std::iota(rows.begin(), rows.end(), static_cast<Index>(body.first));
    return rows;
}

/// Calls `work(rows)` for each cluster of a body, with the rows of its elements.
template <class Work>
void for_each_cluster(const State& state, const Body& body, const Work& work) {
    const Column<Index>& cluster = state.elements.cluster;
    Column<Index> rows = rows_of(body);
    std::stable_sort(rows.begin(), rows.end(), [&](Index a, Index b) { return cluster[a] < cluster[b]; });
    for (auto begin = rows.begin(); begin != rows.end();) {
        const auto end = std::find_if(begin, rows.end(), [&](Index k) { return cluster[k] != cluster[*begin]; });
        work(std::span<const Index>(begin, end));
        begin = end;
    }
}

/// Makes the elements in `rows` a rigid body moving as they do.
void join_rigidly(State& state, std::span<const Index> rows, const RigidBody& whole) {
    const Elements& elements = state.elements;
    RigidBody rigid = whole;
    rigid.first = state.rigid_members.size();
    for (const Index k : rows) {
        state.rigid_members.push_back(k);
        state.rigid_row[k] = static_cast<Index>(state.rigid_bodies.size());
        rigid.velocity += (elements.mass(k) / rigid.mass) * elements.velocity(k);
    }
    rigid.last = state.rigid_members.size();
    rigid.spin = elements.spin[rows.front()];
    state.rigid_bodies.push_back(rigid);
}

/// A cluster as one: the union of its disks, at the density of the material.
RigidBody rigid_cluster(const State& state, std::span<const Index> rows) {
    const Elements& elements = state.elements;
    RigidBody whole = as_one(state, rows);
    std::vector<model::Disk> disks;
    for (const Index k : rows) disks.push_back({elements.position(k), elements.radius[k]});
    const packing::Lamina lamina = packing::union_of(disks);
    whole.centre = lamina.centroid;
    whole.inertia = whole.mass / lamina.area * lamina.polar;
    return whole;
}

} // namespace

void bring_clusters_together(const Body& body, State& state) {
    if (!state.period.repeats() || !body.in_clusters) return;
    Elements& elements = state.elements;
    for_each_cluster(state, body, [&](std::span<const Index> members) {
        const Vec2 first = elements.position(members.front());
        for (const Index k : members) {
            const Vec2 apart = elements.position(k) - first;
            if (std::fabs(apart.x) <= 0.5 * state.period.length) continue;
            elements.reference_x[k] = first.x + state.period.shortest(apart).x;
        }
    });
}

void set_moving(const model::Body& said, std::size_t row, State& state) {
    const Column<Index> rows = rows_of(state.bodies[row]);
    const Vec2 centre = as_one(state, rows).centre;
    Elements& elements = state.elements;
    for (const Index k : rows) {
        const Vec2 v = said.velocity + said.spin * turned_left(elements.position(k) - centre);
        elements.vx[k] = v.x;
        elements.vy[k] = v.y;
        elements.spin[k] = said.spin;
    }
}

void make_rigid(const model::Body& said, std::size_t row, State& state) {
    state.bodies[row].rigid = true;
    state.rigid_row.resize(state.elements.size(), State::no_rigid);
    if (!said.in_clusters) {
        const Column<Index> rows = rows_of(state.bodies[row]);
        join_rigidly(state, rows, as_one(state, rows));
        state.rigid_bodies.back().velocity = said.velocity;
        return;
    }
    for_each_cluster(state, state.bodies[row], [&](std::span<const Index> members) {
        if (members.size() == 1) {
            state.single.push_back(members.front());
        } else {
            join_rigidly(state, members, rigid_cluster(state, members));
        }
    });
    std::sort(state.single.begin(), state.single.end());
}

void lay_out_wear(const model::Scene& scene, State& state) {
    const Elements& elements = state.elements;
    const bool wears = std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const model::Body& body) {
        return body.in_clusters && scene.materials[body.material].wear_energy_density;
    });
    if (!wears) return;
    const Index clusters = *std::max_element(elements.cluster.begin(), elements.cluster.end()) + 1;
    std::vector<std::size_t> members(clusters);
    for (const Index cluster : elements.cluster) ++members[cluster];
    Wear& wear = state.wear;
    wear.next_cluster = clusters;
    wear.past.resize(elements.size());
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const model::Body& body = scene.bodies[elements.body[k]];
        const std::optional<double>& W0 = scene.materials[body.material].wear_energy_density;
        const bool can_leave = body.in_clusters && W0 && members[elements.cluster[k]] > 1;
        wear.limit.push_back(can_leave ? *W0 * elements.cell_area[k] * state.thickness
                                       : std::numeric_limits<double>::infinity());
    }
}

std::size_t cluster_count(const State& state, const Body& body) {
    const auto begin = state.elements.cluster.begin();
    std::vector<Index> numbers(begin + static_cast<std::ptrdiff_t>(body.first),
                               begin + static_cast<std::ptrdiff_t>(body.last));
    std::sort(numbers.begin(), numbers.end());
    return static_cast<std::size_t>(std::unique(numbers.begin(), numbers.end()) - numbers.begin());
}

} // namespace demlua::state
