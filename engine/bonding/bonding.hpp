// Who is bonded to whom, and what the bonds are like.
#pragma once

#include "engine/base/period.hpp"
#include "engine/base/vec2.hpp"
#include "engine/law/rayleigh.hpp"
#include "engine/model/scene.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace demlua::bonding {

/// A pair of rows, first below second.
using Pair = std::pair<std::size_t, std::size_t>;

/// Elements whose disks lie closer than `search` times their mean radius, in rising order. Centres and radii in m.
/// Source: Tavarez & Plesha 2007, section 4 and figure 3.
std::vector<Pair> pairs_within(const std::vector<Vec2>& centre, const std::vector<double>& radius, double search);

/// The same where the plane repeats: elements whose nearest images are as close. The period must exceed twice their reach.
std::vector<Pair> pairs_within(const std::vector<Vec2>& centre, const std::vector<double>& radius, double search,
                               Period period);

/// Whether the straight cut from `from` to `to` crosses the line between two centres; touching counts.
bool cut_crosses(Vec2 from, Vec2 to, Vec2 a, Vec2 b);

} // namespace demlua::bonding
