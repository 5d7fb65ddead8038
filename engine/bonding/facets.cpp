#include "engine/bonding/facets.hpp"

#include <algorithm>
#include <cmath>

namespace demlua::bonding {

namespace {

/// The line of a bond, from i to j, with its facet's ends measured along t.
struct Line {
    Vec2 normal;
    double length;
    double share_i;
    double low;
    double high;
};

Line line_of(const packing::Facet& facet, const std::vector<Vec2>& centre, const std::vector<double>& radius) {
    const Vec2 a = centre[facet.i];
    const Vec2 span = centre[facet.j] + facet.to_image - a;
    const double l = norm(span);
    const Vec2 n = span / l;
    const Vec2 t = turned_left(n);
    const double Ri = radius[facet.i];
    const double Rj = radius[facet.j];
    // Where the power of both is the same: |x - x_i|^2 - R_i^2 = |x - x_j|^2 - R_j^2.
    const double share_i = 0.5 * (1.0 + (Ri * Ri - Rj * Rj) / (l * l));
    return {n, l, share_i, dot(facet.from - a, t), dot(facet.to - a, t)};
}

law::FacetPart part_between(double low, double high) { return {high - low, 0.5 * (low + high)}; }

/// The part of a facet that counts for its cells: where it ends on a wall, up to the bond's line.
law::FacetPart closed_part(const packing::Facet& facet, const Line& line) {
    return part_between(facet.outward_from != Vec2{} ? 0.0 : line.low, facet.outward_to != Vec2{} ? 0.0 : line.high);
}

/// q of a pull along the wall by which the wall's tangent grows by one.
law::FacetVector<double> pull_along(Vec2 outward, const Line& line, double ratio) {
    const Vec2 tangent = turned_left(outward);
    const Vec2 t = turned_left(line.normal);
    const double across = dot(outward, line.normal);
    const double along = dot(tangent, line.normal);
    return {line.length * (along * along - ratio * across * across),
            line.length * (along * dot(tangent, t) - ratio * across * dot(outward, t)), 0.0};
}

FacetBond bond_of(const packing::Facet& facet, const Line& line, const law::FacetModuli& moduli, double thickness) {
    const bool wall_below = facet.outward_from != Vec2{};
    const bool wall_above = facet.outward_to != Vec2{};
    FacetBond bond;
    bond.share_i = line.share_i;
    bond.whole = part_between(line.low, line.high);
    bond.walled = wall_below || wall_above;
    const double per_length = 1.0 / line.length;
    const law::FacetPart closed = closed_part(facet, line);
    bond.springs = law::facet_springs(thickness * moduli.twice_shear, closed.area, closed.centre, per_length);
    bond.growth_i = law::growth_of_i(closed.area, closed.centre, per_length, line.share_i);
    bond.growth_j = law::growth_of_j(closed.area, closed.centre, per_length, line.share_i);

    const auto meet_wall = [&](Vec2 outward, law::FacetPart outer) {
        const Vec2 tangent = turned_left(outward);
        law::add_wall_bar(bond.springs, moduli, outer, dot(tangent, line.normal),
                          dot(tangent, turned_left(line.normal)), line.length, thickness);
    };
    if (wall_below) meet_wall(facet.outward_from, part_between(line.low, 0.0));
    if (wall_above) meet_wall(facet.outward_to, part_between(0.0, line.high));
    const bool line_misses = line.low > 0.0 || line.high < 0.0;
    if (bond.walled && line_misses) {
        const Vec2 outward = wall_above ? facet.outward_to : facet.outward_from;
        bond.springs = law::answering(bond.springs, pull_along(outward, line, moduli.ratio));
    }
    return bond;
}

/// The sum over a cell's facets of A n (x - x_i)', x the facet's middle: V times unity when they close the cell.
struct CellShape {
    double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0; ///< m^2
    Vec2 outward;                                  ///< sum of the wall's normals where facets end on it
    int walls = 0;

    void add(double area, Vec2 normal, Vec2 to_middle) {
        xx += area * normal.x * to_middle.x;
        xy += area * normal.x * to_middle.y;
        yx += area * normal.y * to_middle.x;
        yy += area * normal.y * to_middle.y;
    }
    void meet_wall(Vec2 normal) {
        if (normal == Vec2{}) return;
        outward += normal;
        ++walls;
    }
    [[nodiscard]] double along(Vec2 direction) const {
        const Vec2 d = direction;
        return d.x * (xx * d.x + xy * d.y) + d.y * (yx * d.x + yy * d.y);
    }
};

/// V of the head of law/facet.hpp.
double volume_of(const CellShape& shape, double ratio) {
    constexpr double one_wall = 0.9; // of the length that the normals of one straight wall add up to
    const double inside = 0.5 * (shape.xx + shape.yy);
    const double straight = norm(shape.outward);
    if (shape.walls == 0 || straight < one_wall * shape.walls) return inside;
    const Vec2 normal = shape.outward / straight;
    const double stretched = (shape.along(turned_left(normal)) - ratio * shape.along(normal)) / (1.0 - ratio);
    return std::clamp(stretched, 0.25 * inside, 4.0 * inside);
}

} // namespace

FacetNetwork facet_network(const packing::Cells& cells, const std::vector<Vec2>& centre,
                           const std::vector<double>& radius, const law::FacetModuli& moduli, double thickness) {
    FacetNetwork network;
    network.volume.assign(centre.size(), 0.0);
    network.bonds.reserve(cells.facets.size());
    std::vector<CellShape> shapes(centre.size());
    for (const packing::Facet& facet : cells.facets) {
        const Line line = line_of(facet, centre, radius);
        const FacetBond& bond = network.bonds.emplace_back(bond_of(facet, line, moduli, thickness));
        const law::FacetPart closed = closed_part(facet, line);
        const Vec2 aside = closed.centre * turned_left(line.normal);
        shapes[facet.i].add(closed.area, line.normal, bond.share_i * line.length * line.normal + aside);
        shapes[facet.j].add(closed.area, -line.normal, -(1.0 - bond.share_i) * line.length * line.normal + aside);
        for (CellShape* shape : {&shapes[facet.i], &shapes[facet.j]}) {
            shape->meet_wall(facet.outward_from);
            shape->meet_wall(facet.outward_to);
        }
    }
    constexpr double least_share = 1e-3;
    for (std::size_t k = 0; k < centre.size(); ++k) {
        const double volume = volume_of(shapes[k], moduli.ratio);
        network.volume[k] = volume > least_share * cells.area[k] ? volume : 0.0;
    }
    return network;
}

} // namespace demlua::bonding
