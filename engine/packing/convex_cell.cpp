#include "engine/packing/convex_cell.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace demlua::packing {

void ConvexCell::fill(const Box& box) {
    const Vec2 low = box.lower;
    const Vec2 high = box.upper;
    sides_ = {{low, {0.0, -1.0}, -low.y, nobody},
              {{high.x, low.y}, {1.0, 0.0}, high.x, nobody},
              {high, {0.0, 1.0}, high.y, nobody},
              {{low.x, high.y}, {-1.0, 0.0}, -low.x, nobody}};
}

bool ConvexCell::cut(Vec2 towards, double offset, Index across) {
    overhang_.clear();
    bool cuts = false;
    for (const Side& side : sides_) {
        overhang_.push_back(dot(side.from, towards) - offset);
        cuts = cuts || overhang_.back() > 0.0;
    }
    if (!cuts) return false;

    kept_.clear();
    for (std::size_t k = 0; k < sides_.size(); ++k) {
        const double here = overhang_[k];
        const double there = overhang_[k + 1 < sides_.size() ? k + 1 : 0];
        if (here <= 0.0) kept_.push_back(sides_[k]);
        if ((here <= 0.0) == (there <= 0.0)) continue;
        Side side = sides_[k];
        side.from += (here / (here - there)) * (end_of(k) - side.from);
        kept_.push_back(here <= 0.0 ? Side{side.from, towards, offset, across} : side);
    }
    std::swap(sides_, kept_);
    return true;
}

bool ConvexCell::borders(Index element) const {
    return std::any_of(sides_.begin(), sides_.end(), [element](const Side& side) { return side.across == element; });
}

bool ConvexCell::contains(Vec2 point) const {
    return !empty() && std::all_of(sides_.begin(), sides_.end(),
                                   [point](const Side& side) { return dot(point, side.towards) <= side.offset; });
}

model::Swept ConvexCell::swept() const {
    model::Swept sum;
    for (std::size_t k = 0; k < sides_.size(); ++k) sum += model::swept_by_chord(sides_[k].from, end_of(k));
    return sum;
}

double ConvexCell::reach() const {
    double square = 0.0;
    for (const Side& side : sides_) square = std::max(square, dot(side.from, side.from));
    return std::sqrt(square);
}

} // namespace demlua::packing
