#include "engine/step/loads.hpp"

#include "engine/step/motion.hpp"

namespace demlua::step {

namespace {

double& force_of(state::Elements& elements, state::Freedom freedom, std::size_t k) {
    if (freedom == state::Freedom::x) return elements.fx[k];
    return freedom == state::Freedom::y ? elements.fy[k] : elements.moment[k];
}

double velocity_of(const state::Elements& elements, state::Freedom freedom, std::size_t k) {
    if (freedom == state::Freedom::x) return elements.vx[k];
    return freedom == state::Freedom::y ? elements.vy[k] : elements.spin[k];
}

double mass_of(const state::Elements& elements, state::Freedom freedom, std::size_t k) {
    return freedom == state::Freedom::rotation ? elements.inertia(k) : elements.mass(k);
}

double& force_of(state::RigidBody& rigid, state::Freedom freedom) {
    if (freedom == state::Freedom::x) return rigid.force.x;
    return freedom == state::Freedom::y ? rigid.force.y : rigid.moment;
}

double velocity_of(const state::RigidBody& rigid, state::Freedom freedom) {
    if (freedom == state::Freedom::x) return rigid.velocity.x;
    return freedom == state::Freedom::y ? rigid.velocity.y : rigid.spin;
}

double mass_of(const state::RigidBody& rigid, state::Freedom freedom) {
    return freedom == state::Freedom::rotation ? rigid.inertia : rigid.mass;
}

/// Velocity half a step from now.
double wanted_velocity(const state::State& state, const state::Drive& drive) {
    if (!drive.is_displacement) return drive.value.at(state.time + 0.5 * state.dt);
    return (drive.value.at(state.time + state.dt) - drive.value.at(state.time)) / state.dt;
}

} // namespace

void add_loads(state::State& state) {
    state::Elements& elements = state.elements;
    for (const state::Load& load : state.loads) {
        const Vec2 value{load.x.at(state.time), load.y.at(state.time)};
        for (std::size_t n = 0; n < load.element.size(); ++n) {
            elements.fx[load.element[n]] += load.share[n] * value.x;
            elements.fy[load.element[n]] += load.share[n] * value.y;
        }
    }
}

void apply_drives(state::State& state) {
    for (state::Drive& drive : state.drives) {
        const double target = wanted_velocity(state, drive);
        const auto reaction_on = [&](double& force, double velocity, double mass) {
            const double needed = force_for(velocity, target, mass, state.alpha, state.dt);
            const double reaction = needed - force;
            force = needed;
            return reaction;
        };
        for (std::size_t n = 0; n < drive.element.size(); ++n) {
            const std::size_t k = drive.element[n];
            drive.reaction[n] =
                reaction_on(force_of(state.elements, drive.freedom, k), velocity_of(state.elements, drive.freedom, k),
                            mass_of(state.elements, drive.freedom, k));
        }
        for (std::size_t n = 0; n < drive.rigid.size(); ++n) {
            state::RigidBody& rigid = state.rigid_bodies[drive.rigid[n]];
            drive.rigid_reaction[n] = reaction_on(force_of(rigid, drive.freedom), velocity_of(rigid, drive.freedom),
                                                  mass_of(rigid, drive.freedom));
        }
    }
}

void book_work(state::State& state) {
    const state::Elements& elements = state.elements;
    double power = 0.0;
    for (const state::Load& load : state.loads) {
        const Vec2 value{load.x.at(state.time), load.y.at(state.time)};
        for (std::size_t n = 0; n < load.element.size(); ++n) {
            power += load.share[n] * dot(value, elements.velocity(load.element[n]));
        }
    }
    state.booked.loads += 0.5 * state.dt * power;
    power = 0.0;
    for (const state::Drive& drive : state.drives) {
        for (std::size_t n = 0; n < drive.element.size(); ++n) {
            power += drive.reaction[n] * velocity_of(elements, drive.freedom, drive.element[n]);
        }
        for (std::size_t n = 0; n < drive.rigid.size(); ++n) {
            power += drive.rigid_reaction[n] * velocity_of(state.rigid_bodies[drive.rigid[n]], drive.freedom);
        }
    }
    state.booked.drives += 0.5 * state.dt * power;
}

} // namespace demlua::step
