// Boundaries as lists of straight pieces and arcs of circles, and the closed forms over them.
#pragma once

#include "engine/base/vec2.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace demlua::model {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double two_pi = 2.0 * std::numbers::pi;
inline constexpr double parallel = 1e-12; ///< sine of the angle below which directions count as equal

/// A stretch of boundary with the region on its left. A straight piece runs from `begin` to `end` metres
/// along `direction` (either may be infinite); an arc covers the angles from `begin` to `end`, at most a full
/// turn.
struct Piece {
    Vec2 origin;              ///< a point of the line, or the centre of the circle, m
    Vec2 direction;           ///< unit vector; straight pieces only
    double radius = 0.0;      ///< m; 0 for a straight piece
    double begin = 0.0;       ///< m or rad
    double end = 0.0;         ///< m or rad, above `begin`
    bool around_hole = false; ///< an arc whose circle bounds the region from inside

    [[nodiscard]] bool straight() const { return radius == 0.0; }
    [[nodiscard]] bool infinite() const { return std::isinf(begin) || std::isinf(end); }

    [[nodiscard]] Vec2 at(double s) const {
        return straight() ? origin + s * direction : origin + radius * Vec2{std::cos(s), std::sin(s)};
    }

    [[nodiscard]] Vec2 outward(double s) const {
        if (straight()) return -turned_left(direction);
        const Vec2 radial{std::cos(s), std::sin(s)};
        return around_hole ? -radial : radial;
    }

    /// Angle counted on from `begin`, so that it lies on the arc when it does not exceed `end`.
    [[nodiscard]] double angle_from_begin(Vec2 towards) const {
        const double turn = std::fmod(std::atan2(towards.y, towards.x) - begin, two_pi);
        return begin + (turn < 0.0 ? turn + two_pi : turn);
    }

    /// Where along the piece it comes nearest to `point`.
    [[nodiscard]] double nearest(Vec2 point) const {
        if (straight()) return std::clamp(dot(point - origin, direction), begin, end);
        const double angle = angle_from_begin(point - origin);
        if (angle <= end) return angle;
        return angle - end < begin + two_pi - angle ? end : begin;
    }

    [[nodiscard]] double distance(Vec2 point) const { return norm(point - at(nearest(point))); }

    [[nodiscard]] Piece reversed() const {
        Piece other = *this;
        if (straight()) {
            other.direction = -direction;
            other.begin = -end;
            other.end = -begin;
        } else {
            other.around_hole = !around_hole;
        }
        return other;
    }
};

using Pieces = std::vector<Piece>;

Piece straight_piece(Vec2 from, Vec2 to);

/// The point of `pieces` nearest to a place.
struct Foot {
    double distance = infinity;
    double s = 0.0;
    const Piece* piece = nullptr;
};

/// Has no piece where `pieces` is empty.
Foot nearest_foot(const Pieces& pieces, Vec2 point);

/// `piece` cut wherever it meets one of `others`; points within `near` (m) of each other are one.
Pieces cut(const Piece& piece, const Pieces& others, double near);

/// Half the integral of x dy - y dx along a finite piece, about `about`.
double swept_area(const Piece& piece, Vec2 about);

/// What a ray from a point sweeps over as its tip runs along a piece: `area` (m^2) and `moment`, the integral of the
/// place seen from that point (m^3). Summed over a closed boundary: area and first moment of what it encloses.
struct Swept {
    double area = 0.0;
    Vec2 moment;

    Swept& operator+=(const Swept& other) {
        area += other.area;
        moment += other.moment;
        return *this;
    }
};

/// Along a straight line, about the origin.
inline Swept swept_by_chord(Vec2 from, Vec2 to) {
    const double area = 0.5 * cross(from, to);
    return {area, (area / 3.0) * (from + to)};
}

/// Along a finite piece, about `about`. An arc counts as its chord and the segment beyond it, so that a large circle
/// costs no digits.
Swept swept(const Piece& piece, Vec2 about);

// --- boxes -------------------------------------------------------------------------------------------------

inline constexpr Box nothing{{infinity, infinity}, {-infinity, -infinity}};
inline constexpr Box everything{{-infinity, -infinity}, {infinity, infinity}};

/// Widens `box` until it holds `piece`.
void include(Box& box, const Piece& piece);

/// Moves those sides of `box` to infinity towards which `direction` points.
void open_towards(Box& box, Vec2 direction);

/// Angles at which the boundary runs off to infinity, rising.
std::vector<double> angles_of_rays(const Pieces& pieces);

} // namespace demlua::model
