#include "engine/step/rigid_motion.hpp"

#include <algorithm>
#include <vector>

namespace demlua::step {

namespace {

Vec2 turned_arm(const state::RigidBody& rigid, Vec2 at_start) {
    return turned(at_start - rigid.centre, rigid.rotation);
}

/// Puts element `k` where its rigid body has taken it.
double follow(const state::RigidBody& rigid, state::Elements& elements, std::size_t k, double dt) {
    const Vec2 at_start{elements.reference_x[k], elements.reference_y[k]};
    const Vec2 u = rigid.displacement + turned_arm(rigid, at_start) - (at_start - rigid.centre);
    elements.vx[k] = (u.x - elements.ux[k]) / dt;
    elements.vy[k] = (u.y - elements.uy[k]) / dt;
    elements.spin[k] = rigid.spin;
    elements.ux[k] = u.x;
    elements.uy[k] = u.y;
    elements.rotation[k] = rigid.rotation;
    elements.fx[k] = elements.fy[k] = elements.moment[k] = 0.0;
    return dt * norm(elements.velocity(k));
}

/// Kicks and moves the whole; returns what mass damping spent, J.
double move_whole(state::RigidBody& rigid, const Kick& kicked, double alpha, double dt) {
    const Vec2 v = rigid.velocity;
    const double spin = rigid.spin;
    rigid.velocity = {kicked(v.x, rigid.force.x, 1.0 / rigid.mass), kicked(v.y, rigid.force.y, 1.0 / rigid.mass)};
    rigid.spin = kicked(spin, rigid.moment, 1.0 / rigid.inertia);
    rigid.displacement += dt * rigid.velocity;
    rigid.rotation += dt * rigid.spin;
    const Vec2 mean = 0.5 * (v + rigid.velocity);
    const double mean_spin = 0.5 * (spin + rigid.spin);
    return alpha * dt * (rigid.mass * dot(mean, mean) + rigid.inertia * mean_spin * mean_spin);
}

/// Takes one element out of the columns of the rigid body, with the velocity it has there and its own weight; the order of
/// the others stays.
void strike_out(state::State& state, state::RigidBody& rigid, std::size_t k) {
    const auto begin = state.rigid_members.begin() + static_cast<std::ptrdiff_t>(rigid.first);
    const auto end = state.rigid_members.begin() + static_cast<std::ptrdiff_t>(rigid.last);
    const auto at = std::find(begin, end, static_cast<Index>(k));
    std::rotate(at, at + 1, end);
    --rigid.last;
    state.rigid_row[k] = state::State::no_rigid;
    const Vec2 v = rigid.velocity + rigid.spin * turned_left(state.elements.position(k) - rigid.middle());
    state.elements.vx[k] = v.x;
    state.elements.vy[k] = v.y;
    state.elements.fx[k] += state.elements.mass(k) * state.gravity.x;
    state.elements.fy[k] += state.elements.mass(k) * state.gravity.y;
    state.single.insert(std::lower_bound(state.single.begin(), state.single.end(), static_cast<Index>(k)),
                        static_cast<Index>(k));
}

/// Mass, middle and inertia about it without element `k`, and the motion of the new middle.
void take_away(state::RigidBody& rigid, const state::Elements& elements, std::size_t k) {
    const double m = elements.mass(k);
    const Vec2 at_start{elements.reference_x[k], elements.reference_y[k]};
    const double left = rigid.mass - m;
    const Vec2 shift = (m / left) * (rigid.centre - at_start);
    const Vec2 shift_now = turned(shift, rigid.rotation);
    const Vec2 arm = at_start - rigid.centre;
    rigid.inertia -= m * dot(arm, arm) + elements.inertia(k) + left * dot(shift, shift);
    rigid.mass = left;
    rigid.centre += shift;
    rigid.displacement += shift_now - shift;
    rigid.velocity += rigid.spin * turned_left(shift_now);
}

} // namespace

void gather_rigid(state::State& state, Team& team) {
    const state::Elements& elements = state.elements;
    team.share(state.rigid_bodies.size(), [&](Share part) {
        for (std::size_t r = part.begin; r < part.end; ++r) {
            state::RigidBody& rigid = state.rigid_bodies[r];
            const Vec2 centre = rigid.middle();
            rigid.force = rigid.mass * state.gravity;
            rigid.moment = 0.0;
            for (const Index k : state.members(rigid)) {
                rigid.force += elements.force(k);
                rigid.moment += elements.moment[k] + cross(elements.position(k) - centre, elements.force(k));
            }
        }
    });
}

Drift move_rigid(state::State& state, double greatest_move, Team& team) {
    state::Elements& elements = state.elements;
    const Kick kicked(state.alpha, state.dt);
    std::vector<Drift> found(team.parts());
    std::vector<double> spent(state.alpha > 0.0 ? state.rigid_bodies.size() : 0);
    team.share(state.rigid_bodies.size(), [&](Share part) {
        Drift& drift = found[part.part];
        for (std::size_t r = part.begin; r < part.end; ++r) {
            state::RigidBody& rigid = state.rigid_bodies[r];
            if (rigid.empty()) continue;
            const double damped = move_whole(rigid, kicked, state.alpha, state.dt);
            if (!spent.empty()) spent[r] = damped;
            for (const std::size_t k : state.members(rigid)) {
                const double moved = follow(rigid, elements, k, state.dt);
                drift.join({moved, moved <= greatest_move * elements.radius[k] ? Drift::no_element : k});
            }
        }
    });
    for (const double damped : spent) state.booked.mass_damping += damped;
    Drift whole;
    for (const Drift& part : found) whole.join(part);
    return whole;
}

void let_go_of_rigid(state::State& state, std::size_t k) {
    const std::optional<std::size_t> row = state.rigid_of(k);
    if (!row) return;
    state::RigidBody& rigid = state.rigid_bodies[*row];
    if (rigid.last - rigid.first > 2) {
        strike_out(state, rigid, k);
        take_away(rigid, state.elements, k);
        return;
    }
    while (!rigid.empty()) strike_out(state, rigid, state.rigid_members[rigid.first]);
    rigid.mass = rigid.inertia = rigid.spin = rigid.moment = 0.0;
    rigid.velocity = rigid.force = {};
}

} // namespace demlua::step
