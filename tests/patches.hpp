// Patches of a rectangle that begins at the origin.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"
#include "engine/state/state.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace demlua::test {

/// Displacements and rotations of all elements under the uniform strain (xx, yy, xy) about the origin.
inline Eigen::VectorXd strained(const state::State& state, const Eigen::Vector3d& strain) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * state.elements.size()));
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        const Vec2 at = state.elements.position(k);
        const auto row = static_cast<Eigen::Index>(3 * k);
        u[row] = strain[0] * at.x + strain[2] * at.y;
        u[row + 1] = strain[2] * at.x + strain[1] * at.y;
    }
    return u;
}

/// An irregular pack of `count` elements, some of them on the two upright sides of the rectangle, none on the long ones.
inline model::Relaxation relaxed_between(Vec2 size, std::uint64_t count, std::uint64_t seed, int steps) {
    const double reach = 1e-3 * size.x;
    const model::Region side = model::Region::rectangle({-reach, -reach}, {2.0 * reach, size.y + 2.0 * reach});
    model::Relaxation relaxed;
    relaxed.count = count;
    relaxed.steps = steps;
    relaxed.seed = seed;
    relaxed.on_boundary = true;
    relaxed.boundary_within = side.united(side.translated({size.x, 0.0}));
    return relaxed;
}

/// Distance to the nearest side of a rectangle of this size.
inline double depth_in(Vec2 size, Vec2 at) { return std::min({at.x, size.x - at.x, at.y, size.y - at.y}); }

} // namespace demlua::test
