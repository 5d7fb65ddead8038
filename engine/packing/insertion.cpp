#include "engine/base/problems.hpp"
#include "engine/base/random.hpp"
#include "engine/packing/disk_grid.hpp"
#include "engine/packing/grains.hpp"
#include "engine/packing/growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numbers>

namespace demlua::packing {
namespace {

using model::Disk;

constexpr std::uint64_t tries = 20000; ///< for one grain

bool fits(const model::Region& region, const DiskGrid& grid, const Disk& disk) {
    bool free = true;
    grid.for_each_near(disk.centre, disk.radius, 0.0, [&free](const Disk& /*other*/) { free = false; });
    return free && region.distance(disk.centre) <= -disk.radius;
}

} // namespace

std::vector<Grain> inserted(const model::Region& region, const GrainOrder& order) {
    std::vector<double> sizes = order.sizes.draw(order.count, order.seed);
    std::sort(sizes.begin(), sizes.end(), std::greater<>());
    const Box box = region.bounds();
    DiskGrid grid(box, order.shape.greatest_radius * sizes.front());
    std::vector<Grain> put;
    std::vector<Disk> disks;
    double covered = 0.0;
    std::uint64_t tried = 0;
    const auto find_place = [&](double size) {
        for (const std::uint64_t last = tried + tries; tried < last;) {
            const Vec2 share{uniform(order.seed, across, tried), uniform(order.seed, upwards, tried)};
            const double angle = 2.0 * std::numbers::pi * uniform(order.seed, angles, tried);
            ++tried;
            put.push_back({box.lower + Vec2{share.x * box.size().x, share.y * box.size().y}, angle, size});
            put_disks(order.shape, put.back(), disks);
            if (std::all_of(disks.begin(), disks.end(), [&](const Disk& d) { return fits(region, grid, d); })) {
                return true;
            }
            put.pop_back();
        }
        return false;
    };
    for (const double size : sizes) {
        if (!find_place(size)) {
            throw RunError(
                fmt::format("inserted grains: no place found for grain {} of {} in {} tries, at porosity "
                            "{:.3g}; ask for more porosity or fewer grains, or take \"consolidation\" or \"rain\"",
                            put.size() + 1, sizes.size(), tries, 1.0 - covered / order.region_area));
        }
        covered += order.shape.area * size * size;
        for (const Disk& disk : disks) grid.add(disk);
    }
    return put;
}

} // namespace demlua::packing
