// Who is nearest, among elements of any radii.
#pragma once

#include "engine/base/vec2.hpp"

#include <nanoflann.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace demlua::packing {

/// An element and its power |x - x_i|^2 - R_i^2 at a place, m^2, counted from -R^2 of the largest element.
struct Near {
    std::size_t element = 0;
    double power = 0.0;
};

/// Elements lifted out of the plane by their `height` sqrt(largest R^2 - R^2): seen from a point of the plane their power
/// is the square of a distance, so the element that owns the point is its nearest neighbour in space (Aurenhammer 1987).
/// Equal elements stay in the plane.
class Nearest {
public:
    /// Centres (m) and radii (m).
    Nearest(const std::vector<Vec2>& centre, const std::vector<double>& radius);
    ~Nearest() = default;
    Nearest(const Nearest&) = delete;
    Nearest& operator=(const Nearest&) = delete;
    Nearest(Nearest&&) = delete;
    Nearest& operator=(Nearest&&) = delete;

    [[nodiscard]] double height(std::size_t i) const { return points_[i][2]; }
    [[nodiscard]] double power(Vec2 point, std::size_t i) const;

    /// Who owns a point; at least one element must be there.
    [[nodiscard]] Near owner(Vec2 point) const;

    /// The `count` nearest to element i in space, itself the first, put into `found`; fewer if there are no more. Their
    /// `power` is the squared distance in space.
    void around(std::size_t i, std::size_t count, std::vector<Near>& found);

private:
    using Point = std::array<double, 3>;
    struct Cloud {
        const std::vector<Point>& points;

        [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
        [[nodiscard]] double kdtree_get_pt(std::size_t k, std::size_t axis) const { return points[k][axis]; }
        template <class Bounds>
        bool kdtree_get_bbox(Bounds& /*bounds*/) const {
            return false;
        }
    };
    using Metric = nanoflann::L2_Simple_Adaptor<double, Cloud>;
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud, 3, std::size_t>;

    std::vector<Point> points_;
    Cloud cloud_;
    Tree tree_;
    std::vector<std::size_t> elements_; ///< scratch
    std::vector<double> distances_;     ///< scratch
};

} // namespace demlua::packing
