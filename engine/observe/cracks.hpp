// What has come apart.
#pragma once

#include "engine/observe/snapshot.hpp"
#include "engine/state/state.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace demlua::observe {

/// Whether the scene has bonds that can break.
bool can_break(const state::State& state);

std::size_t bond_count(const state::State& state);
std::size_t broken_bond_count(const state::State& state);

/// Sum over broken bonds of the mean diameter of their elements, m.
double crack_length_of(const state::State& state);

/// What breaking them has taken, plastic work and what they still held, J.
double surface_energy_of(const state::State& state);

/// The crack each broken bond belongs to, in the order of state.cracks: the row of its earliest bond. Two broken bonds are
/// of one crack when their facets had an end in common at bonding, or, of pairs, when they share an element.
std::vector<std::int32_t> crack_clusters(const state::State& state);

/// All broken bonds as pieces of crack where and when they arose, in the order of breaking; nothing in a scene whose bonds
/// cannot break.
void add_cracks_to(Snapshot& snapshot, const state::State& state);

/// How many parts there are, of their numbers by element.
std::size_t fragment_count(const std::vector<std::int32_t>& fragment);

} // namespace demlua::observe
