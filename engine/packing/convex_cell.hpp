// A convex cell, cut out of a box by one straight line after another.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/vec2.hpp"
#include "engine/model/boundary.hpp"

#include <limits>
#include <vector>

namespace demlua::packing {

/// Stands for the box in place of an element.
inline constexpr Index nobody = std::numeric_limits<Index>::max();

/// A side of a convex cell: from `from` to the next side's `from`, counter-clockwise, on the line
/// dot(x, towards) = offset. All as seen from the cell's own element, m.
struct Side {
    Vec2 from;
    Vec2 towards; ///< out of the cell, any length
    double offset = 0.0;
    Index across = nobody; ///< the element beyond
};

/// The points of a box that no line has cut off.
class ConvexCell {
public:
    void fill(const Box& box);

    /// Cuts off where dot(x, towards) exceeds `offset`; returns whether that was anything.
    bool cut(Vec2 towards, double offset, Index across);
    void clear() { sides_.clear(); }

    [[nodiscard]] bool empty() const { return sides_.empty(); }
    [[nodiscard]] const std::vector<Side>& sides() const { return sides_; }
    [[nodiscard]] Vec2 end_of(std::size_t side) const { return sides_[side + 1 < sides_.size() ? side + 1 : 0].from; }
    [[nodiscard]] bool borders(Index element) const;
    [[nodiscard]] bool contains(Vec2 point) const;
    /// Its area and first moment about the element.
    [[nodiscard]] model::Swept swept() const;
    /// Distance from the element to the farthest corner, m.
    [[nodiscard]] double reach() const;

private:
    std::vector<Side> sides_;
    std::vector<Side> kept_;       ///< scratch
    std::vector<double> overhang_; ///< scratch: how far beyond the line each corner lies, times |towards|
};

/// The line between the cells of two elements, the other at `towards` (m) as seen from the one: its offset for
/// ConvexCell::cut, m^2.
inline double offset_between(Vec2 towards, double radius, double other_radius) {
    return 0.5 * (dot(towards, towards) + radius * radius - other_radius * other_radius);
}

} // namespace demlua::packing
