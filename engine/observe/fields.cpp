#include "engine/observe/fields.hpp"

#include "engine/observe/bond_reading.hpp"
#include "engine/observe/cracks.hpp"
#include "engine/observe/ledger.hpp"
#include "engine/observe/stress.hpp"
#include "engine/state/parts.hpp"
#include "engine/step/wear.hpp"

#include <algorithm>

namespace demlua::observe {

namespace {

bool always(const state::State& /*state*/) { return true; }

bool wears(const state::State& state) { return state.wear.present(); }

FieldValues wear_works(const state::State& state) {
    Team alone(1);
    const Column<double> work = step::sliding_work(state, alone);
    return std::vector<double>(work.begin(), work.end());
}

bool has_clusters(const state::State& state) {
    const Column<Index>& cluster = state.elements.cluster;
    return std::adjacent_find(cluster.begin(), cluster.end()) != cluster.end();
}

template <class Of>
std::vector<double> each(const state::State& state, const Of& of) {
    std::vector<double> values(state.elements.size());
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = of(k);
    return values;
}

template <class Of>
std::vector<double> each_vector(const state::State& state, const Of& of) {
    std::vector<double> values;
    values.reserve(2 * state.elements.size());
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        const Vec2 v = of(k);
        values.push_back(v.x);
        values.push_back(v.y);
    }
    return values;
}

std::vector<std::int32_t> whole(const Column<Index>& column) { return {column.begin(), column.end()}; }

FieldValues ids(const state::State& state) {
    std::vector<std::int32_t> id(state.elements.size());
    for (std::size_t k = 0; k < id.size(); ++k) id[k] = static_cast<std::int32_t>(k);
    return id;
}
FieldValues radii(const state::State& state) {
    return each(state, [&](std::size_t k) { return state.elements.radius[k]; });
}
FieldValues bodies(const state::State& state) { return whole(state.elements.body); }
FieldValues clusters(const state::State& state) { return whole(state.elements.cluster); }
FieldValues fragments(const state::State& state) { return state::part_of_elements(state); }
FieldValues displacements(const state::State& state) {
    return each_vector(state, [&](std::size_t k) { return state.elements.displacement(k); });
}
FieldValues rotations(const state::State& state) {
    return each(state, [&](std::size_t k) { return state.elements.rotation[k]; });
}
FieldValues velocities(const state::State& state) {
    return each_vector(state, [&](std::size_t k) { return velocity_now(state, k); });
}
FieldValues speeds(const state::State& state) {
    return each(state, [&](std::size_t k) { return norm(velocity_now(state, k)); });
}
FieldValues spins(const state::State& state) {
    return each(state, [&](std::size_t k) { return spin_now(state, k); });
}
FieldValues forces(const state::State& state) {
    return each_vector(state, [&](std::size_t k) { return state.elements.force(k); });
}
FieldValues stresses(const state::State& state) { return stress_of_elements(state); }
FieldValues kinetic_energies(const state::State& state) {
    return each(state, [&](std::size_t k) {
        const Vec2 v = velocity_now(state, k);
        const double spin = spin_now(state, k);
        return 0.5 * (state.elements.mass(k) * dot(v, v) + state.elements.inertia(k) * spin * spin);
    });
}

/// Bonds that hold and contacts that press.
FieldValues coordinations(const state::State& state) {
    std::vector<std::int32_t> count(state.elements.size());
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                for (std::size_t k = 0; k < bonds.size(); ++k) {
                    if (bonds.is_broken(k)) continue;
                    ++count[bonds.i[k]];
                    ++count[bonds.j[k]];
                }
            },
            any);
    }
    for (std::size_t c = 0; c < state.contacts.size(); ++c) {
        if (state.overlap(c) <= 0.0) continue;
        ++count[state.contacts.i[c]];
        ++count[state.contacts.j[c]];
    }
    for (std::size_t c = 0; c < state.wall_contacts.size(); ++c) {
        if (state.wall_contacts.overlap[c] > 0.0) ++count[state.wall_contacts.element[c]];
    }
    return count;
}

