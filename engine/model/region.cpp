// A region is a tree that knows on which side a point lies, and beside it the pieces of its true boundary
// (straight pieces and arcs of circles, the region on their left). The tree decides signs; distances,
// normals, boxes and areas are closed forms over the pieces, so that no seam or hidden edge of a combination
// is ever felt.
#include "engine/model/region.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace demlua::model {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double parallel = 1e-12; ///< sine of the angle below which directions count as equal

/// A stretch of boundary with the region on its left. A straight piece runs from `begin` to `end` metres
/// along `direction` (either may be infinite); an arc covers the angles from `begin` to `end`, at most a full
/// turn.
struct Piece {
    Vec2 origin;              ///< a point of the line, or the centre of the circle, m
    Vec2 direction;           ///< unit vector; straight pieces only
    double radius = 0.0;      ///< m; 0 for a straight piece
    double begin = 0.0;       ///< m or rad
    double end = 0.0;         ///< m or rad, above `begin`
    bool around_hole = false; ///< an arc whose circle bounds the region from inside

    [[nodiscard]] bool straight() const { return radius == 0.0; }
    [[nodiscard]] bool infinite() const { return std::isinf(begin) || std::isinf(end); }

    [[nodiscard]] Vec2 at(double s) const {
        return straight() ? origin + s * direction : origin + radius * Vec2{std::cos(s), std::sin(s)};
    }

    [[nodiscard]] Vec2 outward(double s) const {
        if (straight()) return -turned_left(direction);
        const Vec2 radial{std::cos(s), std::sin(s)};
        return around_hole ? -radial : radial;
    }

    /// Angle counted on from `begin`, so that it lies on the arc when it does not exceed `end`.
    [[nodiscard]] double angle_from_begin(Vec2 towards) const {
        const double turn = std::fmod(std::atan2(towards.y, towards.x) - begin, two_pi);
        return begin + (turn < 0.0 ? turn + two_pi : turn);
    }

    /// Where along the piece it comes nearest to `point`.
    [[nodiscard]] double nearest(Vec2 point) const {
        if (straight()) return std::clamp(dot(point - origin, direction), begin, end);
        const double angle = angle_from_begin(point - origin);
        if (angle <= end) return angle;
        return angle - end < begin + two_pi - angle ? end : begin;
    }

    [[nodiscard]] double distance(Vec2 point) const { return norm(point - at(nearest(point))); }

    [[nodiscard]] Piece reversed() const {
        Piece other = *this;
        if (straight()) {
            other.direction = -direction;
            other.begin = -end;
            other.end = -begin;
        } else {
            other.around_hole = !around_hole;
        }
        return other;
    }
};

using Pieces = std::vector<Piece>;

Piece straight_piece(Vec2 from, Vec2 to) {
    const double length = norm(to - from);
    return {from, (to - from) / length, 0.0, 0.0, length, false};
}

/// The point of `pieces` nearest to a place.
struct Foot {
    double distance = infinity;
    double s = 0.0;
    const Piece* piece = nullptr;
};

Foot nearest_foot(const Pieces& pieces, Vec2 point) {
    Foot best;
    for (const Piece& piece : pieces) {
        const double s = piece.nearest(point);
        const double distance = norm(point - piece.at(s));
        if (distance < best.distance) best = {distance, s, &piece};
    }
    return best;
}

// --- where the full lines and circles of two pieces cross --------------------------------------------------

void cross_lines(const Piece& a, const Piece& b, std::vector<Vec2>& found) {
    const double sine = cross(a.direction, b.direction);
    if (std::abs(sine) <= parallel) return;
    found.push_back(a.at(cross(b.origin - a.origin, b.direction) / sine));
}

void cross_line_circle(const Piece& line, const Piece& circle, std::vector<Vec2>& found) {
    const Vec2 to_centre = circle.origin - line.origin;
    const double height = cross(line.direction, to_centre);
    if (std::abs(height) > circle.radius * (1.0 + parallel)) return;
    const double half = std::sqrt(std::max(0.0, circle.radius * circle.radius - height * height));
    const double middle = dot(to_centre, line.direction);
    found.push_back(line.at(middle - half));
    found.push_back(line.at(middle + half));
}

