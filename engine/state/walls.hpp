// Rigid lines that elements meet, and the elements near enough to touch them before the next search.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/signal.hpp"
#include "engine/base/vec2.hpp"
#include "engine/state/contacts.hpp"
#include "engine/state/corners.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace demlua::state {

/// A wall that moves along an axis so as to press with a given force (step/servo.hpp).
struct Servo {
    Signal force;           ///< to press with, N
    double gain = 0.0;      ///< share of the force that is missing which a step makes up for
    double max_speed = 0.0; ///< m/s
    double travel = 0.0;    ///< how far it may go without meeting anything, m
    double missed = 0.0;    ///< how far it has, m
    double kept = 0.0;      ///< velocity it has learnt to keep, m/s
};

/// What an outline has and a wall has not.
struct Matter {
    std::size_t material = 0;
    double mass = 0.0;                                         ///< kg
    double inertia = 0.0;                                      ///< about the centre of mass, kg m^2
    double friction = std::numeric_limits<double>::infinity(); ///< the most a contact of its corners may have
    std::vector<Corner> corners;                               ///< at the start
};

/// A rigid line, open or closed. With matter it is the outline of a rigid figure, which may move freely.
struct Wall {
    std::string name;
    std::vector<Vec2> path; ///< at the start, m; of a closed one the first point does not come again
    bool closed = false;
    bool seam = false;           ///< in a plane that repeats, whether the path ends where it began, one period on
    Vec2 centre;                 ///< what it turns about, at the start: of mass, where there is matter, m
    double reach = 0.0;          ///< from the centre to its farthest point, m
    std::vector<PairRule> rules; ///< of its contacts, by the elements' material
    std::optional<Matter> matter;

    // How it moves; what neither a signal nor a servo gives is free, and needs matter.
    std::optional<Signal> velocity_x, velocity_y; ///< m/s
    std::optional<Signal> turning;                ///< rad/s
    std::optional<Servo> servo_x, servo_y;        ///< instead of the velocity
    Vec2 presses{1.0, 1.0};                       ///< +1 or -1: towards which side, along x and along y

    std::vector<Vec2> points; ///< the path now, m
    Vec2 offset;              ///< how far the centre has moved, m
    double rotation = 0.0;    ///< counter-clockwise since the start, rad
    Vec2 velocity;            ///< of the half step before the present instant, m/s
    double spin = 0.0;        ///< likewise, rad/s
    Vec2 force;               ///< of elements and outlines on the wall, N
    double moment = 0.0;      ///< likewise, about the centre, N m
    double stiffness = 0.0;   ///< sum of Kn of its contacts that touch, N/m

    [[nodiscard]] std::size_t segments() const { return closed ? path.size() : path.size() - 1; }
    [[nodiscard]] std::size_t parts() const { return path.size() + segments(); }
    /// Where a segment ends, m.
    [[nodiscard]] Vec2 point_after(std::size_t segment) const { return points[(segment + 1) % points.size()]; }
    [[nodiscard]] Vec2 centre_now() const { return centre + offset; }
    /// Of its matter at the place `at`, m/s.
    [[nodiscard]] Vec2 velocity_at(Vec2 at) const { return velocity + spin * turned_left(at - centre_now()); }

    /// Where what stood at `at_start` stands now, m.
    [[nodiscard]] Vec2 place_of(Vec2 at_start) const;

    [[nodiscard]] bool free_x() const { return !velocity_x && !servo_x; }
    [[nodiscard]] bool free_y() const { return !velocity_y && !servo_y; }
    [[nodiscard]] bool free_to_turn() const { return !turning; }
    [[nodiscard]] bool moves_freely() const { return free_x() || free_y() || free_to_turn(); }
    [[nodiscard]] Vec2 weight(Vec2 gravity) const { return matter ? matter->mass * gravity : Vec2{}; }

    /// Points from offset and rotation.
    void place();
};

/// A part of a wall an element can touch: point k of its path (2k), or the segment from there to the next (2k + 1).
/// Rows in rising order of (wall, element, part).
struct WallContacts {
    Column<Index> wall, element, part;
    Column<double> Cn, Ct;
    Column<double> overlap; ///< positive while touching, m
    Column<double> fx, fy;  ///< on the element, N
    Column<double> moment;  ///< on the element, N m
    Column<double> turning; ///< on the wall about its centre, N m
    HistoryColumns<ContactHistory> history;
    StructColumns<law::Spent<double>> spent;
    RollingContacts rolling;   ///< only where contacts of elements roll too
    law::Spent<double> booked; ///< in contacts that are no longer listed

    [[nodiscard]] std::size_t size() const { return wall.size(); }
};

} // namespace demlua::state
