// What a body of bonded pairs is really made of.
#pragma once

#include "engine/law/stiffness.hpp"
#include "engine/state/state.hpp"

#include <cstddef>
#include <optional>

namespace demlua::step {

/// E* (Pa) and nu* of a body held by pairs (not facets), from the mean stress in its middle part, of at most 2,000 elements,
/// when everything around that part follows a uniform strain: its bonds' equilibrium, solved for three strains. A little
/// above what a larger part would show. Nothing for a body of facets, or of fewer than 50 elements.
/// Source: definition of the effective moduli of a heterogeneous solid.
std::optional<law::PlaneModuli> real_moduli(const state::State& state, std::size_t body);

} // namespace demlua::step