void cross_circles(const Piece& a, const Piece& b, std::vector<Vec2>& found) {
    const Vec2 between = b.origin - a.origin;
    const double gap = norm(between);
    if (gap <= parallel * (a.radius + b.radius)) return;
    const double along = (gap * gap + a.radius * a.radius - b.radius * b.radius) / (2.0 * gap);
    if (std::abs(along) > a.radius * (1.0 + parallel)) return;
    const double across = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
    const Vec2 axis = between / gap;
    found.push_back(a.origin + along * axis + across * turned_left(axis));
    found.push_back(a.origin + along * axis - across * turned_left(axis));
}

/// Places where `piece` may pass from one side of `other` to the other: crossings, and the ends of `other`.
std::vector<Vec2> meeting_points(const Piece& piece, const Piece& other) {
    std::vector<Vec2> found;
    if (piece.straight() && other.straight()) {
        cross_lines(piece, other, found);
    } else if (piece.straight()) {
        cross_line_circle(piece, other, found);
    } else if (other.straight()) {
        cross_line_circle(other, piece, found);
    } else {
        cross_circles(piece, other, found);
    }
    for (const double end : {other.begin, other.end}) {
        if (std::isfinite(end)) found.push_back(other.at(end));
    }
    return found;
}

/// `piece` cut wherever it meets one of `others`; points within `near` (m) of each other are one.
Pieces cut(const Piece& piece, const Pieces& others, double near) {
    std::vector<double> cuts;
    for (const Piece& other : others) {
        for (const Vec2 point : meeting_points(piece, other)) {
            const double s = piece.nearest(point);
            if (norm(point - piece.at(s)) <= near) cuts.push_back(s);
        }
    }
    std::sort(cuts.begin(), cuts.end());

    const double shortest = piece.straight() ? near : near / piece.radius;
    Pieces parts;
    Piece part = piece;
    for (const double s : cuts) {
        if (s <= part.begin + shortest || s >= piece.end - shortest) continue;
        part.end = s;
        parts.push_back(part);
        part.begin = s;
    }
    part.end = piece.end;
    parts.push_back(part);
    return parts;
}

// --- boxes -------------------------------------------------------------------------------------------------

constexpr Box nothing{{infinity, infinity}, {-infinity, -infinity}};
constexpr Box everything{{-infinity, -infinity}, {infinity, infinity}};

void include(Box& box, Vec2 point) {
    box.lower = {std::min(box.lower.x, point.x), std::min(box.lower.y, point.y)};
    box.upper = {std::max(box.upper.x, point.x), std::max(box.upper.y, point.y)};
}

/// `s` metres along a line, sound for an infinite `s`.
double component_at(double origin, double direction, double s) {
    if (std::isinf(s) && std::abs(direction) <= parallel) return origin;
    return origin + s * direction;
}

void include(Box& box, const Piece& piece) {
    if (piece.straight()) {
        for (const double s : {piece.begin, piece.end}) {
            include(box, Vec2{component_at(piece.origin.x, piece.direction.x, s),
                              component_at(piece.origin.y, piece.direction.y, s)});
        }
        return;
    }
    include(box, piece.at(piece.begin));
    include(box, piece.at(piece.end));
    for (const Vec2 axis : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}, Vec2{-1.0, 0.0}, Vec2{0.0, -1.0}}) {
        if (piece.angle_from_begin(axis) <= piece.end) include(box, piece.origin + piece.radius * axis);
    }
}

/// Moves those sides of `box` to infinity towards which `direction` points.
void open_towards(Box& box, Vec2 direction) {
    if (direction.x > parallel) box.upper.x = infinity;
    if (direction.x < -parallel) box.lower.x = -infinity;
    if (direction.y > parallel) box.upper.y = infinity;
    if (direction.y < -parallel) box.lower.y = -infinity;
}

/// Angles at which the boundary runs off to infinity, rising.
std::vector<double> angles_of_rays(const Pieces& pieces) {
    std::vector<double> angles;
    for (const Piece& piece : pieces) {
        if (std::isinf(piece.end)) angles.push_back(std::atan2(piece.direction.y, piece.direction.x));
        if (std::isinf(piece.begin)) angles.push_back(std::atan2(-piece.direction.y, -piece.direction.x));
    }
    std::sort(angles.begin(), angles.end());
    return angles;
}

} // namespace

