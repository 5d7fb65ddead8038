#include "engine/packing/lloyd.hpp"

#include "engine/packing/clipping.hpp"
#include "engine/packing/convex_cell.hpp"
#include "engine/packing/nearest.hpp"

#include <algorithm>
#include <cmath>

namespace demlua::packing {

namespace {

/// An element's surroundings, found once and kept while the elements move little.
struct Surroundings {
    Vec2 centre;        ///< where the element stood then
    double reach = 0.0; ///< half the distance to the farthest of the neighbours: all within is decided by them, m
    std::size_t first = 0;
    std::size_t last = 0;
    bool deep = false; ///< the boundary is out of reach
    Vec2 pull;         ///< 1/m: what the cell's area times this adds to its centroid
};

class Lloyd {
public:
    Lloyd(std::vector<Vec2>& centre, const model::Region& region, const model::Spacing& size, std::size_t standing)
        : centre_(centre), region_(region), size_(size), standing_(standing), clipper_(region) {}

    void step() {
        if (!surroundings_hold()) look_around();
        for (std::size_t i = standing_; i < centre_.size(); ++i) target_[i] = middle_of_cell(i);
        for (std::size_t i = standing_; i < centre_.size(); ++i) {
            if (around_[i].deep || region_.distance(target_[i]) < 0.0) centre_[i] = target_[i];
        }
    }

private:
    static constexpr std::size_t neighbour_count = 24;
    static constexpr double largest_move = 0.1; ///< of the reach, with which surroundings still hold
    static constexpr double deep_inside = 1.6;  ///< reaches: more than from there to the corner of a square cell

    [[nodiscard]] bool surroundings_hold() const {
        if (around_.empty()) return false;
        for (std::size_t i = 0; i < centre_.size(); ++i) {
            if (norm(centre_[i] - around_[i].centre) > largest_move * around_[i].reach) return false;
        }
        return true;
    }

    void look_around() {
        target_ = centre_;
        around_.resize(centre_.size());
        neighbours_.clear();
        Nearest nearest(centre_, std::vector<double>(centre_.size(), 0.0));
        std::vector<Near> found;
        for (std::size_t i = 0; i < centre_.size(); ++i) {
            nearest.around(i, neighbour_count, found);
            Surroundings& here = around_[i];
            here.centre = centre_[i];
            here.reach =
                found.size() < neighbour_count ? norm(clipper_.box().size()) : 0.5 * std::sqrt(found.back().power);
            here.deep = region_.distance(centre_[i]) < -deep_inside * here.reach;
            here.first = neighbours_.size();
            for (const Near& near : found) {
                if (near.element != i) neighbours_.push_back(static_cast<Index>(near.element));
            }
            here.last = neighbours_.size();
            if (size_ && i >= standing_) here.pull = pull_at(centre_[i]);
        }
    }

    /// For a weight w the middle lies at centroid + I grad(w) / (A w) with the second moment of area I, 0.0802 A^2 in a
    /// hexagon; w = size^-4.
    [[nodiscard]] Vec2 pull_at(Vec2 point) const {
        constexpr double weight = -4.0 * 0.0802;
        const double here = size_(point);
        const double step = 0.25 * here;
        const auto slope = [&](Vec2 axis) {
            const Vec2 ahead = point + step * axis;
            const Vec2 behind = point - step * axis;
            const bool can_ahead = region_.contains(ahead);
            const bool can_behind = region_.contains(behind);
            if (!can_ahead && !can_behind) return 0.0;
            const double rise = (can_ahead ? size_(ahead) : here) - (can_behind ? size_(behind) : here);
            return rise / (can_ahead && can_behind ? 2.0 * step : step);
        };
        return (weight / here) * Vec2{slope({1.0, 0.0}), slope({0.0, 1.0})};
    }

    [[nodiscard]] Vec2 middle_of_cell(std::size_t i) {
        const Surroundings& here = around_[i];
        cut_cell(i, here);
        model::Swept swept;
        if (here.deep) {
            swept = cell_.swept();
        } else {
            clipper_.clip(cell_, centre_[i], clipped_);
            swept = clipped_.swept;
        }
        if (!(swept.area > 0.0)) return centre_[i];
        const Vec2 middle = centre_[i] + swept.moment / swept.area + swept.area * here.pull;
        return here.deep ? middle : off_the_boundary(middle, swept.area);
    }

    void cut_cell(std::size_t i, const Surroundings& here) {
        const Vec2 corner{here.reach, here.reach};
        cell_.fill({-corner, corner});
        double reach = cell_.reach();
        for (std::size_t n = here.first; n < here.last; ++n) {
            const Vec2 towards = centre_[neighbours_[n]] - centre_[i];
            const double square = dot(towards, towards);
            if (square >= 4.0 * reach * reach || square == 0.0) continue;
            if (cell_.cut(towards, 0.5 * square, neighbours_[n])) reach = cell_.reach();
        }
    }

    /// Cells that reach round the end of a slit have their middle near it or in it.
    [[nodiscard]] Vec2 off_the_boundary(Vec2 middle, double area) const {
        constexpr double least_depth = 0.4; // half the side of a square cell is 0.5
        const double missing = region_.distance(middle) + least_depth * std::sqrt(area);
        return missing > 0.0 ? middle - missing * region_.outward(middle) : middle;
    }

    std::vector<Vec2>& centre_;
    const model::Region& region_;
    const model::Spacing& size_;
    std::size_t standing_;
    Clipper clipper_;
    std::vector<Surroundings> around_;
    std::vector<Index> neighbours_;
    std::vector<Vec2> target_;
    ConvexCell cell_;     ///< scratch
    ClippedCell clipped_; ///< scratch
};

} // namespace

void relax(std::vector<Vec2>& centre, const model::Region& region, const model::Spacing& size, int steps,
           std::size_t standing) {
    Lloyd lloyd(centre, region, size, standing);
    for (int k = 0; k < steps; ++k) lloyd.step();
}

} // namespace demlua::packing
