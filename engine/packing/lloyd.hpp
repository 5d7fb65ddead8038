// Lloyd's method: every element moves to the middle of its cell, again and again, until the cells are even.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"
#include "engine/model/region.hpp"

#include <cstddef>
#include <vector>

namespace demlua::packing {

/// Takes `steps` steps (Lloyd, IEEE Trans. Inf. Theory 28, 129, 1982) with the elements at `centre` (m), which must lie in
/// the bounded `region` and stay there; the first `standing` of them stay where they are. Middles are those of Voronoi
/// cells clipped to the region, weighted with size^-4 where `size` is given: in the plane the cells then come out as large
/// as it asks (Gersho, IEEE Trans. Inf. Theory 25, 373, 1979).
void relax(std::vector<Vec2>& centre, const model::Region& region, const model::Spacing& size, int steps,
           std::size_t standing);

} // namespace demlua::packing
