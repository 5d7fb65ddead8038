// What solutions at rest share: what they can solve for, the loads as a vector, and stopping what moves.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/state/state.hpp"
#include "engine/step/held.hpp"
#include "engine/step/step.hpp"

#include <Eigen/Core>
#include <string>

namespace demlua::step {

/// Who asks for rest, for messages.
struct RestAsked {
    Place place;
    std::string word;
};

[[noreturn]] void refuse(const RestAsked& asked, const std::string& rule, const std::string& hint);

/// Throws SceneError where the scene has walls, rigid bodies or contacts that press.
void refuse_what_is_not_bonds(const state::State& state, const RestAsked& asked);
/// Throws SceneError naming the elements of parts that could still move as a whole.
void refuse_floating(const state::State& state, const Held& held, const RestAsked& asked);

/// The first contact that presses, as words; empty if none does.
std::string pressed_contact(const state::State& state);

/// Velocities and spins of all elements become zero.
void stop_motion(state::Elements& elements);

/// Displacements and rotations from bonding that held freedoms are to have; zero where free.
Eigen::VectorXd places_held(const state::Elements& elements, const Held& held);

/// 1, 1, 1/R of each element: freedoms as lengths, rotation = value/R.
Eigen::VectorXd freedoms_per_radius(const state::Elements& elements);
/// Forces on elements, moments over radius, N.
Eigen::VectorXd forces_per_radius(const state::Elements& elements, const Eigen::VectorXd& per_radius);
/// Loads and gravity at the state's instant, alone, in the same form. Leaves them in the elements' forces.
Eigen::VectorXd outer_forces(state::State& state, Stepper& stepper, const Eigen::VectorXd& per_radius);

} // namespace demlua::step
