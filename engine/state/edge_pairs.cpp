#include "engine/state/edge_pairs.hpp"

#include "engine/bonding/bonding.hpp"

#include <vector>

namespace demlua::state {

std::size_t pairs_across_edge(const State& state, const Body& body, double search) {
    if (!state.period.repeats()) return 0;
    const Elements& elements = state.elements;
    const std::size_t n = body.size();
    std::vector<Vec2> centre;
    std::vector<double> radius;
    for (const double shift : {0.0, state.period.length}) {
        for (std::size_t k = body.first; k < body.last; ++k) {
            centre.push_back(elements.position(k) + Vec2{shift, 0.0});
            radius.push_back(elements.radius[k]);
        }
    }
    std::size_t count = 0;
    for (const auto& [i, j] : bonding::pairs_within(centre, radius, search)) {
        if (i >= n || j < n) continue;
        const std::size_t a = body.first + i;
        const std::size_t b = body.first + j - n;
        const bool together = !body.in_clusters || elements.cluster[a] == elements.cluster[b];
        count += together && a != b ? 1 : 0;
    }
    return count;
}

} // namespace demlua::state
