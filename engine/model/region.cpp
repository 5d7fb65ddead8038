// A region is a tree that knows on which side a point lies, and beside it the pieces of its true boundary
// (straight pieces and arcs of circles, the region on their left). The tree decides signs; distances,
// normals, boxes and areas are closed forms over the pieces, so that no seam or hidden edge of a combination
// is ever felt.
#include "engine/model/region.hpp"

#include "engine/model/boundary.hpp"
#include "engine/model/shapes.hpp"

#include <cmath>
#include <utility>

namespace demlua::model {
namespace {

/// The wall as seen from `point`, given its nearest place.
Boundary wall_at(const Region::Shape& shape, const Foot& foot, Vec2 point) {
    if (foot.distance <= shape.rounding(point)) return {0.0, foot.piece->outward(foot.s)};
    const Vec2 away = (point - foot.piece->at(foot.s)) / foot.distance;
    if (shape.side(point) > 0) return {foot.distance, away};
    return {-foot.distance, -away};
}

bool infinite(const Box& box) {
    return std::isinf(box.lower.x) || std::isinf(box.lower.y) || std::isinf(box.upper.x) || std::isinf(box.upper.y);
}

} // namespace

Region::Region() : shape_(empty_shape()) {}
Region::Region(std::shared_ptr<const Shape> shape) : shape_(std::move(shape)) {}

Region Region::rectangle(Vec2 at, Vec2 size) {
    const Vec2 far = at + size;
    return polygon({at, {far.x, at.y}, far, {at.x, far.y}});
}

Region Region::disc(Vec2 centre, double radius) { return Region(disc_shape(centre, radius)); }

Region Region::polygon(std::vector<Vec2> corners) { return Region(polygon_shape(std::move(corners))); }

Region Region::half_plane(Vec2 point, Vec2 outward) { return Region(half_plane_shape(point, outward)); }

Region Region::united(const Region& other) const {
    return Region(combined_shape(shape_, other.shape_, Combine::either));
}

Region Region::without(const Region& other) const {
    return Region(combined_shape(shape_, other.shape_, Combine::first_only));
}

Region Region::intersected(const Region& other) const {
    return Region(combined_shape(shape_, other.shape_, Combine::both));
}

Region Region::translated(Vec2 by) const { return Region(moved_shape(shape_, 0.0, by)); }

Region Region::rotated(double angle, Vec2 about) const {
    return Region(moved_shape(shape_, angle, about - turned(about, angle)));
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

const Pieces& Region::boundary() const { return shape_->boundary; }

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
