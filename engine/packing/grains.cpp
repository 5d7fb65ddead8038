#include "engine/packing/grains.hpp"

#include "engine/base/problems.hpp"
#include "engine/packing/growth.hpp"
#include "engine/packing/numbering.hpp"
#include "engine/packing/pressing.hpp"
#include "engine/packing/spreading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace demlua::packing {

using model::Disk;

namespace {

// Grains that touch more than they must would jump apart.
constexpr double loose_overlap = 1e-3; ///< radii, that a pack with room to spare comes down to
constexpr int loose_moves = 2000;

double bounded_area(const model::Region& region) {
    const double area = region.area();
    if (std::isfinite(area)) return area;
    throw RunError("grains need a bounded region; cut the half-plane with a rectangle");
}

/// Grains at once, grown and pressed.
std::vector<Grain> pressed(const model::Region& region, const GrainOrder& order) {
    const GrainShape& shape = order.shape;
    const double unit = order.sizes.mean();
    std::vector<double> relative = order.sizes.draw(order.count, order.seed);
    double covered = 0.0;
    for (double& size : relative) {
        covered += shape.area * size * size;
        size /= unit;
    }
    const Middles middles = spread(region, order.region_area, relative, shape.around * unit, order.seed);
    Growth pack(region, shape.disks, relative, unit);
    pack.put_down(middles.at, middles.circle / shape.around, order.seed);
    grow(pack, unit);
    press(pack, unit, order.seed);
    const double left = pack.settle(loose_overlap, loose_moves);
    if (left > largest_overlap) {
        const double fits = fitting_share(pack);
        throw RunError(
            fmt::format("consolidated grains: at porosity {:.3g} elements overlap by up to {:.2g} radii; about "
                        "{:.3g} can be reached; raise porosity or take smaller grains",
                        1.0 - covered / order.region_area, left, 1.0 - fits * fits * covered / order.region_area));
    }
    std::vector<Grain> put;
    for (std::size_t k = 0; k < relative.size(); ++k) {
        put.push_back({pack.places()[k].shift, pack.angle(k), unit * relative[k]});
    }
    return put;
}

/// How many grains cover `solid_area`, the mean of their areas being what it is.
std::size_t count_for(const GrainOrder& order) {
    return static_cast<std::size_t>(std::llround(order.solid_area / (order.shape.area * order.sizes.mean_square())));
}

std::vector<Grain> put_down(const model::Region& region, GrainOrder order, model::Placing method) {
    if (method == model::Placing::rain) return rained(region, order);
    if (order.count == 0) order.count = count_for(order);
    if (order.count == 0) return {};
    return method == model::Placing::insertion ? inserted(region, order) : pressed(region, order);
}

Packing packing_of(const std::vector<Grain>& put, const GrainShape& shape, const Box& box) {
    Packing packing;
    if (put.empty()) return packing;
    std::vector<Vec2> at;
    double sum = 0.0;
    for (const Grain& grain : put) {
        at.push_back(grain.at);
        sum += shape.around * grain.size;
    }
    double squares = 0.0;
    for (const Disk& disk : shape.disks) squares += disk.radius * disk.radius;
    std::vector<Disk> disks;
    Index cluster = 0;
    for (const std::size_t k : order_by_bands(at, box, 4.0 * sum / static_cast<double>(put.size()))) {
        put_disks(shape, put[k], disks);
        for (const Disk& disk : disks) {
            packing.centre.push_back(disk.centre);
            packing.radius.push_back(disk.radius);
            packing.cluster.push_back(cluster);
            packing.cell_area.push_back(shape.area * disk.radius * disk.radius / squares);
        }
        ++cluster;
    }
    return packing;
}

} // namespace

double mean_radius(const model::GrainPacking& settings) { return SizeSpread(settings.sizes).mean(); }

Packing grains(const model::Region& region, const model::GrainPacking& settings) {
    const double area = bounded_area(region);
    if (!(area > 0.0)) return {};
    const GrainOrder order{shape_of(settings),
                           SizeSpread(settings.sizes),
                           area,
                           settings.count,
                           settings.porosity ? (1.0 - *settings.porosity) * area : 0.0,
                           settings.seed};
    const std::vector<Grain> put = put_down(region, order, settings.method);
    std::vector<Grain> kept;
    for (const std::size_t k : kept_at_random(put.size(), settings.removed, settings.seed)) kept.push_back(put[k]);
    return packing_of(kept, order.shape, region.bounds());
}

Packing thinned(const Packing& packing, double removed, std::uint64_t seed) {
    constexpr Index none = ~Index{0};
    std::vector<Index> number(packing.centre.size(), none);
    Index clusters = 0;
    Packing rest;
    for (const std::size_t k : kept_at_random(packing.centre.size(), removed, seed)) {
        Index& mine = number[packing.cluster[k]];
        if (mine == none) mine = clusters++;
        rest.centre.push_back(packing.centre[k]);
        rest.radius.push_back(packing.radius[k]);
        rest.cluster.push_back(mine);
        rest.cell_area.push_back(packing.cell_area[k]);
    }
    return rest;
}

} // namespace demlua::packing
