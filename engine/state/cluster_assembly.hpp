// Elements that move together at the start: bodies, clusters, and what wear may take out of these.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

#include <cstddef>

namespace demlua::state {

/// Where a cluster of the body lies on both sides of the edge of a plane that repeats, puts its elements at images beside its first.
void bring_clusters_together(const Body& body, State& state);

/// Gives the elements of body `row` the velocity said, and the spin about their centre of mass.
void set_moving(const model::Body& said, std::size_t row, State& state);

/// Makes body `row`, or each of its clusters, rigid. Clusters have the mass of their elements, and the middle and inertia of the
/// area these cover together; those of one element move on their own.
void make_rigid(const model::Body& said, std::size_t row, State& state);

/// Limits of wear (state/wear.hpp) for clusters of at least two, of materials that wear; nothing where there are none.
void lay_out_wear(const model::Scene& scene, State& state);

/// How many clusters a body has.
std::size_t cluster_count(const State& state, const Body& body);

} // namespace demlua::state
