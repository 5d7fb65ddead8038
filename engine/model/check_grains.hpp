// Rules between the settings of clusters and grains.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/model/scene.hpp"

#include <vector>

namespace demlua::model {

/// What is wrong with a cluster, without its place.
std::vector<Problem> cluster_problems(const Cluster& cluster);

/// What is wrong with how a body's grains are asked for.
std::vector<Problem> grain_problems(const Body& body, const GrainPacking& packing);

/// What is wrong with a body whose clusters are to be held together one by one, or with elements being taken out of it.
std::vector<Problem> cluster_problems(const Body& body);

} // namespace demlua::model
