#include "engine/step/wall_parts.hpp"

#include <algorithm>

namespace demlua::step {

namespace {

/// Where the foot of `centre` lies along the segment from a to b: 0 at a, 1 at b.
double foot(Vec2 a, Vec2 b, Vec2 centre) { return dot(centre - a, b - a) / dot(b - a, b - a); }

WallGap gap_from(Vec2 nearest, Vec2 centre, bool meets) {
    const Vec2 between = centre - nearest;
    const double distance = norm(between);
    return {meets, distance > 0.0 ? between / distance : Vec2{}, distance};
}

} // namespace

Vec2 seen_from(const state::Wall& wall, std::size_t part, Vec2 centre, Period period) {
    if (!period.repeats()) return centre;
    const std::size_t k = part / 2;
    const Vec2 middle = part % 2 == 0 ? wall.points[k] : 0.5 * (wall.points[k] + wall.point_after(k));
    return middle + period.shortest(centre - middle);
}

std::vector<Vec2> shifts_to_images(Vec2 between, Period period) {
    if (!period.repeats()) return {Vec2{}};
    const Vec2 nearest = between - period.shortest(between);
    const Vec2 next{period.length, 0.0};
    return {nearest, nearest - next, nearest + next};
}

WallGap wall_gap(const state::Wall& wall, std::size_t part, Vec2 centre) {
    const std::size_t k = part / 2;
    const Vec2 a = wall.points[k];
    if (part % 2 == 1) {
        const Vec2 b = wall.point_after(k);
        const double along = foot(a, b, centre);
        return gap_from(a + along * (b - a), centre, along > 0.0 && along < 1.0);
    }
    const std::size_t n = wall.points.size();
    if (wall.seam && k + 1 == n) return {};
    const bool first = k == 0 && !wall.closed;
    const Vec2 previous =
        first && wall.seam ? wall.points[n - 2] + (a - wall.points[n - 1]) : wall.points[(k + n - 1) % n];
    const bool past_previous = (first && !wall.seam) || foot(previous, a, centre) >= 1.0;
    const bool before_next = (k + 1 == n && !wall.closed) || foot(a, wall.point_after(k), centre) <= 0.0;
    return gap_from(a, centre, past_previous && before_next);
}

bool are_neighbours(const state::Wall& wall, std::size_t part, std::size_t other) {
    const std::size_t apart = part > other ? part - other : other - part;
    // The last point of a wall with a seam is its first.
    const std::size_t round = wall.closed ? wall.parts() : wall.parts() - 1;
    const bool goes_round = wall.closed || wall.seam;
    return apart <= 2 || (goes_round && round - apart <= 2);
}

bool is_inside(const state::Wall& outline, Vec2 point) {
    bool inside = false;
    for (std::size_t k = 0; k < outline.points.size(); ++k) {
        const Vec2 a = outline.points[k];
        const Vec2 b = outline.point_after(k);
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

double distance_to_part(const state::Wall& wall, std::size_t part, Vec2 centre) {
    const std::size_t k = part / 2;
    const Vec2 a = wall.points[k];
    if (part % 2 == 0) return norm(centre - a);
    const Vec2 b = wall.point_after(k);
    return norm(centre - (a + std::clamp(foot(a, b, centre), 0.0, 1.0) * (b - a)));
}

} // namespace demlua::step
