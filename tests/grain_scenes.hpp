// What tests of grains and walls start from.
#pragma once

#include "tests/scenes.hpp"

#include <string>
#include <utility>
#include <vector>

namespace demlua::test {

/// The concrete of scenes.hpp with a restitution and a friction of its own.
inline model::Material bouncing(double restitution, double friction) {
    model::Material material = concrete();
    material.restitution = restitution;
    material.friction = friction;
    return material;
}

inline model::Wall wall_along(const std::string& name, std::vector<Vec2> path) {
    model::Wall wall;
    wall.name = name;
    wall.path = std::move(path);
    return wall;
}

} // namespace demlua::test
