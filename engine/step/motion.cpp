#include "engine/step/motion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace demlua::step {

namespace {

MotionRows rows_of(state::Elements& elements, std::vector<double>& spent) {
    return {elements.ux.data(),
            elements.uy.data(),
            elements.rotation.data(),
            elements.vx.data(),
            elements.vy.data(),
            elements.spin.data(),
            elements.fx.data(),
            elements.fy.data(),
            elements.moment.data(),
            elements.inverse_mass.data(),
            elements.inverse_inertia.data(),
            spent.empty() ? nullptr : spent.data()};
}

/// The first element faster than its radius allows, or not moving at any number.
std::size_t first_runaway(const state::State& state, double greatest_move, Share part) {
    const state::Elements& elements = state.elements;
    for (std::size_t k = part.begin; k < part.end; ++k) {
        const double limit = greatest_move * elements.radius[k] / state.dt;
        const Vec2 v = elements.velocity(k);
        if (!(dot(v, v) <= limit * limit)) return k;
    }
    return Drift::no_element;
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
    for (const std::size_t k : state.single) work(Share{k, k + 1, 0});
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
    for (const Index k : state.rigid_members) elements.fx[k] = elements.fy[k] = 0.0;
}

Drift move_elements(state::State& state, const TravelLimit& limit, const Kernels& kernels, Team& team) {
    state::Elements& elements = state.elements;
    const Kick kicked(state.alpha, state.dt);
    const bool damped = state.alpha > 0.0;
    const bool heavy = !(state.gravity == Vec2{});
    const MotionTerms terms{kicked.keep,
                            kicked.gain,
                            state.dt,
                            state.alpha,
                            state.gravity.x,
                            state.gravity.y,
                            limit.share * limit.smallest_radius / state.dt};
    std::vector<double> spent(damped ? elements.size() : 0);
    const MotionRows rows = rows_of(elements, spent);
    std::vector<Drift> found(team.parts());
    share_free(state, team, [&](Share part) {
        run_rows(kernels, part, [&](const Kernels& width, std::size_t begin, std::size_t end) {
            const MotionKernel move = width.move[(damped ? 1U : 0U) + (heavy ? 2U : 0U)];
            const Fastest fastest = move(rows, terms, begin, end);
            Drift drift{state.dt * std::sqrt(fastest.speed_squared), Drift::no_element};
            if (fastest.beyond_limit) drift.runaway = first_runaway(state, limit.share, {begin, end, part.part});
            found[part.part].join(drift);
        });
    });
    for (const double work : spent) state.booked.mass_damping += work;
    Drift whole;
    for (const Drift& part : found) whole.join(part);
    return whole;
}

} // namespace demlua::step
