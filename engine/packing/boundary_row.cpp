#include "engine/packing/boundary_row.hpp"

#include "engine/base/problems.hpp"
#include "engine/base/random.hpp"
#include "engine/packing/growth.hpp"
#include "engine/packing/sowing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace demlua::packing {

namespace {

using model::Piece;
using model::Pieces;

constexpr double smooth_turn = 0.3; ///< rad

/// A piece walked with the region on the left: an arc around a hole is walked from its end to its beginning.
bool backwards(const Piece& piece) { return !piece.straight() && piece.around_hole; }

double walked(const Piece& piece, double share) {
    return backwards(piece) ? piece.end - share * (piece.end - piece.begin)
                            : piece.begin + share * (piece.end - piece.begin);
}

Vec2 place_on(const Piece& piece, double share) { return piece.at(walked(piece, share)); }

Vec2 heading_on(const Piece& piece, double share) { return turned_left(piece.outward(walked(piece, share))); }

double length_of(const Piece& piece) {
    const double extent = piece.end - piece.begin;
    return piece.straight() ? extent : piece.radius * extent;
}

/// The pieces as closed loops, each in the order in which it is walked.
std::vector<Pieces> loops_of(Pieces pieces) {
    std::vector<Pieces> loops;
    while (!pieces.empty()) {
        Pieces loop{pieces.back()};
        pieces.pop_back();
        const Vec2 start = place_on(loop.front(), 0.0);
        while (!pieces.empty()) {
            const Vec2 end = place_on(loop.back(), 1.0);
            const auto gap = [end](const Piece& piece) { return norm(place_on(piece, 0.0) - end); };
            const auto next = std::min_element(pieces.begin(), pieces.end(),
                                               [&](const Piece& a, const Piece& b) { return gap(a) < gap(b); });
            if (norm(start - end) <= gap(*next)) break;
            loop.push_back(*next);
            pieces.erase(next);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

bool corner_between(const Piece& before, const Piece& after) {
    return dot(heading_on(before, 1.0), heading_on(after, 0.0)) < std::cos(smooth_turn);
}

/// A stretch of boundary, measured in elements from its beginning.
class Stretch {
public:
    Stretch(Pieces pieces, const model::Spacing& size) : pieces_(std::move(pieces)) {
        for (std::size_t k = 0; k < pieces_.size(); ++k) measure(k, size);
    }

    /// How many elements long it is.
    [[nodiscard]] double elements() const { return marks_.back().elements; }

    /// The place so many elements from its beginning.
    [[nodiscard]] Vec2 at(double elements) const {
        const auto after = std::upper_bound(marks_.begin() + 1, marks_.end() - 1, elements,
                                            [](double value, const Mark& mark) { return value < mark.elements; });
        const Mark& before = *(after - 1);
        const double share = (elements - before.elements) / (after->elements - before.elements);
        const double from = before.piece == after->piece ? before.share : 0.0;
        return place_on(pieces_[after->piece], from + share * (after->share - from));
    }

private:
    struct Mark {
        std::size_t piece;
        double share;    ///< of the piece
        double elements; ///< from the beginning of the stretch
    };

    /// Marks a piece about four times per element: between marks elements stand evenly.
    void measure(std::size_t piece, const model::Spacing& size) {
        const Piece& path = pieces_[piece];
        const double length = length_of(path);
        if (marks_.empty()) marks_.push_back({piece, 0.0, 0.0});
        double elements = marks_.back().elements;
        double walked_so_far = 0.0;
        double here = size(place_on(path, 0.0));
        while (walked_so_far < length) {
            const double end = std::min(length, walked_so_far + 0.25 * here);
            const double there = size(place_on(path, end / length));
            elements += 0.5 * (end - walked_so_far) * (1.0 / here + 1.0 / there);
            marks_.push_back({piece, end / length, elements});
            if (elements > most_elements) {
                throw RunError(
                    "relaxed pack: more than ten million elements would stand on the boundary; ask for larger "
                    "ones");
            }
            walked_so_far = end;
            here = there;
        }
    }

    Pieces pieces_;
    std::vector<Mark> marks_;
};

/// Stands elements evenly on a stretch, one at its beginning and none at its end.
void stand(const Stretch& stretch, double least, double start, std::vector<Vec2>& places) {
    const double count = std::max(least, std::round(stretch.elements()));
    const double step = stretch.elements() / count;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        places.push_back(stretch.at((static_cast<double>(k) + start) * step));
    }
}

} // namespace

std::vector<Vec2> boundary_row(const model::Region& region, const model::Spacing& size, std::uint64_t seed) {
    std::vector<Vec2> places;
    std::uint64_t number = 0;
    for (Pieces& loop : loops_of(region.boundary())) {
        const std::size_t count = loop.size();
        std::size_t first = 0;
        while (first < count && !corner_between(loop[(first + count - 1) % count], loop[first])) ++first;
        if (first == count) {
            stand(Stretch(std::move(loop), size), 3.0, uniform(seed, offsets, number++), places);
            continue;
        }
        std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
        Pieces run;
        for (std::size_t k = 0; k < count; ++k) {
            run.push_back(loop[k]);
            if (!corner_between(loop[k], loop[(k + 1) % count])) continue;
            stand(Stretch(std::move(run), size), 1.0, 0.0, places);
            run.clear();
        }
    }
    return places;
}

} // namespace demlua::packing
