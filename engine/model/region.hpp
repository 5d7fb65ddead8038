// Regions of the plane as values: combined, moved and asked, never changed.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/boundary.hpp"

#include <memory>
#include <vector>

namespace demlua::model {

/// A part of the boundary as seen from a point: signed distance (m, negative inside the region) and the unit
/// vector out of the region.
struct Boundary {
    double distance;
    Vec2 outward;
};

/// A part of the plane, metres. Copies are cheap and share what they were made from. An empty region by
/// default.
class Region {
public:
    Region();

    /// Corner `at` (lower left) and positive `size`.
    static Region rectangle(Vec2 at, Vec2 size);
    static Region disc(Vec2 centre, double radius);
    /// At least three corners in either sense, not crossing itself.
    static Region polygon(std::vector<Vec2> corners);
    /// Everything on the side of the line through `point` away from `outward` (any length but zero).
    static Region half_plane(Vec2 point, Vec2 outward);

    [[nodiscard]] Region united(const Region& other) const;
    [[nodiscard]] Region without(const Region& other) const;
    [[nodiscard]] Region intersected(const Region& other) const;
    [[nodiscard]] Region translated(Vec2 by) const;
    /// Turned counter-clockwise by `angle` (rad) about `about`.
    [[nodiscard]] Region rotated(double angle, Vec2 about) const;

    /// The boundary belongs to the region.
    [[nodiscard]] bool contains(Vec2 point) const { return distance(point) <= 0.0; }

    /// Signed distance to the true boundary of the whole, metres, negative inside; zero to within rounding of
    /// the coordinates. Minus (plus) infinity where there is no boundary, in the whole plane (an empty
    /// region).
    [[nodiscard]] double distance(Vec2 point) const;

    /// Unit vector along which `distance` grows fastest; (1, 0) where there is no boundary.
    [[nodiscard]] Vec2 outward(Vec2 point) const;

    /// The walls a disk of radius `reach` (m) about `point` meets, put into `found`: the nearest piece of
    /// boundary, and every other whose inner side faces the point squarely. In a corner there are two, where
    /// `distance` knows one.
    void walls_near(Vec2 point, double reach, std::vector<Boundary>& found) const;

    /// Smallest box that holds the region; infinite sides where it is unbounded.
    [[nodiscard]] Box bounds() const;

    /// What truly bounds the region: straight pieces and arcs with the region on their left (see Piece for the sense
    /// of arcs), seams and hidden edges left out, in no particular order. Integrals over the region become sums
    /// over them. Lives as long as the region.
    [[nodiscard]] const Pieces& boundary() const;

    /// m^2, in closed form over the boundary; infinite for an unbounded region.
    [[nodiscard]] double area() const;

    struct Shape;

private:
    explicit Region(std::shared_ptr<const Shape> shape);
    std::shared_ptr<const Shape> shape_;
};

} // namespace demlua::model
