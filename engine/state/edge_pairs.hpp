// Pairs that lie across the edge of a box that repeats. Bonds are laid as elements stand, so none of these has one.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

#include <cstddef>
#include <vector>

namespace demlua::state {

/// How many pairs of one body's elements, or of one of its clusters, touch by way of the edge: with a gap below `search` of
/// their mean radius, as bonds are laid (bonding/bonding.hpp). None where nothing repeats.
std::size_t pairs_across_edge(const State& state, const Body& body, double search);

/// A problem for each two bodies, or body by itself, that lie in one another across the edge by more than a hundredth of a
/// diameter: they would start with forces nobody asked for.
std::vector<Problem> overlaps_across_edge(const model::Scene& scene, const State& state);

} // namespace demlua::state
