#include "engine/model/boundary.hpp"

namespace demlua::model {

Piece straight_piece(Vec2 from, Vec2 to) {
    const double length = norm(to - from);
    return {from, (to - from) / length, 0.0, 0.0, length, false};
}

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

namespace {

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

} // namespace

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

double swept_area(const Piece& piece, Vec2 about) {
    const Vec2 from = piece.at(piece.begin) - about;
    const Vec2 to = piece.at(piece.end) - about;
    if (piece.straight()) return 0.5 * cross(from, to);
    const double sector = piece.radius * piece.radius * (piece.end - piece.begin);
    const double area = 0.5 * (sector + cross(piece.origin - about, to - from));
    return piece.around_hole ? -area : area;
}

namespace {

/// angle - sin(angle) without cancellation.
double less_its_sine(double angle) {
    if (angle > 0.3) return angle - std::sin(angle);
    const double square = angle * angle;
    return angle * square / 6.0 *
           (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0 * (1.0 - square / 110.0))));
}

} // namespace

Swept swept(const Piece& piece, Vec2 about) {
    const Vec2 from = piece.at(piece.begin) - about;
    const Vec2 to = piece.at(piece.end) - about;
    Swept sum = swept_by_chord(from, to);
    if (piece.straight()) return sum;

    const double angle = piece.end - piece.begin;
    const double rest = less_its_sine(angle);
    const double sine = std::sin(0.5 * angle);
    const double arm = 4.0 * piece.radius * sine * sine * sine / (3.0 * rest);
    const double middle = 0.5 * (piece.begin + piece.end);
    const Vec2 centroid = piece.origin + arm * Vec2{std::cos(middle), std::sin(middle)} - about;
    const double segment = 0.5 * piece.radius * piece.radius * rest;
    sum += {segment, segment * centroid};
    return piece.around_hole ? Swept{-sum.area, -sum.moment} : sum;
}

// --- boxes -------------------------------------------------------------------------------------------------

namespace {

void include(Box& box, Vec2 point) {
    box.lower = {std::min(box.lower.x, point.x), std::min(box.lower.y, point.y)};
    box.upper = {std::max(box.upper.x, point.x), std::max(box.upper.y, point.y)};
}

/// `s` metres along a line, sound for an infinite `s`.
double component_at(double origin, double direction, double s) {
    if (std::isinf(s) && std::abs(direction) <= parallel) return origin;
    return origin + s * direction;
}

} // namespace

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

void open_towards(Box& box, Vec2 direction) {
    if (direction.x > parallel) box.upper.x = infinity;
    if (direction.x < -parallel) box.lower.x = -infinity;
    if (direction.y > parallel) box.upper.y = infinity;
    if (direction.y < -parallel) box.lower.y = -infinity;
}

std::vector<double> angles_of_rays(const Pieces& pieces) {
    std::vector<double> angles;
    for (const Piece& piece : pieces) {
        if (std::isinf(piece.end)) angles.push_back(std::atan2(piece.direction.y, piece.direction.x));
        if (std::isinf(piece.begin)) angles.push_back(std::atan2(-piece.direction.y, -piece.direction.x));
    }
    std::sort(angles.begin(), angles.end());
    return angles;
}

} // namespace demlua::model
