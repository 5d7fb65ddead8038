#include "engine/packing/repeating.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>

namespace demlua::packing {

namespace {

constexpr double same_length = 1e-9; // of the period

/// A region with its images on both sides.
model::Region with_images(const model::Region& region, Period period) {
    const Vec2 next{period.length, 0.0};
    return region.translated(-next).united(region).united(region.translated(next));
}

/// Elements, and those of their images that lie within half a period of the region.
struct Images {
    std::vector<Vec2> centre;
    std::vector<double> radius;
    std::vector<std::size_t> element;
    std::vector<Vec2> shift;
};

Images images_around(const std::vector<Vec2>& centre, const std::vector<double>& radius, const Box& box,
                     Period period) {
    Images images{centre, radius, {}, std::vector<Vec2>(centre.size())};
    for (std::size_t k = 0; k < centre.size(); ++k) images.element.push_back(k);
    const double margin = 0.5 * period.length;
    for (const double shift : {-period.length, period.length}) {
        for (std::size_t k = 0; k < centre.size(); ++k) {
            const double x = centre[k].x + shift;
            if (x < box.lower.x - margin || x > box.upper.x + margin) continue;
            images.centre.push_back({x, centre[k].y});
            images.radius.push_back(radius[k]);
            images.element.push_back(k);
            images.shift.push_back({shift, 0.0});
        }
    }
    return images;
}

} // namespace

bool goes_on(const model::Region& region, Period period) {
    return period.repeats() && region.bounds().size().x >= (1.0 - same_length) * period.length;
}

bool lattice_repeats(const model::ClosePacking& lattice, Period period) {
    const double pitch = (lattice.rows == Rows::horizontal ? 2.0 : 2.0 * std::numbers::sqrt3) * lattice.radius;
    const double times = period.length / pitch;
    return std::fabs(times - std::nearbyint(times)) <= same_length * times;
}

Packing close_packed_across(const model::Region& region, const model::ClosePacking& lattice, Period period) {
    const double R = lattice.radius;
    if (!goes_on(region, period) || !lattice_repeats(lattice, period)) {
        return close_packed(region, R, lattice.rows, lattice.fit, lattice.origin);
    }
    const Vec2 corner = region.bounds().lower;
    const double inset = lattice.fit == Fit::inside ? R : 0.0;
    Packing all = close_packed(with_images(region, period), R, lattice.rows, lattice.fit,
                               lattice.origin.value_or(corner + Vec2{inset, inset}));
    constexpr double slack = 1e-6; // in radii
    const double left = corner.x - slack * R;
    Packing pack;
    for (std::size_t k = 0; k < all.centre.size(); ++k) {
        if (all.centre[k].x < left || all.centre[k].x >= left + period.length) continue;
        pack.cluster.push_back(static_cast<Index>(pack.centre.size()));
        pack.centre.push_back(all.centre[k]);
        pack.radius.push_back(all.radius[k]);
        pack.cell_area.push_back(all.cell_area[k]);
    }
    return pack;
}

Cells cells_across(const std::vector<Vec2>& centre, const std::vector<double>& radius, const model::Region& region,
                   Period period) {
    if (!goes_on(region, period)) return cells_of(centre, radius, region);
    const std::size_t n = centre.size();
    const Images images = images_around(centre, radius, region.bounds(), period);
    Cells cells = cells_of(images.centre, images.radius, with_images(region, period));
    cells.area.resize(n);
    cells.centroid.resize(n);
    std::erase_if(cells.facets, [&](const Facet& facet) { return facet.i >= n || images.element[facet.j] <= facet.i; });
    for (Facet& facet : cells.facets) {
        facet.to_image = images.shift[facet.j];
        facet.j = static_cast<Index>(images.element[facet.j]);
    }
    std::sort(cells.facets.begin(), cells.facets.end(),
              [](const Facet& a, const Facet& b) { return std::tie(a.i, a.j) < std::tie(b.i, b.j); });
    return cells;
}

} // namespace demlua::packing
