#include "engine/step/places.hpp"

#include <cstddef>

namespace demlua::step {

Places places_of(const state::State& state, double reach) {
    Places places;
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        if (state.is_gone(k)) continue;
        Vec2 at = state.elements.position(k);
        if (state.period.repeats()) at.x += state.period.shift_inside(at.x);
        places.at.push_back(at);
        places.element.push_back(static_cast<Index>(k));
    }
    places.first_image = places.at.size();
    if (!state.period.repeats()) return places;
    for (std::size_t p = 0; p < places.first_image; ++p) {
        if (places.at[p].x - state.period.left > reach) continue;
        places.at.push_back(places.at[p] + Vec2{state.period.length, 0.0});
        places.element.push_back(places.element[p]);
    }
    return places;
}

} // namespace demlua::step
