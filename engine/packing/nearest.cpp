#include "engine/packing/nearest.hpp"

#include <algorithm>
#include <cmath>

namespace demlua::packing {

namespace {

constexpr std::size_t leaf_size = 8;

std::vector<std::array<double, 3>> lifted(const std::vector<Vec2>& centre, const std::vector<double>& radius) {
    const double largest = radius.empty() ? 0.0 : *std::max_element(radius.begin(), radius.end());
    std::vector<std::array<double, 3>> points;
    for (std::size_t k = 0; k < centre.size(); ++k) {
        const double height = std::sqrt((largest - radius[k]) * (largest + radius[k]));
        points.push_back({centre[k].x, centre[k].y, height});
    }
    return points;
}

} // namespace

Nearest::Nearest(const std::vector<Vec2>& centre, const std::vector<double>& radius)
    : points_(lifted(centre, radius)), cloud_{points_},
      tree_(3, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size)) {}

double Nearest::power(Vec2 point, std::size_t i) const {
    const Vec2 arm = point - Vec2{points_[i][0], points_[i][1]};
    return dot(arm, arm) + points_[i][2] * points_[i][2];
}

Near Nearest::owner(Vec2 point) const {
    const Point place{point.x, point.y, 0.0};
    Near found;
    tree_.knnSearch(place.data(), 1, &found.element, &found.power);
    return found;
}

void Nearest::around(std::size_t i, std::size_t count, std::vector<Near>& found) {
    elements_.resize(count);
    distances_.resize(count);
    const std::size_t there = tree_.knnSearch(points_[i].data(), count, elements_.data(), distances_.data());
    found.clear();
    for (std::size_t k = 0; k < there; ++k) found.push_back({elements_[k], distances_[k]});
}

} // namespace demlua::packing
