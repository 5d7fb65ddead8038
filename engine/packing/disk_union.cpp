// With u = (cos t, sin t) along an arc c + r u of the boundary, x dy - y dx = r (r + c.u) dt, and over the region
//   area = 1/2 oint (x dy - y dx),   int x dA = 1/3 oint x (x dy - y dx),   int x^2 dA = 1/4 oint x^2 (x dy - y dx),
// since (1/2) x, (1/3) x x and (1/4) x^2 x have divergences 1, x and x^2. Integrals of u and of u u over an arc are
// elementary.
#include "engine/packing/disk_union.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace demlua::packing {
namespace {

using model::Disk;

constexpr double whole = 2.0 * std::numbers::pi;

/// A part of a circle, counter-clockwise, rad.
struct Arc {
    double from;
    double to;
};

/// Moments of a region about the origin.
struct Moments {
    double area = 0.0;
    Vec2 first;          ///< m^3
    double second = 0.0; ///< m^4

    void add(Vec2 centre, double radius, Arc arc);
};

void Moments::add(Vec2 centre, double radius, Arc arc) {
    const double turn = arc.to - arc.from;
    const Vec2 from{std::cos(arc.from), std::sin(arc.from)};
    const Vec2 to{std::cos(arc.to), std::sin(arc.to)};
    const Vec2 u{to.y - from.y, from.x - to.x}; // integral of (cos t, sin t)
    const double skew = 0.5 * (to.x * to.y - from.x * from.y);
    const double xy = 0.5 * (to.y * to.y - from.y * from.y);
    const Vec2 uc{(0.5 * turn + skew) * centre.x + xy * centre.y,
                  xy * centre.x + (0.5 * turn - skew) * centre.y}; // integral of u (u.c)

    const double swept = radius * (radius * turn + dot(centre, u)); // integral of x dy - y dx
    const Vec2 swept_u = radius * (radius * u + uc);                // the same, weighted by u
    area += swept / 2.0;
    first += (swept * centre + radius * swept_u) / 3.0;
    second += ((dot(centre, centre) + radius * radius) * swept + 2.0 * radius * dot(centre, swept_u)) / 4.0;
}

/// Whether disk i lies in disk k; of two that are the same, the later does.
bool hidden(std::span<const Disk> disks, std::size_t i, std::size_t k) {
    const double room = disks[k].radius - disks[i].radius;
    const double distance = norm(disks[k].centre - disks[i].centre);
    return distance < room || (distance == room && (room > 0.0 || k < i));
}

/// Adds the part of the circle of `disk` that lies in `other`, within 0 to a whole turn.
void cover(const Disk& disk, const Disk& other, std::vector<Arc>& covered) {
    const Vec2 between = other.centre - disk.centre;
    const double distance = norm(between);
    if (distance >= disk.radius + other.radius || distance <= disk.radius - other.radius) return;
    const double cosine = (distance * distance + (disk.radius - other.radius) * (disk.radius + other.radius)) /
                          (2.0 * distance * disk.radius);
    const double half = std::acos(std::clamp(cosine, -1.0, 1.0));
    double from = std::atan2(between.y, between.x) - half;
    if (from < 0.0) from += whole;
    const double to = from + 2.0 * half;
    covered.push_back({from, std::min(to, whole)});
    if (to > whole) covered.push_back({0.0, to - whole});
}

} // namespace

Lamina union_of(std::span<const Disk> disks) {
    if (disks.empty()) return {};
    const Vec2 origin = disks.front().centre; // far from the coordinates' origin moments would lose digits
    Moments sum;
    std::vector<Arc> covered;
    for (std::size_t i = 0; i < disks.size(); ++i) {
        covered.clear();
        bool seen = true;
        for (std::size_t k = 0; k < disks.size() && seen; ++k) {
            if (k == i) continue;
            seen = !hidden(disks, i, k);
            if (seen) cover(disks[i], disks[k], covered);
        }
        if (!seen) continue;
        std::sort(covered.begin(), covered.end(), [](Arc a, Arc b) { return a.from < b.from; });
        double passed = 0.0;
        for (const Arc arc : covered) {
            if (arc.from > passed) sum.add(disks[i].centre - origin, disks[i].radius, {passed, arc.from});
            passed = std::max(passed, arc.to);
        }
        if (passed < whole) sum.add(disks[i].centre - origin, disks[i].radius, {passed, whole});
    }
    const Vec2 centroid = sum.first / sum.area;
    return {sum.area, origin + centroid, sum.second - sum.area * dot(centroid, centroid)};
}

} // namespace demlua::packing
