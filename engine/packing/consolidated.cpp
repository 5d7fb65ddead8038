// Rigid clusters of disks, grown inside a region until they press against each other and against its boundary
// (Tavarez & Plesha 2007, section 4; growing inside fixed walls is pressing walls inward, seen in other
// units).
#include "engine/base/problems.hpp"
#include "engine/packing/growth.hpp"
#include "engine/packing/lloyd.hpp"
#include "engine/packing/numbering.hpp"
#include "engine/packing/packing.hpp"
#include "engine/packing/pressing.hpp"
#include "engine/packing/spreading.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace demlua::packing {
namespace {

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

[[noreturn]] void report_jam(Growth& pack, double left, double solid_fraction) {
    const double fits = fitting_share(pack);
    throw RunError(fmt::format("consolidated pack: at solid fraction {:.3g} elements overlap by up to {:.2g} radii; "
                               "about {:.3g} fits; lower solid_fraction or take smaller clusters or more elements",
                               solid_fraction, left, solid_fraction * fits * fits));
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
    const std::vector<model::Disk> shape = cluster_shape(settings.cluster);
    const double area = bounded_area(region);
    const std::size_t clusters = cluster_count(area, settings);
    const double radius = consolidated_radius(region, settings);
    if (clusters == 0 || !(radius > 0.0)) return {};

    const std::vector<double> equal(clusters, 1.0);
    const double around = circle_around(shape);
    const Middles middles = spread(region, area, equal, around * radius, settings.seed);
    Growth pack(region, shape, equal, radius);
    pack.put_down(middles.at, middles.circle / around, settings.seed);
    grow(pack, radius);
    const double left = press(pack, radius, settings.seed);
    if (left > largest_overlap) report_jam(pack, left, settings.solid_fraction);
    std::vector<Vec2> disks = pack.disks();
    relax(disks, region, {}, settings.relax, 0);
    return numbered(disks, shape.size(), region.bounds(), radius, area);
}

} // namespace demlua::packing
