// The order in which a body's bonds stand.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/bonding/bonding.hpp"

#include <cstddef>
#include <vector>

namespace demlua::bonding {

/// Pairs of so many elements that follow each other stand together, before those of the next.
inline constexpr std::size_t run_block = 256;

/// Order of `pairs`, which rise in their first, in which neighbouring rows name neighbouring elements, so that loops over several rows at a time read
/// columns of elements straight: within blocks of elements first everyone's first bond, then everyone's second, and so on;
/// those of one element by direction. Columns of bonds and elements of a block fit a processor's nearest memory together.
std::vector<std::size_t> order_in_runs(const std::vector<Pair>& pairs, const std::vector<Vec2>& centre);

} // namespace demlua::bonding
