// The hexagonal lattice, cut to a region.
#include "engine/base/problems.hpp"
#include "engine/packing/packing.hpp"

#include <cmath>
#include <numbers>

namespace demlua::packing {
namespace {

constexpr double boundary_slack = 1e-9; ///< in radii: how far out a point may lie and still count as inside

/// A lattice in its own axes: `along` its rows, `across` them; every other row is shifted by one radius.
struct Lattice {
    Vec2 origin;
    double radius;
    Rows rows;

    [[nodiscard]] double row_pitch() const { return std::numbers::sqrt3 * radius; }

    [[nodiscard]] Vec2 at(long row, long place) const {
        const double shift = row % 2 == 0 ? 0.0 : radius;
        const double along = 2.0 * radius * static_cast<double>(place) + shift;
        const double across = row_pitch() * static_cast<double>(row);
        return rows == Rows::horizontal ? origin + Vec2{along, across} : origin + Vec2{across, along};
    }
};

/// Numbers of the lattice lines, a `pitch` apart, from `low` to `high` above the origin, with one to spare at
/// each end.
struct Lines {
    long first;
    long last;
};

Lines lines_between(double low, double high, double pitch) {
    return {static_cast<long>(std::floor(low / pitch)) - 1, static_cast<long>(std::ceil(high / pitch)) + 1};
}

void require_bounded(const Box& box) {
    if (std::isfinite(box.size().x) && std::isfinite(box.size().y)) return;
    throw RunError("close packing needs a bounded region; cut the half-plane with a rectangle");
}

} // namespace

Packing close_packed(const model::Region& region, double radius, Rows rows, Fit fit, std::optional<Vec2> origin) {
    Packing packing;
    const Box box = region.bounds();
    if (box.empty()) return packing;
    require_bounded(box);

    const double inset = fit == Fit::inside ? radius : 0.0;
    const Lattice lattice{origin.value_or(box.lower + Vec2{inset, inset}), radius, rows};
    const Vec2 low = box.lower - lattice.origin;
    const Vec2 high = box.upper - lattice.origin;
    const bool horizontal = rows == Rows::horizontal;
    const Lines across = lines_between(horizontal ? low.y : low.x, horizontal ? high.y : high.x, lattice.row_pitch());
    const Lines along = lines_between(horizontal ? low.x : low.y, horizontal ? high.x : high.y, 2.0 * radius);

    for (long row = across.first; row <= across.last; ++row) {
        for (long place = along.first; place <= along.last; ++place) {
            const Vec2 centre = lattice.at(row, place);
            if (region.distance(centre) <= boundary_slack * radius - inset) packing.centre.push_back(centre);
        }
    }

    const std::size_t count = packing.centre.size();
    packing.radius.assign(count, radius);
    packing.cell_area.assign(count, 2.0 * std::numbers::sqrt3 * radius * radius);
    for (std::size_t k = 0; k < count; ++k) packing.cluster.push_back(static_cast<Index>(k));
    return packing;
}

} // namespace demlua::packing
