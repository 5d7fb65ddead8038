// What tests of rigid figures start from.
#pragma once

#include "tests/grain_scenes.hpp"

#include <string>
#include <utility>
#include <vector>

namespace demlua::test {

/// Corners of a rectangle, turned about its centre, rad.
inline std::vector<Vec2> box(Vec2 centre, Vec2 size, double angle = 0.0) {
    const Vec2 h = 0.5 * size;
    std::vector<Vec2> corners{{-h.x, -h.y}, {h.x, -h.y}, {h.x, h.y}, {-h.x, h.y}};
    for (Vec2& corner : corners) corner = centre + turned(corner, angle);
    return corners;
}

inline model::Outline rounded_outline(const std::string& name, std::vector<Vec2> path) {
    model::Outline made;
    made.name = name;
    made.path = std::move(path);
    made.rounding = 4e-3;
    return made;
}

/// Something soft enough for a few thousand steps, and the one element that a scene needs, held far from all that happens.
inline model::Scene soft_scene(double restitution, double friction, Vec2 far) {
    model::Scene scene = scene_of(bouncing(restitution, friction));
    scene.materials[0].youngs_modulus = 1e8;
    scene.bodies.push_back(disks("far", {{far, 5e-3}}, model::NoBonds{}));
    model::Support held;
    held.selection = all_of(0);
    scene.supports.push_back(held);
    return scene;
}

} // namespace demlua::test
