// Lists, for each element, the pairs it takes part in, so that forces on an element are summed in one fixed order.
#pragma once

#include "engine/state/bonds.hpp"

#include <cstddef>

namespace demlua::state {

/// Pairs (i[k], j[k]) over elements `first` to `first + count`; entries of an element in rising order of pairs.
Incidence incidence_of(const Column<Index>& i, const Column<Index>& j, std::size_t first, std::size_t count);

} // namespace demlua::state
