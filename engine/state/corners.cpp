#include "engine/state/corners.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace demlua::state {

namespace {

constexpr double share_of_side = 0.25;
constexpr double straight = 1e-9; // sine of the turn below which a point is no corner

double twice_area(const std::vector<Vec2>& path) {
    double sum = 0.0;
    for (std::size_t k = 0; k < path.size(); ++k) {
        sum += cross(path[k] - path.front(), path[(k + 1) % path.size()] - path.front());
    }
    return sum;
}

double distance_to_side(Vec2 a, Vec2 b, Vec2 point) {
    const double along = std::clamp(dot(point - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    return norm(point - (a + along * (b - a)));
}

double room_at(const std::vector<Vec2>& path, Vec2 point) {
    double least = distance_to_side(path.back(), path.front(), point);
    for (std::size_t k = 1; k < path.size(); ++k) {
        least = std::min(least, distance_to_side(path[k - 1], path[k], point));
    }
    return least;
}

} // namespace

std::vector<Corner> corners_of_path(const std::vector<Vec2>& path, double rounding) {
    constexpr double rounding_error = 1e-9;
    const double sense = twice_area(path) > 0.0 ? 1.0 : -1.0;
    const std::size_t n = path.size();
    std::vector<Corner> corners;
    for (std::size_t k = 0; k < n; ++k) {
        const Vec2 here = path[k];
        const Vec2 back = path[(k + n - 1) % n] - here;
        const Vec2 on = path[(k + 1) % n] - here;
        const Vec2 u = back / norm(back);
        const Vec2 v = on / norm(on);
        const double turn = sense * cross(v, u);
        const double cosine = dot(u, v);
        // Of the two forms of the bisector the one that loses no digits.
        const Vec2 inwards = cosine > 0.0 ? (turn > 0.0 ? 1.0 : -1.0) * (u + v) : sense * turned_left(v - u);
        const double sine = std::sqrt(0.5 * (1.0 - cosine));
        const double tangent = sine / std::sqrt(0.5 * std::max(1.0 + cosine, 0.0));
        double radius = std::min(rounding, tangent * share_of_side * std::min(norm(back), norm(on)));
        const auto centre = [&] { return here + (radius / (sine * norm(inwards))) * inwards; };
        while (room_at(path, centre()) < (1.0 - rounding_error) * radius) radius *= 0.5;
        corners.push_back({centre(), radius, turn > straight});
    }
    return corners;
}

} // namespace demlua::state
