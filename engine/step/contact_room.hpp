// What contacts could do to an element that has none yet.
#pragma once

#include "engine/state/state.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <span>

namespace demlua::step {

/// Stiffness and damping that an element feels, scaled by M^-1/2 on both sides, in x, y and rotation.
struct Felt {
    Eigen::Vector3d stiffness = Eigen::Vector3d::Zero(); ///< 1/s^2
    Eigen::Vector3d damping = Eigen::Vector3d::Zero();   ///< 1/s
};

/// How many of the smallest disks fit around one of radius `R`.
double room_around(double R, double smallest);

/// Bound on what `count` of the hardest contacts do to element k, whichever way they lie: with other bodies and walls,
/// and with its own body too when `with_own_body`. The elements on the other side are allowed for.
Felt hardest_contacts(const state::State& state, std::size_t k, double count, bool with_own_body);

/// What `count` of the hardest contacts with element k add to the largest eigenvalue of its rigid body, scaled likewise;
/// `heaviest` is the greatest mass that moves with an element of each body, kg.
struct RigidlyFelt {
    double stiffness = 0.0; ///< 1/s^2
    double damping = 0.0;   ///< 1/s
};
RigidlyFelt hardest_contacts_on(const state::State& state, const state::RigidBody& rigid, std::size_t k, double count,
                                std::span<const double> heaviest);

} // namespace demlua::step
