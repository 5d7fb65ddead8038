// Random elements made even by Lloyd's method.
#include "engine/base/problems.hpp"
#include "engine/packing/boundary_row.hpp"
#include "engine/packing/cells.hpp"
#include "engine/packing/lloyd.hpp"
#include "engine/packing/nearest.hpp"
#include "engine/packing/numbering.hpp"
#include "engine/packing/packing.hpp"
#include "engine/packing/sowing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace demlua::packing {

namespace {

using std::numbers::sqrt3;

constexpr double row_depth = 0.25 * sqrt3; ///< half the distance of rows, in distances of neighbours

double hexagon_radius(double area) { return std::sqrt(area / (2.0 * sqrt3)); }

/// Whether an element of the row on the boundary may stand at a place of it.
bool takes_row(const Relaxation& settings, Vec2 place) {
    return settings.boundary_within.bounds().empty() || settings.boundary_within.contains(place);
}

/// Length of the boundary that takes a row, to a hundredth of each piece.
double row_length(const model::Region& region, const Relaxation& settings) {
    constexpr int samples = 100;
    double sum = 0.0;
    for (const model::Piece& piece : region.boundary()) {
        const double part = (piece.end - piece.begin) / samples;
        for (int k = 0; k < samples; ++k) {
            if (takes_row(settings, piece.at(piece.begin + (k + 0.5) * part))) {
                sum += (piece.straight() ? 1.0 : piece.radius) * part;
            }
        }
    }
    return sum;
}

std::vector<Vec2> row_of(const model::Region& region, const Relaxation& settings, const model::Spacing& size) {
    std::vector<Vec2> row = boundary_row(region, size, settings.seed);
    std::erase_if(row, [&](Vec2 place) { return !takes_row(settings, place); });
    return row;
}

/// The distance h of neighbours at which `count` elements fit: full cells of sqrt(3)/2 h^2, and where a row stands on
/// the boundary, half cells every h along it.
double spacing_for(const model::Region& region, const Relaxation& settings) {
    const auto count = static_cast<double>(settings.count);
    const double cells = region.area() / (0.5 * sqrt3);
    const double row = settings.on_boundary ? 0.25 * row_length(region, settings) : 0.0;
    return (row + std::sqrt(row * row + count * cells)) / count;
}

model::Spacing size_of(const model::Region& region, const Relaxation& settings) {
    if (settings.size) return settings.size;
    const double spacing = settings.count > 0 ? spacing_for(region, settings) : settings.spacing;
    return [spacing](Vec2 /*place*/) { return spacing; };
}

/// Elements as sown, those on the boundary first.
struct Sown {
    std::vector<Vec2> centre;
    std::size_t on_boundary = 0;
};

Sown sown(const model::Region& region, const Relaxation& settings, const model::Spacing& size) {
    Sown elements;
    if (settings.on_boundary) elements.centre = row_of(region, settings, size);
    elements.on_boundary = elements.centre.size();
    const auto row = static_cast<double>(elements.on_boundary);
    const bool all_round = settings.on_boundary && settings.boundary_within.bounds().empty();
    const Field field(region, size, all_round ? row_depth : 0.0);
    const double room = settings.on_boundary ? Field(region, size, 0.0).elements() - 0.5 * row : field.elements();
    const double inside = settings.count > 0 ? static_cast<double>(settings.count) - row : std::round(room);
    if (inside < 0.5) return elements;
    const std::vector<Vec2> places = field.sow(static_cast<std::size_t>(inside), settings.seed);
    elements.centre.insert(elements.centre.end(), places.begin(), places.end());
    return elements;
}

/// Radii of hexagons as large as the cells, within the boundary.
std::vector<double> radii_inside(const std::vector<Vec2>& centre, const std::vector<double>& area,
                                 const model::Region& region) {
    std::vector<double> radius;
    for (std::size_t k = 0; k < centre.size(); ++k) {
        radius.push_back(std::min(hexagon_radius(area[k]), std::abs(region.distance(centre[k]))));
    }
    return radius;
}

/// Gives the first `count` elements the mean radius of the others next to them, and those in a corner, which have none,
/// that of the ones just given.
void size_like_neighbours(std::size_t count, const Cells& cells, std::vector<double>& radius) {
    std::vector<bool> known(radius.size(), false);
    std::fill(known.begin() + static_cast<std::ptrdiff_t>(count), known.end(), true);
    for (int round = 0; round < 2; ++round) {
        std::vector<double> sum(count, 0.0);
        std::vector<double> neighbours(count, 0.0);
        for (const Facet& facet : cells.facets) {
            for (const auto& [here, there] : {std::pair{facet.i, facet.j}, std::pair{facet.j, facet.i}}) {
                if (here >= count || known[here] || !known[there]) continue;
                sum[here] += radius[there];
                neighbours[here] += 1.0;
            }
        }
        for (std::size_t k = 0; k < count; ++k) {
            if (neighbours[k] == 0.0) continue;
            radius[k] = sum[k] / neighbours[k];
            known[k] = true;
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (!known[k]) radius[k] = hexagon_radius(2.0 * cells.area[k]);
    }
}

/// Of two elements so close that one disk holds the centre of the other, one might have no cell.
void keep_off_centres(const std::vector<Vec2>& centre, std::vector<double>& radius) {
    constexpr double largest = 0.75; // of the distance to the nearest centre; 0.5 where elements are even
    if (centre.size() < 2) return;
    Nearest nearest(centre, std::vector<double>(centre.size(), 0.0));
    std::vector<Near> found;
    for (std::size_t k = 0; k < centre.size(); ++k) {
        nearest.around(k, 2, found);
        radius[k] = std::min(radius[k], largest * std::sqrt(found.back().power));
    }
}

Packing numbered(const Packing& pack, const Box& box) {
    const double sum = std::accumulate(pack.radius.begin(), pack.radius.end(), 0.0);
    const double band = 4.0 * sum / static_cast<double>(pack.radius.size());
    Packing sorted;
    for (const std::size_t k : order_by_bands(pack.centre, box, band)) {
        sorted.cluster.push_back(static_cast<Index>(sorted.cluster.size()));
        sorted.centre.push_back(pack.centre[k]);
        sorted.radius.push_back(pack.radius[k]);
    }
    return sorted;
}

void require_bounded(const model::Region& region) {
    if (std::isfinite(region.area())) return;
    throw RunError("a relaxed pack needs a bounded region; cut the half-plane with a rectangle");
}

} // namespace

Packing relaxed(const model::Region& region, const Relaxation& settings) {
    require_bounded(region);
    if (!(region.area() > 0.0)) return {};
    Sown elements = sown(region, settings, size_of(region, settings));
    if (elements.centre.empty()) return {};
    relax(elements.centre, region, settings.size, settings.steps, elements.on_boundary);

    Packing pack;
    pack.centre = std::move(elements.centre);
    const Cells cells = cells_of(pack.centre, std::vector<double>(pack.centre.size(), 0.0), region);
    pack.radius = radii_inside(pack.centre, cells.area, region);
    size_like_neighbours(elements.on_boundary, cells, pack.radius);
    keep_off_centres(pack.centre, pack.radius);
    pack = numbered(pack, region.bounds());
    pack.cell_area = cells_of(pack.centre, pack.radius, region).area;
    return pack;
}

double relaxed_radius(const model::Region& region, const Relaxation& settings) {
    require_bounded(region);
    const model::Spacing size = size_of(region, settings);
    if (!settings.size) return 0.5 * size({});
    return hexagon_radius(region.area() / Field(region, size, 0.0).elements());
}

} // namespace demlua::packing
