// Which freedoms of the elements are held, for solutions that need to know it beforehand.
#pragma once

#include "engine/state/state.hpp"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace demlua::step {

/// One entry per freedom: x, y, rotation of every element of the scene.
struct Held {
    std::vector<std::uint8_t> is;
    Eigen::VectorXd jump; ///< from where it stands to where it is held, m or rad; zero where free
};

/// By the drives of the state at its present instant: velocities are taken as zero. Later drives prevail.
Held held_freedoms(const state::State& state);

/// Parts of the scene that could still move as a whole: fewer than three independent freedoms of theirs are held.
std::vector<std::vector<std::size_t>> floating_parts(const state::State& state, const Held& held);

} // namespace demlua::step
