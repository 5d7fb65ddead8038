#include "engine/step/wall_motion.hpp"

#include "engine/base/problems.hpp"
#include "engine/step/servo.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace demlua::step {

namespace {

/// Power of the forces on a wall in the ways in which its motion is given, W.
double power_taken(const state::Wall& wall, Vec2 gravity) {
    const Vec2 force = wall.force + wall.weight(gravity);
    double power = 0.0;
    if (!wall.free_x()) power += force.x * wall.velocity.x;
    if (!wall.free_y()) power += force.y * wall.velocity.y;
    if (!wall.free_to_turn()) power += wall.moment * wall.spin;
    return power;
}

/// Kicks one freedom that is free; books what mass damping spends.
void kick(state::State& state, double& velocity, double force, double mass) {
    const double before = velocity;
    velocity = Kick(state.alpha, state.dt)(velocity, force, 1.0 / mass);
    const double mean = 0.5 * (before + velocity);
    state.booked.mass_damping += state.alpha * state.dt * mass * mean * mean;
}

/// What a wall with a servo touches.
Met met_by(const state::State& state, const state::Wall& wall) {
    Met met{wall.stiffness, 0.0};
    if (!wall.servo_x && !wall.servo_y) return met;
    const state::WallContacts& contacts = state.wall_contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (contacts.overlap[c] > 0.0 && &state.walls[contacts.wall[c]] == &wall) met.C += contacts.Cn[c];
    }
    for (const state::OutlineContact& row : state.outline_contacts.rows) {
        if (row.overlap > 0.0 && &state.walls[row.wall] == &wall) met.C += row.damped;
    }
    return met;
}

void set_velocity(state::State& state, state::Wall& wall) {
    const Met met = met_by(state, wall);
    const double middle = state.time + 0.5 * state.dt;
    const auto given = [&](std::optional<state::Servo>& servo, const std::optional<Signal>& velocity, double side,
                           double force) {
        if (servo) return seek_force(*servo, side, force, met, middle, state.dt);
        return velocity->at(middle);
    };
    const Vec2 force = wall.force + wall.weight(state.gravity);
    if (wall.free_x()) {
        kick(state, wall.velocity.x, force.x, wall.matter->mass);
    } else {
        wall.velocity.x = given(wall.servo_x, wall.velocity_x, wall.presses.x, wall.force.x);
    }
    if (wall.free_y()) {
        kick(state, wall.velocity.y, force.y, wall.matter->mass);
    } else {
        wall.velocity.y = given(wall.servo_y, wall.velocity_y, wall.presses.y, wall.force.y);
    }
    if (wall.free_to_turn()) {
        kick(state, wall.spin, wall.moment, wall.matter->inertia);
    } else {
        wall.spin = wall.turning->at(middle);
    }
}

void check_speed(const state::State& state, const state::Wall& wall, double moved, const TravelLimit& limit) {
    if (moved <= limit.share * limit.smallest_radius) return;
    const bool corner = limit.smallest_radius == state.outline_contacts.smallest_corner;
    throw RunError(fmt::format("{} \"{}\" moved at ({:.6g}, {:.6g}) m/s and {:.6g} rad/s in step {} (t = {:.6g} s): "
                               "more than {:.3g} of the smallest {} {:.4g} m in one step of {:.4g} s",
                               wall.matter ? "outline" : "wall", wall.name, wall.velocity.x, wall.velocity.y, wall.spin,
                               state.step, state.time, limit.share, corner ? "rounding of a corner" : "radius",
                               limit.smallest_radius, state.dt));
}

void check_servo(const state::State& state, const state::Wall& wall, const std::optional<state::Servo>& servo) {
    if (!servo || servo->missed <= servo->travel) return;
    throw RunError(
        fmt::format("wall \"{}\" has met nothing on its way of {:.4g} m by servo (t = {:.6g} s); is it on the "
                    "right side, and are there elements in its way? A longer way is said by servo.travel",
                    wall.name, servo->missed, state.time));
}

} // namespace

void book_wall_work(state::State& state) {
    for (const state::Wall& wall : state.walls) {
        state.booked.walls -= 0.5 * state.dt * power_taken(wall, state.gravity);
    }
}

double move_walls(state::State& state, const TravelLimit& limit) {
    for (state::Wall& wall : state.walls) set_velocity(state, wall);
    book_wall_work(state);
    double farthest = 0.0;
    const TravelLimit tight{limit.share, std::min(limit.smallest_radius, state.outline_contacts.smallest_corner)};
    for (state::Wall& wall : state.walls) {
        const double moved = state.dt * (norm(wall.velocity) + std::fabs(wall.spin) * wall.reach);
        check_speed(state, wall, moved, tight);
        check_servo(state, wall, wall.servo_x);
        check_servo(state, wall, wall.servo_y);
        wall.offset += state.dt * wall.velocity;
        wall.rotation += state.dt * wall.spin;
        wall.place();
        farthest = std::max(farthest, moved);
    }
    return farthest;
}

} // namespace demlua::step
