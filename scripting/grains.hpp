// What is said of grains, on its way into the scene.
#pragma once

#include "engine/model/settings.hpp"
#include "scripting/read.hpp"

namespace demlua::scripting {

/// One size, two between which sizes spread evenly, or a list of classes.
void read_sizes(const Value& value, const model::Slot& slot, std::vector<model::SizeClass>& sizes);

/// Disks, all with a cluster or none; clusters are numbered anew in the order in which they come.
void read_listed(const Value& value, const model::Slot& slot, model::ListedDisks& listed);

/// The body that sim:grains makes.
model::Body body_of(const model::GrainsSaid& said);

} // namespace demlua::scripting
