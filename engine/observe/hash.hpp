// A fingerprint of a state.
#pragma once

#include "engine/state/state.hpp"

#include <cstdint>

namespace demlua::observe {

/// FNV-1a over the bits of displacements, rotations, velocities and broken bonds.
std::uint64_t hash_of(const state::State& state);

} // namespace demlua::observe
