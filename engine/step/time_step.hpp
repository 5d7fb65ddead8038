// A time step that is safe for the assembly there is and for the contacts it may come to.
//
//   a pair's energy k (b_i u_i + b_j u_j)^2/2 <= k ((b_i u_i)^2 + (b_j u_j)^2)   for any motion, hence
//   K <= 2 diag(D_i),   D_i = sum over the pairs of element i of  kn n n' + kt s s',   s = (t, -a)
//
// b row of displacements to stretch or shear, n normal, t tangent, a lever arm of the element. The largest eigenvalue of
// 2 M_i^-1/2 D_i M_i^-1/2 over the elements bounds w_max^2 of any assembly from above. It is exact for a close-packed
// lattice at Kt = 0 and for Kt >= Kn/3, and at most 1.17 times w^2 between. Dashpots enter the same way, see
// law/stable_step.hpp. Source: derived here; compare Tavarez & Plesha 2007, section 6.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

#include <string>

namespace demlua::step {

struct StableStep {
    double critical = 0.0; ///< s
    std::string reason;    ///< where it is tightest and why
};

/// Safe for bonds as they are and, wherever anything can touch, for as many contacts as fit around an element.
StableStep safe_step(const state::State& state);

/// Tavarez & Plesha 2007, eq. 19, over the elements' materials; refused (SceneError at `place`) where it is unstable.
StableStep paper_step(const state::State& state, const Place& place);

} // namespace demlua::step
