// The part outlines have in the bound on the time step (pair_bound.hpp).
//
//   w^2 <= 2 N K (1/M + r^2/I),   and the same with C for K
//
// N the most contacts the outline can have, K and C the greatest stiffness and dashpot of one, M, I and r mass, moment of
// inertia and greatest arm: what N contacts would store in the outline alone, twice, since their elements have the other half.
// Source: as the pair bound, with |b b'| <= |b|^2. Limit: elements overlap by no more than a fifth of the smallest radius.
#pragma once

#include "engine/state/state.hpp"
#include "engine/step/pair_bound.hpp"

namespace demlua::step {

/// `at` is the wall. Only outlines that are light for their contacts come near the elements' own bound.
Tightest bound_of_outlines(const state::State& state);

} // namespace demlua::step
