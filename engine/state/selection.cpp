#include "engine/state/selection.hpp"

#include <algorithm>
#include <limits>

namespace demlua::state {

namespace {

/// How far the disk of element k reaches towards a side.
double reach_towards(model::Side side, const Elements& elements, std::size_t k) {
    const Vec2 at = elements.position(k);
    switch (side) {
    case model::Side::left:
        return elements.radius[k] - at.x;
    case model::Side::right:
        return elements.radius[k] + at.x;
    case model::Side::bottom:
        return elements.radius[k] - at.y;
    case model::Side::top:
        return elements.radius[k] + at.y;
    }
    return 0.0;
}

} // namespace

Column<Index> selected(const model::Selection& selection, const State& state) {
    const Elements& elements = state.elements;
    std::size_t first = 0;
    std::size_t last = elements.size();
    if (selection.body) {
        first = state.bodies[*selection.body].first;
        last = state.bodies[*selection.body].last;
    }
    double extreme = -std::numeric_limits<double>::infinity();
    if (selection.side) {
        for (std::size_t k = first; k < last; ++k) {
            extreme = std::max(extreme, reach_towards(*selection.side, elements, k));
        }
    }
    Column<Index> rows;
    for (std::size_t k = first; k < last; ++k) {
        const Vec2 at = elements.position(k);
        if (selection.side && reach_towards(*selection.side, elements, k) < extreme - 0.5 * elements.radius[k]) {
            continue;
        }
        if (selection.within && !selection.within->contains(at)) continue;
        if (selection.where && !selection.where(at)) continue;
        rows.push_back(static_cast<Index>(k));
    }
    return rows;
}

} // namespace demlua::state
