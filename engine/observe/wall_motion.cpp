#include "engine/observe/ledger.hpp"
#include "engine/step/motion.hpp"

#include <algorithm>
#include <utility>
#include <vector>

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

void add_walls_to(Snapshot& snapshot, const state::State& state) {
    if (state.walls.empty()) return;
    std::vector<double> velocity;
    std::vector<double> force;
    std::vector<double> spin;
    std::vector<double> moment;
    for (std::size_t row = 0; row < state.walls.size(); ++row) {
        const state::Wall& wall = state.walls[row];
        snapshot.wall_names.push_back(wall.name);
        snapshot.wall_paths.push_back(wall.points);
        if (wall.closed) snapshot.wall_paths.back().push_back(wall.points.front());
        const WallMotion motion = motion_of_wall(state, row);
        velocity.insert(velocity.end(), {motion.velocity.x, motion.velocity.y});
        force.insert(force.end(), {motion.force.x, motion.force.y});
        spin.push_back(motion.spin);
        moment.push_back(motion.moment);
    }
    snapshot.wall_fields = {{"velocity", "m/s", 2, std::move(velocity)},
                            {"spin", "rad/s", 1, std::move(spin)},
                            {"force", "N", 2, std::move(force)},
                            {"moment", "N m", 1, std::move(moment)}};
}

} // namespace demlua::observe
