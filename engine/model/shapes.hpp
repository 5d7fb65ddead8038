// The tree a region is made of: it knows on which side a point lies, and holds what bounds the region.
#pragma once

#include "engine/model/boundary.hpp"
#include "engine/model/region.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace demlua::model {

/// A node of the tree.
struct Region::Shape {
    Shape() = default;
    virtual ~Shape() = default;
    Shape(const Shape&) = delete;
    Shape& operator=(const Shape&) = delete;
    Shape(Shape&&) = delete;
    Shape& operator=(Shape&&) = delete;

    /// -1 inside, 0 on the boundary to within rounding, +1 outside.
    [[nodiscard]] int side(Vec2 point) const { return far_from_box(point) ? 1 : side_by_shape(point); }

    /// Length below which two places are the same to the numbers at hand, m.
    [[nodiscard]] double rounding(Vec2 point) const {
        return 16.0 * std::numeric_limits<double>::epsilon() * (reach + std::abs(point.x) + std::abs(point.y));
    }

    Pieces boundary;      ///< what truly bounds the region, the region on the left
    Box box = everything; ///< around the region
    double reach = 0.0;   ///< largest coordinate it was made from, m
    double size = 0.0;    ///< largest finite extent it was made from, m; 0 when there is none

protected:
    [[nodiscard]] virtual int side_by_shape(Vec2 point) const = 0;

    /// To be called once the boundary, reach and size are known.
    void find_box();

private:
    [[nodiscard]] bool far_from_box(Vec2 point) const {
        const double slack = rounding(point);
        return point.x < box.lower.x - slack || point.x > box.upper.x + slack || point.y < box.lower.y - slack ||
               point.y > box.upper.y + slack;
    }

    /// Opens `found` if the region fills the sector between two angles far away.
    void open_sector(Box& found, double from, double to) const;
};

using ShapePointer = std::shared_ptr<const Region::Shape>;

// What the arguments must be stands at the functions of Region.
ShapePointer empty_shape();
ShapePointer disc_shape(Vec2 centre, double radius);
ShapePointer half_plane_shape(Vec2 point, Vec2 outward);
ShapePointer polygon_shape(std::vector<Vec2> corners);

/// Turned counter-clockwise by `angle` (rad) about the origin, then shifted.
ShapePointer moved_shape(ShapePointer original, double angle, Vec2 shift);

enum class Combine { either, both, first_only };

/// Where the boundaries of both meet to within rounding they count as one.
ShapePointer combined_shape(ShapePointer first, ShapePointer second, Combine rule);

} // namespace demlua::model
