// Stress in elements.
//
//   sigma = (1/V) sum over contacts of  f (x) r        V = cell area times thickness
//
// f force on the element at a contact, r from its centre to the contact point; tension positive; the symmetric part.
// Source: mean stress of a body loaded at points (e.g. Christoffersen, Mehrabadi & Nemat-Nasser 1981).
// Limit: exact for an element in equilibrium; body forces and accelerations add terms of the order of its size.
#pragma once

#include "engine/state/state.hpp"

#include <vector>

namespace demlua::observe {

/// xx, yy, xy of every element in turn, Pa.
std::vector<double> stress_of_elements(const state::State& state);

} // namespace demlua::observe
