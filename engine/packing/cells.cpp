#include "engine/packing/cells.hpp"

#include "engine/base/problems.hpp"
#include "engine/packing/clipping.hpp"
#include "engine/packing/convex_cell.hpp"
#include "engine/packing/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace demlua::packing {

namespace {

/// Builds the whole cell of one element after another: first against its nearest neighbours, then against whoever
/// owns one of its corners, until it owns them all; what is convex and owns its corners owns all between.
class CellBuilder {
public:
    CellBuilder(const std::vector<Vec2>& centre, const std::vector<double>& radius, const Box& box)
        : centre_(centre), radius_(radius), box_(box), nearest_(centre, radius) {}

    void build(std::size_t i, ConvexCell& cell) {
        cell.fill({box_.lower - centre_[i], box_.upper - centre_[i]});
        const double horizon = cut_by_nearest(i, cell);
        const double reach = cell.reach();
        const double height = nearest_.height(i);
        if (horizon >= 4.0 * (reach * reach + height * height)) return;
        cut_by_owners_of_corners(i, cell);
    }

private:
    static constexpr std::size_t nearest_count = 16;

    bool cut_by(std::size_t i, std::size_t j, ConvexCell& cell) const {
        const Vec2 towards = centre_[j] - centre_[i];
        const double offset = offset_between(towards, radius_[i], radius_[j]);
        if (towards == Vec2{}) { // of two in one place the larger has all, of equal ones the first
            if (offset > 0.0 || (offset == 0.0 && i < j)) return false;
            cell.clear();
            return true;
        }
        return cell.cut(towards, offset, static_cast<Index>(j));
    }

    /// Returns the squared distance (lifted, m^2) below which nobody is left who might cut.
    double cut_by_nearest(std::size_t i, ConvexCell& cell) {
        nearest_.around(i, nearest_count, found_);
        for (const Near& near : found_) {
            if (near.element != i) cut_by(i, near.element, cell);
        }
        return found_.size() < nearest_count ? std::numeric_limits<double>::infinity() : found_.back().power;
    }

    void cut_by_owners_of_corners(std::size_t i, ConvexCell& cell) {
        constexpr double clearly = 1.0 - 1e-13; // where cells meet, their elements are equally near
        std::size_t k = 0;
        while (k < cell.sides().size()) {
            const Vec2 corner = centre_[i] + cell.sides()[k].from;
            const Near owner = nearest_.owner(corner);
            const bool lost = owner.element != i && !cell.borders(static_cast<Index>(owner.element)) &&
                              owner.power < clearly * nearest_.power(corner, i);
            k = lost && cut_by(i, owner.element, cell) ? 0 : k + 1;
        }
    }

    const std::vector<Vec2>& centre_;
    const std::vector<double>& radius_;
    Box box_;
    Nearest nearest_;
    std::vector<Near> found_; ///< scratch
};

/// Facets of element i with elements of higher number.
void add_facets(std::size_t i, const std::vector<Vec2>& centre, const std::vector<double>& radius,
                const ConvexCell& cell, const ClippedCell& clipped, std::vector<Facet>& facets) {
    constexpr double shortest = 1e-9; // in radii
    const std::size_t first = facets.size();
    for (const SidePart& part : clipped.sides) {
        const Index j = cell.sides()[part.side].across;
        if (j == nobody || j < i) continue;
        if (norm(part.to - part.from) <= shortest * std::max(radius[i], radius[j])) continue;
        facets.push_back({static_cast<Index>(i),
                          j,
                          centre[i] + part.from,
                          centre[i] + part.to,
                          part.outward_from,
                          part.outward_to,
                          {}});
    }
    std::sort(facets.begin() + static_cast<std::ptrdiff_t>(first), facets.end(),
              [](const Facet& a, const Facet& b) { return a.j < b.j; });
}

} // namespace

Cells cells_of(const std::vector<Vec2>& centre, const std::vector<double>& radius, const model::Region& region) {
    const Vec2 size = region.bounds().size();
    if (std::isinf(size.x) || std::isinf(size.y)) throw RunError("cells need a bounded region");
    Cells cells;
    cells.area.assign(centre.size(), 0.0);
    cells.centroid = centre;
    if (region.bounds().empty()) return cells;

    Clipper clipper(region);
    CellBuilder builder(centre, radius, clipper.box());
    ConvexCell cell;
    ClippedCell clipped;
    for (std::size_t i = 0; i < centre.size(); ++i) {
        builder.build(i, cell);
        clipper.clip(cell, centre[i], clipped);
        cells.area[i] = clipped.swept.area;
        if (clipped.swept.area > 0.0) cells.centroid[i] += clipped.swept.moment / clipped.swept.area;
        add_facets(i, centre, radius, cell, clipped, cells.facets);
    }
    return cells;
}

} // namespace demlua::packing
