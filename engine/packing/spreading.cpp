#include "engine/packing/spreading.hpp"

#include "engine/base/cell_grid.hpp"
#include "engine/base/random.hpp"
#include "engine/packing/growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace demlua::packing {
namespace {

// Found by trial on packs of 1 to 12,000 elements.
constexpr double spread_coverage = 0.75; ///< share of the region that circles around the clusters cover first
constexpr double first_size = 0.3;       ///< size at which those are put down, as a share

/// Places one after another, spread evenly over a region and yet at random: every part of the region gets its
/// share, so that no part ends up with more than fits. They follow the R2 sequence (Roberts 2018: steps by
/// the powers of the root of x^3 = x + 1), each shaken by up to half the distance of neighbours.
class Sprinkler {
public:
    Sprinkler(const model::Region& region, double area, std::size_t count, std::uint64_t seed)
        : region_(region), box_(region.bounds()), seed_(seed), shake_(std::sqrt(area / static_cast<double>(count))) {}

    /// The next place at least `clearance` (m) from the boundary; where none comes by, the roomiest that did.
    Vec2 next(double clearance) {
        constexpr int tries = 2000;
        Vec2 best;
        double depth = -std::numeric_limits<double>::infinity();
        for (int k = 0; k < tries && depth < clearance; ++k) {
            const Vec2 point = trial(drawn_++);
            const double inside = -region_.distance(point);
            if (inside <= depth) continue;
            best = point;
            depth = inside;
        }
        return best;
    }

private:
    [[nodiscard]] Vec2 trial(std::uint64_t number) const {
        constexpr Vec2 stride{0.7548776662466927, 0.5698402909980532};
        const auto n = static_cast<double>(number);
        const Vec2 even{std::fmod(uniform(seed_, offsets, 0) + n * stride.x, 1.0),
                        std::fmod(uniform(seed_, offsets, 1) + n * stride.y, 1.0)};
        const Vec2 shaken{uniform(seed_, across, number) - 0.5, uniform(seed_, upwards, number) - 0.5};
        return box_.lower + Vec2{even.x * box_.size().x, even.y * box_.size().y} + shake_ * shaken;
    }

    const model::Region& region_;
    Box box_;
    std::uint64_t seed_;
    double shake_;
    std::uint64_t drawn_ = 0;
};

/// Neighbours get near numbers, so that the loops over pairs find them in the cache.
std::vector<Vec2> sorted_by_cell(const std::vector<Vec2>& points, double cell) {
    CellGrid grid;
    grid.build(points, cell);
    std::vector<Vec2> sorted;
    for (const Index k : grid.order()) sorted.push_back(points[k]);
    return sorted;
}

} // namespace

Middles spread(const model::Region& region, double area, const std::vector<double>& sizes, double circle,
               std::uint64_t seed) {
    double squares = 0.0;
    for (const double size : sizes) squares += size * size;
    circle = std::min(circle, std::sqrt(spread_coverage * area / (std::numbers::pi * squares)));
    Sprinkler sprinkler(region, area, sizes.size(), seed);
    std::vector<Vec2> at;
    for (std::size_t k = 0; k < sizes.size(); ++k) at.push_back(sprinkler.next(first_size * circle));
    Growth circles(region, cluster_shape(1), sizes, circle);
    circles.put_down(sorted_by_cell(at, 4.0 * circle), first_size * circle, seed);
    grow(circles, circle);
    return {circles.disks(), circle};
}

} // namespace demlua::packing
