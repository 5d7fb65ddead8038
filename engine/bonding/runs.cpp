#include "engine/bonding/runs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace demlua::bonding {

namespace {

/// Counter-clockwise from 30 degrees below the x axis, rad: no direction of close packing lies where it jumps.
double direction(Vec2 from, Vec2 to) {
    constexpr double turn = 2.0 * std::numbers::pi;
    const Vec2 D = to - from;
    return std::fmod(std::atan2(D.y, D.x) + turn + turn / 12.0, turn);
}

/// Row of the first pair of every element, and one past the last.
std::vector<std::size_t> first_of_each(const std::vector<Pair>& pairs, std::size_t elements) {
    std::vector<std::size_t> first(elements + 1, 0);
    for (const auto& [i, j] : pairs) ++first[i + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    return first;
}

} // namespace

std::vector<std::size_t> order_in_runs(const std::vector<Pair>& pairs, const std::vector<Vec2>& centre) {
    std::vector<double> directions;
    directions.reserve(pairs.size());
    for (const auto& [i, j] : pairs) directions.push_back(direction(centre[i], centre[j]));

    const std::vector<std::size_t> first = first_of_each(pairs, centre.size());
    std::vector<std::size_t> ranked(pairs.size());
    std::iota(ranked.begin(), ranked.end(), std::size_t{0});
    const auto at = [&](std::size_t row) { return ranked.begin() + static_cast<std::ptrdiff_t>(row); };
    for (std::size_t e = 0; e < centre.size(); ++e) {
        std::sort(at(first[e]), at(first[e + 1]), [&](std::size_t a, std::size_t b) {
            return std::tie(directions[a], a) < std::tie(directions[b], b);
        });
    }

    std::vector<std::size_t> order;
    order.reserve(pairs.size());
    for (std::size_t begin = 0; begin < centre.size(); begin += run_block) {
        const std::size_t end = std::min(begin + run_block, centre.size());
        for (std::size_t rank = 0; order.size() < first[end]; ++rank) {
            for (std::size_t e = begin; e < end; ++e) {
                if (first[e] + rank < first[e + 1]) order.push_back(ranked[first[e] + rank]);
            }
        }
    }
    return order;
}

} // namespace demlua::bonding
