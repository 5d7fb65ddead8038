// Central difference: velocities at half steps, positions and forces at whole steps.
//
//   v+ = ((1 - a) v- + dt f/m) / (1 + a),  a = alpha dt/2       kick, mass-proportional damping taken implicitly
//   x  = x + dt v+                                              drift
#pragma once

#include "engine/base/team.hpp"
#include "engine/state/state.hpp"
#include "engine/step/kernels.hpp"

namespace demlua::step {

/// What a kick does: v+ = keep v- + gain f/m.
struct Kick {
    double keep;
    double gain; ///< s

    Kick(double alpha, double dt)
        : keep((1.0 - 0.5 * alpha * dt) / (1.0 + 0.5 * alpha * dt)), gain(dt / (1.0 + 0.5 * alpha * dt)) {}

    /// Velocity half a step after the present instant of something with velocity `v` half a step before it.
    [[nodiscard]] double operator()(double v, double force, double inverse_mass) const {
        return keep * v + gain * (force * inverse_mass);
    }
};

/// Force that takes velocity `v` to `target` in a kick.
inline double force_for(double v, double target, double mass, double alpha, double dt) {
    const double a = 0.5 * alpha * dt;
    return mass * ((1.0 + a) * target - (1.0 - a) * v) / dt;
}

/// What the drift found: the greatest distance moved (m), and the first element that moved more than `greatest_move`
/// times its radius or to no number at all.
struct Drift {
    double farthest = 0.0;
    std::size_t runaway = no_element;
    static constexpr std::size_t no_element = static_cast<std::size_t>(-1);

    /// Both together.
    void join(const Drift& other);
};

/// How far an element may move in a step.
struct TravelLimit {
    double share = 0.2;           ///< of its radius
    double smallest_radius = 0.0; ///< of all elements, m
};

/// Sets the forces on elements to gravity and zero; gravity of rigid bodies acts on their middles.
void clear_forces(state::State& state, Team& team);

/// Kicks and moves every element that is not part of a rigid body, books what mass damping spends, and clears the forces.
Drift move_elements(state::State& state, const TravelLimit& limit, const Kernels& kernels, Team& team);

} // namespace demlua::step
