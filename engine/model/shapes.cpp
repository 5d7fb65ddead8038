#include "engine/model/shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

namespace demlua::model {

void Region::Shape::find_box() {
    Box found = nothing;
    for (const Piece& piece : boundary) include(found, piece);
    const std::vector<double> rays = angles_of_rays(boundary);
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const double next = k + 1 < rays.size() ? rays[k + 1] : rays.front() + two_pi;
        open_sector(found, rays[k], next);
    }
    if (rays.empty()) open_sector(found, 0.0, two_pi);
    box = found;
}

void Region::Shape::open_sector(Box& found, double from, double to) const {
    constexpr double narrowest = 1e-6;
    const double width = to - from;
    if (width < narrowest) return;
    const double middle = 0.5 * (from + to);
    const double far = 100.0 * (reach + size + 1.0) / std::min(width, 1.0);
    if (side_by_shape(far * Vec2{std::cos(middle), std::sin(middle)}) > 0) return;
    constexpr int steps = 8; // no step exceeds a quarter of a half turn, so no side is missed
    for (int k = 0; k <= steps; ++k) {
        const double angle = from + width * k / steps;
        open_towards(found, {std::cos(angle), std::sin(angle)});
    }
}

namespace {

using Shape = Region::Shape;

struct Empty final : Shape {
    Empty() { find_box(); }
    [[nodiscard]] int side_by_shape(Vec2 /*point*/) const override { return 1; }
};

struct Disc final : Shape {
    Disc(Vec2 at, double r) : centre(at), radius(r) {
        reach = std::max(std::abs(at.x), std::abs(at.y)) + r;
        size = 2.0 * r;
        boundary = {{at, {}, r, -std::numbers::pi, std::numbers::pi, false}};
        find_box();
    }

    [[nodiscard]] int side_by_shape(Vec2 point) const override {
        const double distance = norm(point - centre) - radius;
        if (std::abs(distance) <= rounding(point)) return 0;
        return distance < 0.0 ? -1 : 1;
    }

    Vec2 centre;
    double radius;
};

struct HalfPlane final : Shape {
    HalfPlane(Vec2 at, Vec2 outward) : point(at), normal(outward / norm(outward)) {
        reach = std::max(std::abs(at.x), std::abs(at.y));
        boundary = {{at, turned_left(normal), 0.0, -infinity, infinity, false}};
        find_box();
    }

    [[nodiscard]] int side_by_shape(Vec2 place) const override {
        const double distance = dot(normal, place - point);
        if (std::abs(distance) <= rounding(place)) return 0;
        return distance < 0.0 ? -1 : 1;
    }

    Vec2 point;
    Vec2 normal;
};

/// Twice the area inside `corners`, positive when they run counter-clockwise.
double doubled_area(const std::vector<Vec2>& corners) {
    double sum = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 a = corners[k] - corners.front();
        const Vec2 b = corners[(k + 1) % corners.size()] - corners.front();
        sum += cross(a, b);
    }
    return sum;
}

struct Polygon final : Shape {
    explicit Polygon(std::vector<Vec2> corners) {
        if (doubled_area(corners) < 0.0) std::reverse(corners.begin(), corners.end());
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec2 from = corners[k];
            const Vec2 to = corners[(k + 1) % corners.size()];
            if (!(from == to)) boundary.push_back(straight_piece(from, to));
            reach = std::max({reach, std::abs(from.x), std::abs(from.y)});
        }
        find_box();
        size = std::max(box.size().x, box.size().y);
    }

    /// Counts the edges to the right of the point; an edge owns its lower end only, so a corner is counted
    /// once.
    [[nodiscard]] int side_by_shape(Vec2 point) const override {
        const double slack = rounding(point);
        bool inside = false;
        for (const Piece& edge : boundary) {
            if (edge.distance(point) <= slack) return 0;
            const Vec2 from = edge.at(edge.begin);
            const Vec2 to = edge.at(edge.end);
            if ((from.y > point.y) == (to.y > point.y)) continue;
            if (from.x + (to.x - from.x) * (point.y - from.y) / (to.y - from.y) > point.x) inside = !inside;
        }
        return inside ? -1 : 1;
    }
};

/// Turned counter-clockwise by `angle` about the origin, then shifted.
struct Moved final : Shape {
    Moved(std::shared_ptr<const Shape> original, double by_angle, Vec2 by)
        : shape(std::move(original)), angle(by_angle), shift(by) {
        reach = 2.0 * shape->reach + std::max(std::abs(by.x), std::abs(by.y));
        size = shape->size;
        boundary = shape->boundary;
        for (Piece& piece : boundary) {
            piece.origin = turned(piece.origin, angle) + shift;
            piece.direction = turned(piece.direction, angle);
            if (piece.straight()) continue;
            piece.begin += angle;
            piece.end += angle;
        }
        find_box();
    }

