// The part outlines have in the bound on the time step (pair_bound.hpp).
//
//   w^2 <= 2 (lambda_max(sum over contacts of Kn b_n b_n' + Kt b_t b_t') + N K (1/M + r^2/I)),   and the same with C for K
//
// first elements side by side along all sides and two more at every corner, b = (n/M^1/2, arm x n/I^1/2) how the outline's
// free motions move the place of the contact; then the N most contacts with walls and other outlines, K the greatest stiffness of
// one, M, I and r mass, moment of inertia and greatest arm. That is what these contacts would store in the outline alone,
// twice, since what meets it has the other half. Motions that are given take no part. No contact that is absent matters: each
// adds to the matrix. Source: as the pair bound; contacts a distance apart along a side are no more than their density's
// integral and one at each end, as b b' is convex there. Limit: elements overlap by no more than a fifth of the smallest radius.
#pragma once

#include "engine/state/state.hpp"
#include "engine/step/pair_bound.hpp"

namespace demlua::step {

/// `at` is the wall. Only outlines that are light for their contacts come near the elements' own bound.
Tightest bound_of_outlines(const state::State& state);

} // namespace demlua::step
