// A time step that is safe for the assembly there is and for the contacts it may come to; docs/theory/time_step.md.
//
// Bound. A spring between p elements stores k (sum b_i u_i)^2/2 <= p k sum (b_i u_i)^2/2 for any motion, hence
//
//   K <= diag(D_i),   D_i = sum over the springs of element i of  p k b_i b_i'
//
// and the largest eigenvalue of M_i^-1/2 D_i M_i^-1/2 over the elements bounds w_max^2 of any assembly from above. It is
// exact for a close-packed lattice at Kt = 0 and for Kt >= Kn/3, and at most 1.17 times w^2 between. Contacts an element
// may meet enter its D_i, as many as fit round it. Dashpots enter in the same way, see law/stable_step.hpp.
// Source: derived here; compare Tavarez & Plesha 2007, section 6.
//
// Sharp. K and C of the bonds as they are, with D_i for contacts only, and the largest dt with
// lambda_max(dt^2 K + 2 dt C) <= 4 by Lanczos iteration (lanczos.hpp). Bodies whose bonds can break keep the bound, which
// holds for every way of breaking.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

#include <string>

namespace demlua::step {

struct StableStep {
    double critical = 0.0; ///< s; infinite where nothing is stiff
    std::string reason;    ///< the rule, where it is tightest, and what eq. 19 would give
};

/// `470.2 ns`, `1.834 us`: a time in the unit that suits it.
std::string in_seconds(double time);

/// By the rule of a scene. Throws SceneError at `place` where eq. 19 is asked for and unstable.
///
/// Bonds that break, and contacts that open, only lower the frequency; what raises it is more damping. So a step stays
/// safe through a run, and is worth finding again when damping is said or a notch is cut.
StableStep stable_step(const state::State& state, model::StepRule rule, const Place& place);

/// s; the rules one by one. `by_bonds` is the sharp limit of the bonds alone, as if nothing could touch.
double bound_step(const state::State& state);
double sharp_step(const state::State& state);
double sharp_step_of_bonds(const state::State& state);

/// Tavarez & Plesha 2007, eq. 19 without damping, s: the smallest over the elements' materials.
double paper_step(const state::State& state);

} // namespace demlua::step
