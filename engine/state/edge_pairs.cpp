#include "engine/state/edge_pairs.hpp"

#include "engine/bonding/bonding.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <string>
#include <utility>

namespace demlua::state {

namespace {

/// Calls `work(i, j, distance)` for elements i and j of which one overlaps the image of the other one period on.
template <class Work>
void for_each_across(const State& state, const Work& work) {
    const std::size_t n = state.elements.size();
    std::vector<Vec2> centre;
    std::vector<double> radius;
    for (const double shift : {0.0, state.period.length}) {
        for (std::size_t k = 0; k < n; ++k) {
            centre.push_back(state.elements.position(k) + Vec2{shift, 0.0});
            radius.push_back(state.elements.radius[k]);
        }
    }
    for (const auto& [i, j] : bonding::pairs_within(centre, radius, 0.0)) {
        if (i < n && j >= n && i != j - n) work(i, j - n, norm(centre[j] - centre[i]));
    }
}

} // namespace

std::vector<Problem> overlaps_across_edge(const model::Scene& scene, const State& state) {
    std::vector<Problem> problems;
    if (!state.period.repeats()) return problems;
    constexpr double most = 0.01;
    const Elements& elements = state.elements;
    std::map<std::pair<std::size_t, std::size_t>, double> deepest;
    for_each_across(state, [&](std::size_t i, std::size_t j, double distance) {
        const auto pair = std::minmax(elements.body[i], elements.body[j]);
        const bool together = pair.first == pair.second && state.bodies[pair.first].rigid &&
                              (!state.bodies[pair.first].in_clusters || elements.cluster[i] == elements.cluster[j]);
        if (together) return;
        const double touch = elements.radius[i] + elements.radius[j];
        double& deep = deepest[pair];
        deep = std::max(deep, (touch - distance) / touch);
    });
    for (const auto& [pair, deep] : deepest) {
        if (deep < most) continue;
        const std::string other =
            pair.first == pair.second ? "itself" : "body \"" + scene.bodies[pair.first].name + '"';
        problems.push_back(
            {scene.bodies[pair.second].place, "body.region", '"' + scene.bodies[pair.second].name + '"',
             fmt::format("overlaps {} across the edge of the periodic box at the start, by {:.0f} % of a "
                         "diameter",
                         other, 100.0 * deep),
             "leave room at the edges, or make the box wider"});
    }
    return problems;
}

} // namespace demlua::state
