#include "engine/step/removal.hpp"

#include "engine/state/parts.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace demlua::step {

namespace {

bool has_left(const state::State& state, const model::Region& domain, std::size_t k) {
    if (state.is_gone(k)) return false;
    Vec2 at = state.elements.position(k);
    if (state.period.repeats()) at.x += state.period.shift_inside(at.x);
    return !domain.contains(at);
}

/// Of something of this mass or inertia that nothing but `force` acts on.
double kinetic(double mass, double v, double force, double dt) { return 0.5 * mass * v * (v + dt * force / mass); }

void stop_element(state::State& state, std::size_t k) {
    state::Elements& elements = state.elements;
    const double m = elements.mass(k);
    state.booked.removed += kinetic(m, elements.vx[k], m * state.gravity.x, state.dt) +
                            kinetic(m, elements.vy[k], m * state.gravity.y, state.dt) +
                            kinetic(elements.inertia(k), elements.spin[k], 0.0, state.dt);
    elements.vx[k] = elements.vy[k] = elements.spin[k] = 0.0;
}

void stop_rigid(state::State& state, state::RigidBody& rigid) {
    state.booked.removed += kinetic(rigid.mass, rigid.velocity.x, rigid.mass * state.gravity.x, state.dt) +
                            kinetic(rigid.mass, rigid.velocity.y, rigid.mass * state.gravity.y, state.dt) +
                            kinetic(rigid.inertia, rigid.spin, 0.0, state.dt);
    rigid.velocity = {};
    rigid.spin = 0.0;
}

/// Holds elements and rigid bodies where they are, at no work.
void hold(state::State& state, const std::vector<Index>& elements, const std::vector<std::size_t>& rigid) {
    constexpr std::array freedoms{state::Freedom::x, state::Freedom::y, state::Freedom::rotation};
    if (!state.holding_gone) {
        state.holding_gone = state.drives.size();
        for (const state::Freedom freedom : freedoms) {
            state::Drive drive;
            drive.freedom = freedom;
            drive.value = Signal::constant(0.0);
            state.drives.push_back(std::move(drive));
        }
    }
    for (std::size_t n = 0; n < freedoms.size(); ++n) {
        state::Drive& drive = state.drives[*state.holding_gone + n];
        drive.element.insert(drive.element.end(), elements.begin(), elements.end());
        drive.reaction.resize(drive.element.size());
        drive.rigid.insert(drive.rigid.end(), rigid.begin(), rigid.end());
        drive.rigid_reaction.resize(drive.rigid.size());
    }
}

} // namespace

std::size_t remove_leavers(state::State& state, const model::Region& domain) {
    bool some = false;
    for (std::size_t k = 0; k < state.elements.size() && !some; ++k) some = has_left(state, domain, k);
    if (!some) return 0;
    std::vector<Index> leaving;
    std::vector<std::size_t> rigid;
    std::size_t count = 0;
    for (const std::vector<std::size_t>& part : state::elements_of_parts(state)) {
        if (!std::all_of(part.begin(), part.end(), [&](std::size_t k) { return has_left(state, domain, k); })) continue;
        for (const std::size_t k : part) {
            leaving.push_back(static_cast<Index>(k));
            state.gone[k] = 1;
        }
        count += part.size();
        if (const auto row = state.rigid_of(part.front())) {
            rigid.push_back(*row);
            stop_rigid(state, state.rigid_bodies[*row]);
        } else {
            for (const std::size_t k : part) stop_element(state, k);
        }
    }
    std::erase_if(leaving, [&](Index k) { return state.rigid_of(k).has_value(); });
    if (!leaving.empty() || !rigid.empty()) hold(state, leaving, rigid);
    return count;
}

} // namespace demlua::step
