#include "engine/step/motion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace demlua::step {

namespace {

/// Energy mass-proportional damping takes in a kick: alpha m times the square of the mean velocity, times dt.
double damping_work(const state::State& state, std::size_t k, Vec2 v_before, double spin_before) {
    const state::Elements& elements = state.elements;
    const Vec2 v = 0.5 * (v_before + elements.velocity(k));
    const double spin = 0.5 * (spin_before + elements.spin[k]);
    return state.alpha * state.dt * (elements.mass(k) * dot(v, v) + elements.inertia(k) * spin * spin);
}

/// Calls `work(Share)` over runs of elements that move on their own.
template <class Work>
void share_free(const state::State& state, Team& team, const Work& work) {
    if (state.rigid_bodies.empty()) {
        team.share(state.elements.size(), work);
        return;
    }
    for (const state::Body& body : state.bodies) {
        if (body.rigid) continue;
        team.share(body.size(), [&](Share part) {
            work(Share{body.first + part.begin, body.first + part.end, part.part});
        });
    }
}

} // namespace

void Drift::join(const Drift& other) {
    farthest = std::max(farthest, other.farthest);
    runaway = std::min(runaway, other.runaway);
}

void clear_forces(state::State& state, Team& team) {
    state::Elements& elements = state.elements;
    const Vec2 g = state.gravity;
    const bool weightless = g == Vec2{};
    team.share(elements.size(), [&](Share part) {
        for (std::size_t k = part.begin; k < part.end; ++k) {
            const double mass = weightless ? 0.0 : elements.mass(k);
            elements.fx[k] = mass * g.x;
            elements.fy[k] = mass * g.y;
            elements.moment[k] = 0.0;
        }
    });
}

void kick(state::State& state, Team& team) {
    state::Elements& elements = state.elements;
    const Kick kicked(state.alpha, state.dt);
    const bool damped = state.alpha > 0.0;
    std::vector<double> spent(damped ? elements.size() : 0);
    share_free(state, team, [&](Share part) {
        for (std::size_t k = part.begin; k < part.end; ++k) {
            const Vec2 v = elements.velocity(k);
            const double spin = elements.spin[k];
            elements.vx[k] = kicked(v.x, elements.fx[k], elements.inverse_mass[k]);
            elements.vy[k] = kicked(v.y, elements.fy[k], elements.inverse_mass[k]);
            elements.spin[k] = kicked(spin, elements.moment[k], elements.inverse_inertia[k]);
            if (damped) spent[k] = damping_work(state, k, v, spin);
        }
    });
    for (const double work : spent) state.booked.mass_damping += work;
}

Drift drift(state::State& state, double greatest_move, Team& team) {
    state::Elements& elements = state.elements;
    const double dt = state.dt;
    std::vector<Drift> found(team.parts());
    share_free(state, team, [&](Share part) {
        double fastest = 0.0;
        std::size_t runaway = Drift::no_element;
        for (std::size_t k = part.begin; k < part.end; ++k) {
            const double speed2 = elements.vx[k] * elements.vx[k] + elements.vy[k] * elements.vy[k];
            const double limit = greatest_move * elements.radius[k] / dt;
            fastest = std::max(fastest, speed2);
            // Written so that a velocity that is not a number is caught as well.
            if (!(speed2 <= limit * limit) && runaway == Drift::no_element) runaway = k;
            elements.ux[k] += dt * elements.vx[k];
            elements.uy[k] += dt * elements.vy[k];
            elements.rotation[k] += dt * elements.spin[k];
        }
        found[part.part].join({dt * std::sqrt(fastest), runaway});
    });
    Drift whole;
    for (const Drift& part : found) whole.join(part);
    return whole;
}

void gather_rigid(state::State& state) {
    const state::Elements& elements = state.elements;
    for (state::RigidBody& rigid : state.rigid_bodies) {
        const state::Body& body = state.bodies[rigid.body];
        const Vec2 centre = rigid.centre + rigid.displacement;
        rigid.force = {};
        rigid.moment = 0.0;
        for (std::size_t k = body.first; k < body.last; ++k) {
            rigid.force += elements.force(k);
            rigid.moment += elements.moment[k] + cross(elements.position(k) - centre, elements.force(k));
        }
    }
}

Drift move_rigid(state::State& state, double greatest_move) {
    state::Elements& elements = state.elements;
    const double dt = state.dt;
    const Kick kicked(state.alpha, dt);
    Drift found;
    for (state::RigidBody& rigid : state.rigid_bodies) {
        const Vec2 v = rigid.velocity;
        const double spin = rigid.spin;
        rigid.velocity = {kicked(v.x, rigid.force.x, 1.0 / rigid.mass), kicked(v.y, rigid.force.y, 1.0 / rigid.mass)};
        rigid.spin = kicked(spin, rigid.moment, 1.0 / rigid.inertia);
        const Vec2 mean = 0.5 * (v + rigid.velocity);
        const double mean_spin = 0.5 * (spin + rigid.spin);
        state.booked.mass_damping +=
            state.alpha * dt * (rigid.mass * dot(mean, mean) + rigid.inertia * mean_spin * mean_spin);
        rigid.displacement += dt * rigid.velocity;
        rigid.rotation += dt * rigid.spin;

        const state::Body& body = state.bodies[rigid.body];
        for (std::size_t k = body.first; k < body.last; ++k) {
            const Vec2 arm = Vec2{elements.reference_x[k], elements.reference_y[k]} - rigid.centre;
            const Vec2 u = rigid.displacement + turned(arm, rigid.rotation) - arm;
            elements.vx[k] = (u.x - elements.ux[k]) / dt;
            elements.vy[k] = (u.y - elements.uy[k]) / dt;
            elements.spin[k] = rigid.spin;
            elements.ux[k] = u.x;
            elements.uy[k] = u.y;
            elements.rotation[k] = rigid.rotation;
            const double moved = dt * norm(elements.velocity(k));
            found.join({moved, moved <= greatest_move * elements.radius[k] ? Drift::no_element : k});
        }
    }
    return found;
}

} // namespace demlua::step
