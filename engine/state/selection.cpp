#include "engine/state/selection.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace demlua::state {

namespace {

/// How far element k stands towards a side.
double place_towards(model::Side side, const Elements& elements, std::size_t k) {
    const Vec2 at = elements.position(k);
    switch (side) {
    case model::Side::left:
        return -at.x;
    case model::Side::right:
        return at.x;
    case model::Side::bottom:
        return -at.y;
    case model::Side::top:
        return at.y;
    }
    return 0.0;
}

/// The elements of one side: those whose disks reach about as far as any, and those whose centres stand about as far as any,
/// to half a radius. Unequal elements inside a wall share the first, on a wall the second.
struct Front {
    model::Side side;
    double reach = -std::numeric_limits<double>::infinity();
    double centre = -std::numeric_limits<double>::infinity();

    Front(model::Side towards, const Elements& elements, std::size_t first, std::size_t last) : side(towards) {
        for (std::size_t k = first; k < last; ++k) {
            const double place = place_towards(side, elements, k);
            centre = std::max(centre, place);
            reach = std::max(reach, place + elements.radius[k]);
        }
    }
    [[nodiscard]] bool holds(const Elements& elements, std::size_t k) const {
        const double place = place_towards(side, elements, k);
        const double R = elements.radius[k];
        return place + R >= reach - 0.5 * R || place >= centre - 0.5 * R;
    }
};

} // namespace

Column<Index> selected(const model::Selection& selection, const State& state) {
    const Elements& elements = state.elements;
    std::size_t first = 0;
    std::size_t last = elements.size();
    if (selection.body) {
        first = state.bodies[*selection.body].first;
        last = state.bodies[*selection.body].last;
    }
    std::optional<Front> front;
    if (selection.side) front.emplace(*selection.side, elements, first, last);
    Column<Index> rows;
    for (std::size_t k = first; k < last; ++k) {
        const Vec2 at = elements.position(k);
        if (front && !front->holds(elements, k)) continue;
        if (selection.within && !selection.within->contains(at)) continue;
        if (selection.where && !selection.where(at)) continue;
        rows.push_back(static_cast<Index>(k));
    }
    return rows;
}

} // namespace demlua::state
