// A wall that seeks a force.
//
//   v = (F - P)/R + w,   M w' = F - P,   R = K dt/g + 2 C,   M = 10 R^2/K
//
// v velocity in the direction in which the wall presses, at most the servo's greatest speed; F force wanted; P force with
// which it presses now; K and C sums of the normal stiffnesses and dashpots of the contacts that touch; g gain; dt step. Without
// dashpots a step makes up for the share g of what is missing while elements stand still. To elements that move the wall is a
// constant force and a dashpot, which takes energy and never gives any, so that waves come back from the wall weaker than they
// went. The part w that is kept makes the mean of P that of F on a bed that gives way or swells steadily; it answers like a
// mass M on that dashpot, and gives nothing either. P holds the contacts' own dashpot force C v of the step before: with 2 C below, that answer halves from step to step,
// where without it a short step would let it grow.
// Source: derived here. Limits: F must change slowly against the time a wave takes through what is pressed.
#pragma once

#include "engine/state/state.hpp"

namespace demlua::step {

/// What a wall touches.
struct Met {
    double K = 0.0; ///< N/m; zero for nothing
    double C = 0.0; ///< N s/m
};

/// Velocity (m/s) along its axis of a wall on which elements press with `force` (N, along the axis), and which presses towards
/// `side` (+1 or -1). Counts how far the wall goes without meeting anything.
double seek_force(state::Servo& servo, double side, double force, const Met& met, double time, double dt);

} // namespace demlua::step