    [[nodiscard]] int side_by_shape(Vec2 point) const override { return shape->side(turned(point - shift, -angle)); }

    std::shared_ptr<const Shape> shape;
    double angle;
    Vec2 shift;
};

struct Combination final : Shape {
    Combination(std::shared_ptr<const Shape> a, std::shared_ptr<const Shape> b, Combine rule)
        : first(std::move(a)), second(std::move(b)), combine(rule) {
        reach = std::max(first->reach, second->reach);
        size = std::max(first->size, second->size);
        find_boundary();
        find_box();
    }

    /// Where the boundaries of both meet, the point may still lie inside (on a seam) or outside (on a cut along
    /// nothing): then its surroundings decide.
    [[nodiscard]] int side_by_shape(Vec2 point) const override {
        const int here = combined_side(point);
        if (here != 0 || nearest_foot(boundary, point).distance <= rounding(point)) return here;
        for (const Vec2 aside : {Vec2{0.6, 0.8}, Vec2{-0.8, 0.6}, Vec2{0.28, -0.96}}) {
            const int nearby = combined_side(point + closeness() * aside);
            if (nearby != 0) return nearby;
        }
        return here;
    }

    std::shared_ptr<const Shape> first;
    std::shared_ptr<const Shape> second;
    Combine combine;

private:
    [[nodiscard]] int combined_side(Vec2 point) const {
        switch (combine) {
        case Combine::either:
            return std::min(first->side(point), second->side(point));
        case Combine::both:
            return std::max(first->side(point), second->side(point));
        case Combine::first_only:
            break;
        }
        return std::max(first->side(point), -second->side(point));
    }

    /// Cuts both boundaries where they meet and keeps the parts that have the region on one side only. A part
    /// that belongs to both boundaries is taken from the first.
    void find_boundary() {
        const double near = closeness();
        Pieces of_second = second->boundary;
        if (combine == Combine::first_only) {
            for (Piece& piece : of_second) piece = piece.reversed();
        }
        for (const Piece& piece : first->boundary) {
            for (const Piece& part : cut(piece, of_second, near)) {
                if (bounds_region(part, near)) boundary.push_back(part);
            }
        }
        for (const Piece& piece : of_second) {
            for (const Piece& part : cut(piece, first->boundary, near)) {
                const bool shared = nearest_foot(first->boundary, part.at(middle(part))).distance <= near;
                if (!shared && bounds_region(part, near)) boundary.push_back(part);
            }
        }
    }

    /// Gaps and slivers thinner than this are taken for rounding, m.
    [[nodiscard]] double closeness() const {
        const double length = size > 0.0 ? size : std::max(reach, 1.0);
        return std::max(1e-9 * length, 8.0 * rounding({reach, reach}));
    }

    [[nodiscard]] double middle(const Piece& part) const {
        const double far = reach + size + 1.0;
        if (std::isfinite(part.begin) && std::isfinite(part.end)) return 0.5 * (part.begin + part.end);
        if (std::isfinite(part.begin)) return part.begin + far;
        return std::isfinite(part.end) ? part.end - far : 0.0;
    }

    [[nodiscard]] bool bounds_region(const Piece& part, double near) const {
        const double s = middle(part);
        const Vec2 step = near * part.outward(s);
        return combined_side(part.at(s) - step) < 0 && combined_side(part.at(s) + step) > 0;
    }
};

} // namespace

ShapePointer empty_shape() { return std::make_shared<Empty>(); }

ShapePointer disc_shape(Vec2 centre, double radius) { return std::make_shared<Disc>(centre, radius); }

ShapePointer half_plane_shape(Vec2 point, Vec2 outward) { return std::make_shared<HalfPlane>(point, outward); }

ShapePointer polygon_shape(std::vector<Vec2> corners) { return std::make_shared<Polygon>(std::move(corners)); }

ShapePointer moved_shape(ShapePointer original, double angle, Vec2 shift) {
    return std::make_shared<Moved>(std::move(original), angle, shift);
}

ShapePointer combined_shape(ShapePointer first, ShapePointer second, Combine rule) {
    return std::make_shared<Combination>(std::move(first), std::move(second), rule);
}

} // namespace demlua::model
