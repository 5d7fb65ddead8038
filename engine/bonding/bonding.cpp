#include "engine/bonding/bonding.hpp"

#include <algorithm>
#include <nanoflann.hpp>
#include <numeric>

namespace demlua::bonding {

namespace {

/// Centres as nanoflann wants to see them.
struct Centres {
    const std::vector<Vec2>& points;

    [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t k, std::size_t axis) const {
        return axis == 0 ? points[k].x : points[k].y;
    }
    template <class Bounds>
    bool kdtree_get_bbox(Bounds& /*bounds*/) const {
        return false;
    }
};

using Metric = nanoflann::L2_Simple_Adaptor<double, Centres>;
using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Centres, 2, std::size_t>;

/// nanoflann 1.4 returns pairs, 1.5 and later a struct: both hold index and squared distance in this order.
#if NANOFLANN_VERSION >= 0x150
using Match = nanoflann::ResultItem<std::size_t, double>;
#else
using Match = std::pair<std::size_t, double>;
#endif

#if NANOFLANN_VERSION >= 0x150
using SearchSettings = nanoflann::SearchParameters;
#else
using SearchSettings = nanoflann::SearchParams;
#endif

} // namespace

std::vector<Pair> pairs_within(const std::vector<Vec2>& centre, const std::vector<double>& radius, double search) {
    std::vector<Pair> pairs;
    if (centre.size() < 2) return pairs;
    const Centres cloud{centre};
    const Tree tree(2, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
    const double largest = *std::max_element(radius.begin(), radius.end());
    SearchSettings settings;
    settings.sorted = false;
    std::vector<Match> found;
    for (std::size_t i = 0; i < centre.size(); ++i) {
        const double reach = (radius[i] + largest) * (1.0 + 0.5 * search);
        const double query[2] = {centre[i].x, centre[i].y};
        tree.radiusSearch(&query[0], reach * reach, found, settings);
        const std::size_t before = pairs.size();
        for (const Match& match : found) {
            const std::size_t j = match.first;
            const double touch = radius[i] + radius[j];
            if (j > i && norm(centre[j] - centre[i]) < touch * (1.0 + 0.5 * search)) pairs.emplace_back(i, j);
        }
        std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(before), pairs.end());
    }
    return pairs;
}

std::vector<Pair> pairs_within(const std::vector<Vec2>& centre, const std::vector<double>& radius, double search,
                               Period period) {
    if (!period.repeats() || centre.empty()) return pairs_within(centre, radius, search);
    const double reach = 2.0 * *std::max_element(radius.begin(), radius.end()) * (1.0 + 0.5 * search);
    const std::size_t n = centre.size();
    std::vector<Vec2> places = centre;
    std::vector<double> radii = radius;
    std::vector<std::size_t> element(n);
    std::iota(element.begin(), element.end(), std::size_t{0});
    for (std::size_t k = 0; k < n; ++k) {
        places[k].x += period.shift_inside(places[k].x);
        if (places[k].x - period.left > reach) continue;
        places.push_back(places[k] + Vec2{period.length, 0.0});
        radii.push_back(radius[k]);
        element.push_back(k);
    }
    std::vector<Pair> pairs;
    for (const auto& [a, b] : pairs_within(places, radii, search)) {
        if (a < n && element[a] != element[b]) pairs.emplace_back(std::minmax(element[a], element[b]));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

bool cut_crosses(Vec2 from, Vec2 to, Vec2 a, Vec2 b) {
    const double side_a = cross(to - from, a - from);
    const double side_b = cross(to - from, b - from);
    const double side_from = cross(b - a, from - a);
    const double side_to = cross(b - a, to - a);
    return side_a * side_b <= 0.0 && side_from * side_to <= 0.0;
}

} // namespace demlua::bonding
