// Pairs that lie across the edge of a box that repeats, which bonds do not reach.
#pragma once

#include "engine/state/state.hpp"

#include <cstddef>

namespace demlua::state {

/// How many pairs of one body's elements, or of one of its clusters, touch by way of the edge: with a gap below `search` of
/// their mean radius, as bonds are laid (bonding/bonding.hpp). None where nothing repeats.
std::size_t pairs_across_edge(const State& state, const Body& body, double search);

} // namespace demlua::state
