// What has come apart.
#pragma once

#include "engine/state/state.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace demlua::observe {

std::size_t bond_count(const state::State& state);
std::size_t broken_bond_count(const state::State& state);

/// Sum over broken bonds of the mean diameter of their elements, m.
double crack_length_of(const state::State& state);

/// How many parts there are, of their numbers by element.
std::size_t fragment_count(const std::vector<std::int32_t>& fragment);

} // namespace demlua::observe
