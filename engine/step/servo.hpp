// A wall that seeks a force.
//
//   v = g (F - P) / (K dt)
//
// v velocity in the direction in which the wall presses, at most the servo's greatest speed; g gain; F force wanted; P force
// with which it presses now; K sum of the normal stiffnesses of the contacts that touch; dt step. Where elements
// stand still, a step makes up for the share g of what is missing. To elements that move the wall is a constant force and a dashpot
// K dt/g, which takes energy and never gives any: for g = 0.1 that is some five times sqrt(K m) of a grain, so that waves come back from the
// wall weaker than they went, and the force settles over some passages of a wave without overshoot.
// Source: derived here. Limits: F must change slowly against that time.
#pragma once

#include "engine/state/state.hpp"

namespace demlua::step {

/// Velocity (m/s) along its axis of a wall with stiffness `K` (N/m), on which elements press with `force` (N, along the
/// axis), and which presses towards `side` (+1 or -1). Counts how far the wall goes without meeting anything.
double seek_force(state::Servo& servo, double side, double force, double K, double time, double dt);

} // namespace demlua::step
