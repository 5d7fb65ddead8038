#include "engine/observe/ledger.hpp"
#include "engine/step/motion.hpp"

#include <algorithm>

namespace demlua::observe {

namespace {

/// Height and width of the path as it stands now, m.
Vec2 faces_of(const state::Wall& wall) {
    Box box{wall.points.front(), wall.points.front()};
    for (const Vec2 p : wall.points) {
        box.lower = {std::min(box.lower.x, p.x), std::min(box.lower.y, p.y)};
        box.upper = {std::max(box.upper.x, p.x), std::max(box.upper.y, p.y)};
    }
    return {box.size().y, box.size().x};
}

} // namespace

WallMotion motion_of_wall(const state::State& state, std::size_t row) {
    const state::Wall& wall = state.walls.at(row);
    WallMotion motion{
        wall.centre_now(), wall.velocity, wall.rotation, wall.spin, wall.force, wall.moment, {}, 0.0, 0.0};
    const Vec2 faces = state.thickness * faces_of(wall);
    if (faces.x > 0.0) motion.stress.x = -wall.presses.x * wall.force.x / faces.x;
    if (faces.y > 0.0) motion.stress.y = -wall.presses.y * wall.force.y / faces.y;
    if (!wall.matter) return motion;
    motion.mass = wall.matter->mass;
    motion.inertia = wall.matter->inertia;
    const step::Kick kicked(state.alpha, state.dt);
    const auto now = [&](double v, double force, double mass) { return 0.5 * (v + kicked(v, force, 1.0 / mass)); };
    const Vec2 force = wall.force + wall.weight(state.gravity);
    if (wall.free_x()) motion.velocity.x = now(wall.velocity.x, force.x, motion.mass);
    if (wall.free_y()) motion.velocity.y = now(wall.velocity.y, force.y, motion.mass);
    if (wall.free_to_turn()) motion.spin = now(wall.spin, wall.moment, motion.inertia);
    return motion;
}

} // namespace demlua::observe
