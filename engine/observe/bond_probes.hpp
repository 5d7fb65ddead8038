// One bond watched: why it broke, or why it did not.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/observe/snapshot.hpp"
#include "engine/state/state.hpp"

#include <cstddef>
#include <string>

namespace demlua::observe {

struct ProbedBond {
    std::size_t set = 0;  ///< row of state.bond_sets
    std::size_t bond = 0; ///< row of that set
};

/// The bond a probe means, as the elements stand now. Throws SceneError when its body has no bonds, no bond lies within
/// a bond's length of the place asked for, or the elements named are not bonded.
ProbedBond bond_of(const model::BondProbe& probe, const state::State& state);

/// Adds the columns NAME_normal, NAME_shear (forces, N), NAME_stretch and NAME_slide (m); of a law that breaks also
/// NAME_cap_normal and, if there is one, NAME_cap_shear (N), NAME_damage (0 to 1) and NAME_state (0 elastic, 1 yielded, 2
/// broken).
void add_bond_columns(HistoryRow& row, const std::string& name, const state::State& state, ProbedBond probed);

} // namespace demlua::observe
