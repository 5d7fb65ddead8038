// Rigid clusters of disks, grown inside a region until they press against each other and against its boundary
// (Tavarez & Plesha 2007, section 4; growing inside fixed walls is pressing walls inward, seen in other
// units).
#include "engine/base/problems.hpp"
#include "engine/packing/growth.hpp"
#include "engine/packing/lloyd.hpp"
#include "engine/packing/numbering.hpp"
#include "engine/packing/packing.hpp"
#include "engine/packing/spreading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

namespace demlua::packing {
namespace {

// Overlaps are in radii throughout. The figures below were found by trial on packs of 1 to 12,000 elements.
constexpr double final_overlap = 0.03;  ///< the pack is done once no overlap exceeds this
constexpr double largest_overlap = 0.1; ///< above this it is no pack
constexpr int final_moves = 350;        ///< in one attempt at the end
constexpr int attempts = 60;            ///< with a squeeze and a shake before each but the first
constexpr double squeeze = 0.12;        ///< by which radii are too large for a while, as a share
constexpr double shake = 1.0;           ///< farthest that a shake throws a cluster along each axis
constexpr double fading = 0.95;         ///< strength of a squeeze and shake over that of the one before
constexpr double setback = 0.05;        ///< a shake that makes the largest overlap grow by more is undone
constexpr int squeeze_moves = 100;      ///< how long a squeeze lasts
constexpr double shrinking = 0.005;     ///< steps of the radius when looking for what does fit, as a share
constexpr int most_shrinks = 100;       ///< after which the search ends

/// Radius of the circle around a cluster, in radii of its disks.
double circle_around(const std::vector<Vec2>& shape) {
    double farthest = 0.0;
    for (const Vec2 p : shape) farthest = std::max(farthest, norm(p));
    return 1.0 + farthest;
}

double bounded_area(const model::Region& region) {
    const double area = region.area();
    if (std::isfinite(area)) return area;
    throw RunError("a consolidated pack needs a bounded region; cut the half-plane with a rectangle");
}

std::size_t cluster_count(double area, const Consolidation& settings) {
    const auto size = static_cast<std::size_t>(settings.cluster);
    if (settings.count > 0) return (settings.count + size - 1) / size;
    if (!(settings.radius > 0.0)) return 0;
    const double disks = settings.solid_fraction * area / (std::numbers::pi * settings.radius * settings.radius);
    return static_cast<std::size_t>(disks * (1.0 + 1e-12)) / size;
}

/// Settles a pack grown to `radius` and returns the largest overlap left. A pack that has jammed is squeezed, shaken
/// and let go, which rearranges it and keeps it from ordering. A shake may also lock clusters into each other or
/// push one astride a thin wall; then it did not happen.
double press(Growth& pack, double radius, std::uint64_t seed) {
    double left = pack.settle(final_overlap, final_moves);
    std::size_t torn = pack.torn_pairs();
    double strength = 1.0;
    for (std::uint64_t k = 1; k < attempts && left > final_overlap; ++k, strength *= fading) {
        const std::vector<Motion> before = pack.places();
        pack.grow_to((1.0 + strength * squeeze) * radius);
        pack.throw_about(strength * shake * radius, seed, k);
        pack.settle(0.0, squeeze_moves);
        pack.grow_to(radius);
        const double now = pack.settle(final_overlap, final_moves);
        const std::size_t torn_now = pack.torn_pairs();
        if (now > left + setback || torn_now > torn) {
            pack.put_back(before);
        } else {
            left = now;
            torn = torn_now;
        }
    }
    return left;
}

/// Shrinks a pack until it fits and says what it came to.
[[noreturn]] void report_jam(Growth& pack, double left, double solid_fraction) {
    const double wanted = pack.radius();
    for (int k = 0; k < most_shrinks && pack.settle(growing_overlap, final_moves) > growing_overlap; ++k) {
        pack.grow_to((1.0 - shrinking) * pack.radius());
    }
    const double share = pack.radius() / wanted;
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(),
                  "consolidated pack: at solid fraction %.3g elements overlap by up to %.2g radii; "
                  "about %.3g fits; lower solid_fraction or take smaller clusters or more elements",
                  solid_fraction, left, solid_fraction * share * share);
    throw RunError(text.data());
}

Packing numbered(const std::vector<Vec2>& disks, std::size_t cluster, const Box& box, double radius, double area) {
    constexpr Index none = std::numeric_limits<Index>::max();
    std::vector<Index> number(disks.size() / cluster, none);
    Index clusters = 0;
    Packing packing;
    for (const std::size_t k : order_by_bands(disks, box, 4.0 * radius)) {
        Index& mine = number[k / cluster];
        if (mine == none) mine = clusters++;
        packing.centre.push_back(disks[k]);
        packing.cluster.push_back(mine);
    }
    packing.radius.assign(disks.size(), radius);
    packing.cell_area.assign(disks.size(), area / static_cast<double>(disks.size()));
    return packing;
}

} // namespace

double consolidated_radius(const model::Region& region, const Consolidation& settings) {
    if (settings.count == 0) return settings.radius;
    const double area = bounded_area(region);
    const std::size_t count = cluster_count(area, settings) * static_cast<std::size_t>(settings.cluster);
    return std::sqrt(settings.solid_fraction * area / (std::numbers::pi * static_cast<double>(count)));
}

Packing consolidated(const model::Region& region, const Consolidation& settings) {
    const std::vector<Vec2> shape = cluster_shape(settings.cluster);
    const double area = bounded_area(region);
    const std::size_t clusters = cluster_count(area, settings);
    const double radius = consolidated_radius(region, settings);
    if (clusters == 0 || !(radius > 0.0)) return {};

    const double around = circle_around(shape);
    const Middles middles = spread(region, area, clusters, around * radius, settings.seed);
    Growth pack(region, shape, clusters, radius);
    pack.put_down(middles.at, middles.circle / around, settings.seed);
    grow(pack, radius);
    const double left = press(pack, radius, settings.seed);
    if (left > largest_overlap) report_jam(pack, left, settings.solid_fraction);
    std::vector<Vec2> disks = pack.disks();
    relax(disks, region, {}, settings.relax, 0);
    return numbered(disks, shape.size(), region.bounds(), radius, area);
}

} // namespace demlua::packing