/// Mean damage of the bonds an element started with.
FieldValues damages(const state::State& state) {
    std::vector<double> sum(state.elements.size());
    std::vector<double> count(state.elements.size());
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                for (std::size_t k = 0; k < bonds.size(); ++k) {
                    for (const Index element : {bonds.i[k], bonds.j[k]}) {
                        sum[element] += bond_damage(bonds, k);
                        count[element] += 1.0;
                    }
                }
            },
            any);
    }
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] /= std::max(count[k], 1.0);
    return sum;
}

/// Columns of the bond series while they are being filled.
struct BondColumns {
    std::vector<std::int32_t> state;
    std::vector<double> normal, shear, stretch, damage, break_time;
};

template <class Bonds>
void add_bond(const state::State& state, const Bonds& bonds, std::size_t k, BondColumns& columns) {
    const BondReading bond = read_bond(bonds, state.elements, k);
    columns.state.push_back(bond.state);
    columns.normal.push_back(bond.force.normal);
    columns.shear.push_back(bond.force.shear);
    columns.stretch.push_back(bond.stretch);
    columns.damage.push_back(bond.damage);
    double when = -1.0;
    if constexpr (Bonds::law::breaks) when = bonds.is_broken(k) ? bonds.break_time[k] : -1.0;
    columns.break_time.push_back(when);
}

} // namespace

const std::vector<ElementField>& element_fields() {
    using enum Combine;
    static const std::vector<ElementField> rows{
        {"id", "", 1, mean, "number of the element", always, ids},
        {"radius", "m", 1, mean, "radius of the disk", always, radii},
        {"body", "", 1, mean, "number of the body", always, bodies},
        {"cluster", "", 1, mean, "number of the cluster it was packed in", has_clusters, clusters},
        {"fragment", "", 1, mean, "number of the part it is bonded into", can_break, fragments},
        {"displacement", "m", 2, mean, "from where it stood at the start", always, displacements},
        {"rotation", "rad", 1, mean, "since the start, counter-clockwise", always, rotations},
        {"velocity", "m/s", 2, mean, "of the centre", always, velocities},
        {"speed", "m/s", 1, mean, "of the centre", always, speeds},
        {"spin", "rad/s", 1, mean, "counter-clockwise", always, spins},
        {"force", "N", 2, sum, "resultant", always, forces},
        {"stress", "Pa", 3, mean, "mean over the element's cell, tension positive", always, stresses},
        {"kinetic_energy", "J", 1, sum, "of translation and rotation", always, kinetic_energies},
        {"coordination", "", 1, mean, "bonds that hold and contacts that press", always, coordinations},
        {"wear", "J", 1, sum, "sliding work against other clusters and walls", wears, wear_works},
        {"damage", "", 1, mean, "mean damage of its bonds, 1 when all are broken", can_break, damages},
    };
    return rows;
}

std::vector<std::string> component_names(const ElementField& field) {
    const std::string name = field.name;
    if (field.components == 2) return {name + "_x", name + "_y"};
    if (field.components == 3) return {name + "_xx", name + "_yy", name + "_xy"};
    return {name};
}

void add_bonds_to(Snapshot& snapshot, const state::State& state) {
    BondColumns columns;
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                for (std::size_t k = 0; k < bonds.size(); ++k) {
                    snapshot.bond_ends.push_back({bonds.i[k], bonds.j[k]});
                    add_bond(state, bonds, k, columns);
                }
            },
            any);
    }
    if (snapshot.bond_ends.empty()) return;
    snapshot.bond_fields.push_back({"force", "N", 1, std::move(columns.normal)});
    snapshot.bond_fields.push_back({"shear_force", "N", 1, std::move(columns.shear)});
    snapshot.bond_fields.push_back({"stretch", "m", 1, std::move(columns.stretch)});
    if (!can_break(state)) return;
    snapshot.bond_fields.push_back({"state", "", 1, std::move(columns.state)});
    snapshot.bond_fields.push_back({"damage", "", 1, std::move(columns.damage)});
    snapshot.bond_fields.push_back({"break_time", "s", 1, std::move(columns.break_time)});
}

} // namespace demlua::observe
