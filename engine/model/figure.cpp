#include "engine/model/figure.hpp"

#include "engine/model/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace demlua::model {

namespace {

/// The sides of a region one after another; fewer corners than sides where they do not make one ring.
std::vector<Vec2> ring_of(const Pieces& sides, double near) {
    std::vector<Vec2> corners;
    if (sides.empty()) return corners;
    std::vector<bool> taken(sides.size(), false);
    std::size_t at = 0;
    while (!taken[at]) {
        taken[at] = true;
        corners.push_back(sides[at].at(sides[at].begin));
        const Vec2 end = sides[at].at(sides[at].end);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            if (norm(sides[k].at(sides[k].begin) - end) > near) continue;
            at = k;
            break;
        }
    }
    return corners;
}

double nearness(const Region& region) { return 1e-9 * norm(region.bounds().size()); }

std::string region_fault(const Region& region) {
    const Box box = region.bounds();
    if (box.empty()) return "is empty";
    if (!std::isfinite(norm(box.size()))) return "must have an end on all sides";
    const Pieces& sides = region.boundary();
    if (!std::all_of(sides.begin(), sides.end(), [](const Piece& side) { return side.straight(); })) {
        return "must have straight sides; say a curved one by as many corners of a path as it needs";
    }
    if (ring_of(sides, nearness(region)).size() != sides.size()) return "must be in one piece and without holes";
    return {};
}

} // namespace

Figure figure_of(const std::vector<Vec2>& corners) {
    // From the first corner, so that a figure far from the origin costs no digits.
    const Vec2 origin = corners.front();
    Swept sum;
    double polar = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 a = corners[k] - origin;
        const Vec2 b = corners[(k + 1) % corners.size()] - origin;
        sum += swept_by_chord(a, b);
        polar += cross(a, b) * (dot(a, a) + dot(a, b) + dot(b, b)) / 12.0;
    }
    const Vec2 centre = sum.moment / sum.area;
    return {std::fabs(sum.area), origin + centre, std::fabs(polar) - std::fabs(sum.area) * dot(centre, centre)};
}

std::vector<Vec2> without_return(std::vector<Vec2> path) {
    // A circle's points by sine and cosine come back to where they began to rounding only.
    constexpr double same_place = 1e-12;
    double extent = 0.0;
    for (const Vec2 point : path) extent = std::max(extent, norm(point - path.front()));
    if (path.size() > 1 && norm(path.back() - path.front()) <= same_place * extent) path.pop_back();
    return path;
}

std::string outline_fault(const Outline& outline) {
    const bool has_region = !outline.region.bounds().empty();
    if (outline.path.empty() != has_region) return "exactly one of path and region must be given";
    return has_region ? region_fault(outline.region) : polygon_fault(without_return(outline.path));
}

std::vector<Vec2> corners_of(const Outline& outline) {
    if (!outline.path.empty()) return without_return(outline.path);
    return ring_of(outline.region.boundary(), nearness(outline.region));
}

std::vector<Vec2> sawtooth(Vec2 from, Vec2 to, double height, double pitch) {
    const Vec2 way = to - from;
    const double length = norm(way);
    const Vec2 rise = (height / length) * turned_left(way);
    const auto teeth = static_cast<std::size_t>(std::max(std::round(length / pitch), 1.0));
    const auto at = [&](double tooth) { return from + (tooth / static_cast<double>(teeth)) * way; };
    std::vector<Vec2> points{from};
    for (std::size_t tooth = 1; tooth <= teeth; ++tooth) {
        points.push_back(at(static_cast<double>(tooth) - 0.5) + rise);
        points.push_back(tooth == teeth ? to : at(static_cast<double>(tooth)));
    }
    return points;
}

} // namespace demlua::model
