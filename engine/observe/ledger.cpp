#include "engine/observe/ledger.hpp"

#include "engine/step/facet_forces.hpp"
#include "engine/step/motion.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace demlua::observe {

namespace {

/// m v- v+ / 2 in one degree of freedom, and what mass damping took in the half step before the instant.
struct Motion {
    double kinetic = 0.0;
    double damped = 0.0;

    void add(const state::State& state, double v, double force, double mass) {
        const double next = step::Kick(state.alpha, state.dt)(v, force, 1.0 / mass);
        kinetic += 0.5 * mass * v * next;
        damped += 0.5 * state.dt * state.alpha * mass * 0.5 * (v + next) * v;
    }
};

Motion motion_energy(const state::State& state) {
    const state::Elements& elements = state.elements;
    Motion sum;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        if (state.rigid_of(k)) continue;
        sum.add(state, elements.vx[k], elements.fx[k], elements.mass(k));
        sum.add(state, elements.vy[k], elements.fy[k], elements.mass(k));
        sum.add(state, elements.spin[k], elements.moment[k], elements.inertia(k));
    }
    for (const state::RigidBody& rigid : state.rigid_bodies) {
        if (rigid.empty()) continue;
        sum.add(state, rigid.velocity.x, rigid.force.x, rigid.mass);
        sum.add(state, rigid.velocity.y, rigid.force.y, rigid.mass);
        sum.add(state, rigid.spin, rigid.moment, rigid.inertia);
    }
    // Outlines, in the ways in which they are free.
    for (const state::Wall& wall : state.walls) {
        const Vec2 force = wall.force + wall.weight(state.gravity);
        if (wall.free_x()) sum.add(state, wall.velocity.x, force.x, wall.matter->mass);
        if (wall.free_y()) sum.add(state, wall.velocity.y, force.y, wall.matter->mass);
        if (wall.free_to_turn()) sum.add(state, wall.spin, wall.moment, wall.matter->inertia);
    }
    return sum;
}

template <class Law>
double energy_of_cells(const state::BondSet<Law>& /*bonds*/) {
    return 0.0;
}

template <class Law>
double energy_of_cells(const state::FacetSet<Law>& bonds) {
    double sum = 0.0;
    for (std::size_t e = 0; e < bonds.pressure.size(); ++e) {
        sum += step::cell_energy(bonds.pressure[e], bonds.pressure_per_growth[e]);
    }
    return sum;
}

template <class Bonds>
void add_bonds(const state::State& state, const Bonds& bonds, Ledger& ledger) {
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        if (!bonds.is_broken(k)) ledger.bonds += step::stored_energy(bonds, state.elements, k);
        if constexpr (Bonds::law::yields) ledger.plastic += bonds.history.at(k).work;
    }
    ledger.bonds += energy_of_cells(bonds);
    ledger.bond_damping += bonds.dashpots.spent.total();
    ledger.fracture += bonds.fracture_work;
}

void add_spent(const law::Spent<double>& spent, Ledger& ledger) {
    ledger.friction += spent.friction;
    ledger.contact_damping += spent.damped;
}

void add_rolling(const state::RollingContacts& rolling, Ledger& ledger) {
    for (std::size_t c = 0; c < rolling.stiffness.size(); ++c) {
        ledger.contacts += law::Rolling::stored_energy(rolling.stiffness[c], rolling.history.at(c));
        add_spent(rolling.spent.at(c), ledger);
    }
}

void add_contacts(const state::State& state, Ledger& ledger) {
    const state::Contacts& contacts = state.contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const law::Coulomb::Params params = contacts.rules[contacts.rule[c]].params();
        ledger.contacts += law::Coulomb::stored_energy(params, state.overlap(c), contacts.history.at(c));
    }
    add_spent(contacts.spent(), ledger);
    add_rolling(contacts.rolling, ledger);
}

void add_wall_contacts(const state::State& state, Ledger& ledger) {
    const state::WallContacts& contacts = state.wall_contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const law::Coulomb::Params params = state::wall_rule(state, contacts.wall[c], contacts.element[c]).params();
        ledger.contacts += law::Coulomb::stored_energy(params, contacts.overlap[c], contacts.history.at(c));
        add_spent(contacts.spent.at(c), ledger);
    }
    add_spent(contacts.booked, ledger);
    add_rolling(contacts.rolling, ledger);
}

void add_outline_contacts(const state::State& state, Ledger& ledger) {
    for (const state::OutlineContact& row : state.outline_contacts.rows) {
        ledger.contacts += law::Coulomb::stored_energy(row.rule.params(), row.overlap, row.history);
        add_spent(row.spent, ledger);
    }
    add_spent(state.outline_contacts.booked, ledger);
}

double gravity_energy(const state::State& state) {
    double sum = 0.0;
    if (state.gravity == Vec2{}) return sum;
    const state::Elements& elements = state.elements;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        if (!state.rigid_of(k)) sum -= elements.mass(k) * dot(state.gravity, elements.displacement(k));
    }
    for (const state::RigidBody& rigid : state.rigid_bodies) {
        sum -= rigid.mass * dot(state.gravity, rigid.displacement);
    }
    for (const state::Wall& wall : state.walls) sum -= dot(wall.weight(state.gravity), wall.offset);
    return sum;
}

} // namespace

