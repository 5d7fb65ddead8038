// Rules on what breaks: strength and toughness, the size of elements that bonds can resolve, notches.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/model/scene.hpp"

#include <optional>
#include <vector>

namespace demlua::model {

/// Problems with what breaks that can be seen without packing.
std::vector<Problem> fracture_problems(const Scene& scene);

/// The problem of a body whose largest bond is too large for its law to run its course, if it is; `size`, in m, is the mean
/// radius of the bond's elements, or the length of the bond where `network` is facets. The body's material must say what
/// its bonds need.
std::optional<Problem> unresolved_bonds(const Scene& scene, const Body& body, Network network, double size);

} // namespace demlua::model
