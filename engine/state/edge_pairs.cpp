#include "engine/state/edge_pairs.hpp"

#include "engine/bonding/bonding.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <string>
#include <utility>

namespace demlua::state {

namespace {

struct Disks {
    std::vector<Vec2> centre;
    std::vector<double> radius;
};

/// Elements [first, last) and after them the same one period on.
Disks with_images(const State& state, std::size_t first, std::size_t last) {
    Disks disks;
    for (const double shift : {0.0, state.period.length}) {
        for (std::size_t k = first; k < last; ++k) {
            disks.centre.push_back(state.elements.position(k) + Vec2{shift, 0.0});
            disks.radius.push_back(state.elements.radius[k]);
        }
    }
    return disks;
}

/// Calls `work(i, j, distance)` for elements i and j of [first, last) whose images have a gap below `search` of their mean
/// radius.
template <class Work>
void for_each_across(const State& state, std::size_t first, std::size_t last, double search, const Work& work) {
    const std::size_t n = last - first;
    const Disks disks = with_images(state, first, last);
    for (const auto& [i, j] : bonding::pairs_within(disks.centre, disks.radius, search)) {
        if (i < n && j >= n && i != j - n) work(first + i, first + j - n, norm(disks.centre[j] - disks.centre[i]));
    }
}

} // namespace

std::size_t pairs_across_edge(const State& state, const Body& body, double search) {
    if (!state.period.repeats()) return 0;
    std::size_t count = 0;
    for_each_across(state, body.first, body.last, search, [&](std::size_t i, std::size_t j, double /*distance*/) {
        count += !body.in_clusters || state.elements.cluster[i] == state.elements.cluster[j] ? 1 : 0;
    });
    return count;
}

std::vector<Problem> overlaps_across_edge(const model::Scene& scene, const State& state) {
    std::vector<Problem> problems;
    if (!state.period.repeats()) return problems;
    constexpr double most = 0.01;
    const Elements& elements = state.elements;
    std::map<std::pair<std::size_t, std::size_t>, double> deepest;
    for_each_across(state, 0, elements.size(), 0.0, [&](std::size_t i, std::size_t j, double distance) {
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
