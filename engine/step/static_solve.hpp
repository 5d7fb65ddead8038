// Elements brought to rest under the loads of one instant, by solving for it instead of marching there.
//
//   linear:  K u = f                             one solution from bonding; K of springs_of
//   else:    K(u) du = f - f_int(u)              Newton's method on the forces the engine itself computes; K(u) of
//                                                tangent_of, repeated until what is left on free elements is small
//
// Held are the freedoms that are driven: supports and given velocities where they stand, given displacements at their
// value of the instant. A solution counts as one step: the clock goes on by dt, so that what is written before and after
// can be told apart, and loads are those of the new instant. All is at rest afterwards.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"
#include "engine/step/step.hpp"

#include <cstddef>

namespace demlua::step {

struct StaticAnswer {
    int solutions = 0;     ///< of a linear system
    double residual = 0.0; ///< of the loads and reactions, what is left on free elements (norms; moments over radius)
};

/// Leaves the state as it was and throws SceneError at `said.place` when the scene has walls, rigid bodies or contacts that
/// press, when something is held by nothing (elements named), when a bond would yield, or when no rest is found.
StaticAnswer solve_static(state::State& state, Stepper& stepper, const model::StaticSolve& said);

} // namespace demlua::step
