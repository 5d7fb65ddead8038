// From a checked scene to a state ready to step.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/packing/pack_store.hpp"
#include "engine/state/state.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace demlua::state {

struct Assembly {
    State state;
    std::vector<std::string> notes; ///< what a reader should know of the pack, one sentence each
};

/// Packs every body, shares out mass, bonds, and lays out walls and materials. Notches, supports and loads are not taken
/// in here. Throws SceneError naming every body whose region holds no element and every pair of bodies that overlap.
/// Packs come from `packs` if it is given and has them.
Assembly assemble(const model::Scene& scene, const packing::PackStore* packs = nullptr);

} // namespace demlua::state
