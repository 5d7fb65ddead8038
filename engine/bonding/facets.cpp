#include "engine/bonding/facets.hpp"

#include <algorithm>
#include <utility>

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
    const Vec2 span = centre[facet.j] - a;
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

/// Where a facet that ends on walls leaves the inside of the body, the cells are closed along the bond's line, and only
/// what lies beyond the line belongs to the wall.
FacetBond bond_of(const packing::Facet& facet, const Line& line, const law::FacetModuli& moduli, double thickness) {
    const bool wall_below = facet.outward_from != Vec2{};
    const bool wall_above = facet.outward_to != Vec2{};
    const double low = wall_below ? std::clamp(0.0, line.low, line.high) : line.low;
    const double high = wall_above ? std::clamp(0.0, low, line.high) : line.high;

    FacetBond bond;
    bond.pair = {facet.i, facet.j};
    bond.share_i = line.share_i;
    bond.whole = part_between(line.low, line.high);
    bond.springs = law::facet_springs(moduli, part_between(low, high), line.length, thickness);
    const law::FacetPart closed = part_between(wall_below ? 0.0 : line.low, wall_above ? 0.0 : line.high);
    bond.growth_i = law::cell_growth(closed, line.length, line.share_i, false);
    bond.growth_j = law::cell_growth(closed, line.length, line.share_i, true);

    const Vec2 t = turned_left(line.normal);
    const auto close = [&](double side, Vec2 outward, law::FacetPart outer) {
        const Vec2 tangent = turned_left(outward);
        law::add_wall_bar(bond.springs, moduli, outer, dot(tangent, line.normal), dot(tangent, t), line.length,
                          thickness);
        bond.growth_i = bond.growth_i + law::closing_growth(side, line.length, line.share_i, false);
        bond.growth_j = bond.growth_j + law::closing_growth(side, line.length, line.share_i, true);
    };
    if (wall_below) close(-1.0, facet.outward_from, part_between(line.low, low));
    if (wall_above) close(+1.0, facet.outward_to, part_between(high, line.high));
    return bond;
}

} // namespace

FacetNetwork facet_network(const packing::Cells& cells, const std::vector<Vec2>& centre,
                           const std::vector<double>& radius, const law::FacetModuli& moduli, double thickness) {
    FacetNetwork network;
    network.volume.assign(centre.size(), 0.0);
    network.bonds.reserve(cells.facets.size());
    for (const packing::Facet& facet : cells.facets) {
        const Line line = line_of(facet, centre, radius);
        const FacetBond bond = bond_of(facet, line, moduli, thickness);
        // A uniform swelling grows a cell by twice its area.
        network.volume[facet.i] += 0.5 * bond.growth_i.normal * line.length;
        network.volume[facet.j] += 0.5 * bond.growth_j.normal * line.length;
        network.bonds.push_back(bond);
    }
    constexpr double least_share = 1e-3;
    for (std::size_t k = 0; k < centre.size(); ++k) {
        if (network.volume[k] < least_share * cells.area[k]) network.volume[k] = 0.0;
    }
    return network;
}

} // namespace demlua::bonding
