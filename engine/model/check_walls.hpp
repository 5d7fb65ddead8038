// What must hold of walls and outlines.
#pragma once

#include "engine/model/findings.hpp"
#include "engine/model/scene.hpp"

namespace demlua::model {

/// The greatest share of its radius that an element may move in a step where there are walls (step/wall_forces.hpp).
inline constexpr double greatest_move_at_walls = 0.5;

void check_walls(const Scene& scene, Findings& findings);

/// Walls and outlines are read by one kind of name, now.wall.NAME.
void check_wall_names(const Scene& scene, Findings& findings);

} // namespace demlua::model
