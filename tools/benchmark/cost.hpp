// What one step asks of a machine, per element.
#pragma once

#include "engine/state/state.hpp"

namespace demlua::bench {

/// Per element and step, at least: every line of memory that a step reads is fetched once and every line it writes is given
/// back once, as if its loops were one and everything that one of them leaves to the next stayed near.
struct Cost {
    double bytes = 0.0;      ///< moved
    double footprint = 0.0;  ///< bytes, of the memory that is touched
    double operations = 0.0; ///< sums, products, comparisons
    double divisions = 0.0;  ///< and square roots
};

/// Bonds between pairs, sums and motion are counted by running their kernels (counting_lane.hpp) over the first rows of
/// `state`, which is spoilt by that. The loops over facets and contacts know no lanes: the columns they name are counted,
/// their operations are counted by hand. Walls and the search are left out.
Cost cost_of(state::State& state);

} // namespace demlua::bench