// --- the tree ----------------------------------------------------------------------------------------------

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
    void find_box() {
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

private:
    [[nodiscard]] bool far_from_box(Vec2 point) const {
        const double slack = rounding(point);
        return point.x < box.lower.x - slack || point.x > box.upper.x + slack || point.y < box.lower.y - slack ||
               point.y > box.upper.y + slack;
    }

    /// Opens `found` if the region fills the sector between two angles far away.
    void open_sector(Box& found, double from, double to) const {
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
};

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

enum class Combine { either, both, first_only };

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

/// The wall as seen from `point`, given its nearest place.
Boundary wall_at(const Shape& shape, const Foot& foot, Vec2 point) {
    if (foot.distance <= shape.rounding(point)) return {0.0, foot.piece->outward(foot.s)};
    const Vec2 away = (point - foot.piece->at(foot.s)) / foot.distance;
    if (shape.side(point) > 0) return {foot.distance, away};
    return {-foot.distance, -away};
}

/// Half the integral of x dy - y dx along a finite piece, about `about`.
double swept_area(const Piece& piece, Vec2 about) {
    const Vec2 from = piece.at(piece.begin) - about;
    const Vec2 to = piece.at(piece.end) - about;
    if (piece.straight()) return 0.5 * cross(from, to);
    const double sector = piece.radius * piece.radius * (piece.end - piece.begin);
    const double area = 0.5 * (sector + cross(piece.origin - about, to - from));
    return piece.around_hole ? -area : area;
}

bool infinite(const Box& box) {
    return std::isinf(box.lower.x) || std::isinf(box.lower.y) || std::isinf(box.upper.x) || std::isinf(box.upper.y);
}

} // namespace

// --- regions -----------------------------------------------------------------------------------------------

Region::Region() : shape_(std::make_shared<Empty>()) {}
Region::Region(std::shared_ptr<const Shape> shape) : shape_(std::move(shape)) {}

Region Region::rectangle(Vec2 at, Vec2 size) {
    const Vec2 far = at + size;
    return polygon({at, {far.x, at.y}, far, {at.x, far.y}});
}

Region Region::disc(Vec2 centre, double radius) { return Region(std::make_shared<Disc>(centre, radius)); }

Region Region::polygon(std::vector<Vec2> corners) { return Region(std::make_shared<Polygon>(std::move(corners))); }

Region Region::half_plane(Vec2 point, Vec2 outward) { return Region(std::make_shared<HalfPlane>(point, outward)); }

Region Region::united(const Region& other) const {
    return Region(std::make_shared<Combination>(shape_, other.shape_, Combine::either));
}

Region Region::without(const Region& other) const {
    return Region(std::make_shared<Combination>(shape_, other.shape_, Combine::first_only));
}

Region Region::intersected(const Region& other) const {
    return Region(std::make_shared<Combination>(shape_, other.shape_, Combine::both));
}

Region Region::translated(Vec2 by) const { return Region(std::make_shared<Moved>(shape_, 0.0, by)); }

Region Region::rotated(double angle, Vec2 about) const {
    return Region(std::make_shared<Moved>(shape_, angle, about - turned(about, angle)));
}

double Region::distance(Vec2 point) const {
    const Foot foot = nearest_foot(shape_->boundary, point);
    if (foot.piece == nullptr) return shape_->side(point) > 0 ? infinity : -infinity;
    return wall_at(*shape_, foot, point).distance;
}

Vec2 Region::outward(Vec2 point) const {
    const Foot foot = nearest_foot(shape_->boundary, point);
    return foot.piece == nullptr ? Vec2{1.0, 0.0} : wall_at(*shape_, foot, point).outward;
}

void Region::walls_near(Vec2 point, double reach, std::vector<Boundary>& found) const {
    found.clear();
    const Foot foot = nearest_foot(shape_->boundary, point);
    if (foot.piece == nullptr) return;
    const Boundary nearest = wall_at(*shape_, foot, point);
    if (nearest.distance <= -reach) return;
    found.push_back(nearest);
    for (const Piece& piece : shape_->boundary) {
        const double s = piece.nearest(point);
        if (&piece == foot.piece || s <= piece.begin || s >= piece.end) continue;
        const Vec2 out = piece.outward(s);
        const double depth = dot(piece.at(s) - point, out);
        if (depth >= 0.0 && depth < reach) found.push_back({-depth, out});
    }
}

Box Region::bounds() const { return shape_->box; }

double Region::area() const {
    const Box box = shape_->box;
    if (box.empty()) return 0.0;
    if (infinite(box)) return infinity;
    double sum = 0.0;
    for (const Piece& piece : shape_->boundary) sum += swept_area(piece, box.lower);
    return sum;
}

} // namespace demlua::model
