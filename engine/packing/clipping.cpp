#include "engine/packing/clipping.hpp"

#include <algorithm>
#include <cmath>

namespace demlua::packing {

using model::Piece;

namespace {

/// As much room around the region as it has itself: no side of the box may run along its boundary.
Box widened(const Box& box) {
    const double size = std::max(box.size().x, box.size().y);
    return {box.lower - Vec2{size, size}, box.upper + Vec2{size, size}};
}

double largest_coordinate(const Box& box) {
    return std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.upper.x), std::abs(box.upper.y)});
}

} // namespace

Clipper::Clipper(const model::Region& region)
    : region_(region), box_(widened(region.bounds())), near_(1e-13 * largest_coordinate(box_)) {}

void Clipper::clip(const ConvexCell& cell, Vec2 centre, ClippedCell& clipped) {
    clipped.swept = {};
    clipped.sides.clear();
    centre_ = centre;
    const double reach = cell.reach();
    const double distance = region_.distance(centre);
    if (distance >= reach) return;
    pieces_.clear();
    if (distance > -reach) find_pieces(reach);

    lines_.clear();
    for (std::size_t k = 0; k < cell.sides().size(); ++k) {
        const Vec2 from = cell.sides()[k].from;
        const Vec2 to = cell.end_of(k);
        if (norm(to - from) <= near_) continue;
        lines_.push_back(model::straight_piece(from, to));
        clip_side(k, to, clipped);
    }
    follow_boundary(cell, clipped);
}

void Clipper::find_pieces(double reach) {
    for (Piece piece : region_.boundary()) {
        piece.origin = piece.origin - centre_;
        if (piece.distance({}) < reach + near_) pieces_.push_back(piece);
    }
}

/// A side that runs along the boundary is left to the boundary.
bool Clipper::inside(Vec2 point) const { return pieces_.empty() || region_.distance(centre_ + point) < -near_; }

void Clipper::clip_side(std::size_t side, Vec2 to, ClippedCell& clipped) {
    SidePart longest{side, {}, {}, {}, {}};
    SidePart run = longest;
    bool running = false;
    const auto length = [](const SidePart& part) { return norm(part.to - part.from); };
    for (const Piece& part : cut(lines_.back(), pieces_, near_)) {
        const Vec2 end = part.end == lines_.back().end ? to : part.at(part.end);
        if (inside(part.at(0.5 * (part.begin + part.end)))) {
            if (!running) run.from = part.at(part.begin);
            run.to = end;
            running = true;
            clipped.swept += model::swept(part, {});
        } else {
            running = false;
        }
        if (running && length(run) > length(longest)) longest = run;
    }
    if (length(longest) == 0.0) return;
    longest.outward_from = outward_at(longest.from);
    longest.outward_to = outward_at(longest.to);
    clipped.sides.push_back(longest);
}

/// A stretch of boundary belongs to the cell that lies on the region's side of it.
void Clipper::follow_boundary(const ConvexCell& cell, ClippedCell& clipped) const {
    for (const Piece& piece : pieces_) {
        for (const Piece& part : cut(piece, lines_, near_)) {
            const double middle = 0.5 * (part.begin + part.end);
            if (cell.contains(part.at(middle) - near_ * part.outward(middle))) {
                clipped.swept += model::swept(part, {});
            }
        }
    }
}

Vec2 Clipper::outward_at(Vec2 point) const {
    constexpr double slack = 100.0; // a side that grazes the boundary meets it less sharply
    const model::Foot foot = model::nearest_foot(pieces_, point);
    return foot.distance <= slack * near_ ? foot.piece->outward(foot.s) : Vec2{};
}

} // namespace demlua::packing