Vec2 velocity_now(const state::State& state, std::size_t element) {
    const state::Elements& elements = state.elements;
    const Vec2 v = elements.velocity(element);
    if (state.rigid_of(element)) return v;
    const double inverse_mass = elements.inverse_mass[element];
    const step::Kick kicked(state.alpha, state.dt);
    return 0.5 *
           (v + Vec2{kicked(v.x, elements.fx[element], inverse_mass), kicked(v.y, elements.fy[element], inverse_mass)});
}

double spin_now(const state::State& state, std::size_t element) {
    const state::Elements& elements = state.elements;
    const double spin = elements.spin[element];
    if (state.rigid_of(element)) return spin;
    const step::Kick kicked(state.alpha, state.dt);
    return 0.5 * (spin + kicked(spin, elements.moment[element], elements.inverse_inertia[element]));
}

Ledger ledger_of(const state::State& state) {
    Ledger ledger;
    const Motion motion = motion_energy(state);
    ledger.kinetic = motion.kinetic;
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit([&](const auto& bonds) { add_bonds(state, bonds, ledger); }, any);
    }
    add_contacts(state, ledger);
    add_wall_contacts(state, ledger);
    add_outline_contacts(state, ledger);
    ledger.potential = gravity_energy(state);
    ledger.mass_damping = state.booked.mass_damping + motion.damped;
    ledger.removed = state.booked.removed;
    ledger.work = state.booked.loads + state.booked.drives + state.booked.walls;
    return ledger;
}

double balance(const Ledger& ledger) {
    return ledger.kinetic + ledger.bonds + ledger.contacts + ledger.potential + ledger.plastic + ledger.fracture +
           ledger.friction + ledger.bond_damping + ledger.contact_damping + ledger.mass_damping + ledger.removed -
           ledger.work;
}

Momentum momentum_of(const state::State& state) {
    const state::Elements& elements = state.elements;
    Momentum sum;
    const auto add = [&](double mass, double inertia, Vec2 position, Vec2 velocity, double spin) {
        sum.linear += mass * velocity;
        sum.angular += mass * cross(position, velocity) + inertia * spin;
    };
    for (std::size_t k = 0; k < elements.size(); ++k) {
        if (state.rigid_of(k)) continue;
        add(elements.mass(k), elements.inertia(k), elements.position(k), velocity_now(state, k), spin_now(state, k));
    }
    for (const state::RigidBody& rigid : state.rigid_bodies) {
        if (rigid.empty()) continue;
        const step::Kick kicked(state.alpha, state.dt);
        const auto now = [&](double v, double force, double inertia) {
            return 0.5 * (v + kicked(v, force, 1.0 / inertia));
        };
        add(rigid.mass, rigid.inertia, rigid.middle(),
            {now(rigid.velocity.x, rigid.force.x, rigid.mass), now(rigid.velocity.y, rigid.force.y, rigid.mass)},
            now(rigid.spin, rigid.moment, rigid.inertia));
    }
    for (std::size_t row = 0; row < state.walls.size(); ++row) {
        if (!state.walls[row].matter) continue;
        const WallMotion wall = motion_of_wall(state, row);
        add(wall.mass, wall.inertia, wall.position, wall.velocity, wall.spin);
    }
    return sum;
}

BodyMotion motion_of_body(const state::State& state, std::size_t row) {
    const state::Elements& elements = state.elements;
    const state::Body& body = state.bodies[row];
    constexpr double huge = std::numeric_limits<double>::infinity();
    BodyMotion motion;
    motion.extent = {{huge, huge}, {-huge, -huge}};
    for (std::size_t k = body.first; k < body.last; ++k) {
        const Vec2 at = elements.position(k);
        const double R = elements.radius[k];
        motion.mass += elements.mass(k);
        motion.centre += elements.mass(k) * at;
        motion.velocity += elements.mass(k) * velocity_now(state, k);
        motion.extent.lower = {std::min(motion.extent.lower.x, at.x - R), std::min(motion.extent.lower.y, at.y - R)};
        motion.extent.upper = {std::max(motion.extent.upper.x, at.x + R), std::max(motion.extent.upper.y, at.y + R)};
    }
    motion.centre = motion.centre / motion.mass;
    motion.velocity = motion.velocity / motion.mass;
    double inertia = 0.0;
    double angular = 0.0;
    for (std::size_t k = body.first; k < body.last; ++k) {
        const Vec2 arm = elements.position(k) - motion.centre;
        inertia += elements.mass(k) * dot(arm, arm) + elements.inertia(k);
        angular += elements.mass(k) * cross(arm, velocity_now(state, k) - motion.velocity) +
                   elements.inertia(k) * spin_now(state, k);
    }
    motion.spin = angular / inertia;
    return motion;
}

} // namespace demlua::observe
