#include "engine/step/wall_forces.hpp"

#include "engine/base/problems.hpp"
#include "engine/step/outline_forces.hpp"
#include "engine/step/wall_parts.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <vector>

namespace demlua::step {

namespace {

constexpr std::size_t no_row = std::numeric_limits<std::size_t>::max();

void release(state::WallContacts& contacts, std::size_t c) {
    contacts.fx[c] = contacts.fy[c] = contacts.moment[c] = contacts.turning[c] = 0.0;
}

bool at_rest(const state::ContactHistory& history) { return history.force == 0.0 && history.damping == 0.0; }

/// The couple against rolling on the element.
double rolling_moment(state::State& state, std::size_t c, double pressure) {
    state::WallContacts& contacts = state.wall_contacts;
    state::RollingContacts& rolling = contacts.rolling;
    const Index e = contacts.element[c];
    const Index w = contacts.wall[c];
    law::Rolling::History<double> history = rolling.history.at(c);
    const double cap = state::wall_rule(state, w, e).rolling_friction * rolling.radius[c] * pressure;
    const double turning = state.walls[w].spin - state.elements.spin[e];
    law::Spent<double> spent = rolling.spent.at(c);
    const double moment = law::Rolling::respond<double>({rolling.stiffness[c], rolling.dashpot[c], cap, turning},
                                                        state.dt, history, spent);
    rolling.history.store(c, history);
    rolling.spent.store(c, spent);
    return moment;
}

/// Whether the element of row `c` has more rows with the same wall.
bool has_others(const state::WallContacts& contacts, std::size_t c) {
    const auto same = [&](std::size_t other) {
        return contacts.wall[other] == contacts.wall[c] && contacts.element[other] == contacts.element[c];
    };
    return (c > 0 && same(c - 1)) || (c + 1 < contacts.size() && same(c + 1));
}

/// Whether the element has just come to this part of the wall or just left it, so that its contact may be passed on.
bool passes(const state::State& state, std::size_t c, bool meets, double overlap,
            const state::ContactHistory& history) {
    const state::WallContacts& contacts = state.wall_contacts;
    if (!(at_rest(history) ? overlap > 0.0 : !meets) || !has_others(contacts, c)) return false;
    return contacts.Cn[c] > 0.0 || state::wall_rule(state, contacts.wall[c], contacts.element[c]).mu > 0.0;
}

/// Hands what contacts remember that leave a part of a wall on to those that have come to the part beside it. `waiting` are
/// rows in rising order.
void pass_on(state::State& state, const std::vector<std::size_t>& waiting) {
    state::WallContacts& contacts = state.wall_contacts;
    const auto hand_over = [](auto& columns, std::size_t from, std::size_t to) {
        columns.store(to, columns.at(from));
        columns.store(from, {});
    };
    const auto can_take = [&](std::size_t from, std::size_t to) {
        return contacts.wall[from] == contacts.wall[to] && contacts.element[from] == contacts.element[to] &&
               contacts.overlap[to] > 0.0 && at_rest(contacts.history.at(to)) &&
               are_neighbours(state.walls[contacts.wall[to]], contacts.part[from], contacts.part[to]);
    };
    for (const std::size_t from : waiting) {
        if (at_rest(contacts.history.at(from))) continue;
        const auto to =
            std::find_if(waiting.begin(), waiting.end(), [&](std::size_t row) { return can_take(from, row); });
        if (to == waiting.end()) continue;
        hand_over(contacts.history, from, *to);
        if (contacts.rolling.present()) hand_over(contacts.rolling.history, from, *to);
    }
}

/// Fills the forces of one row, or puts it on `waiting`; whether its element still has room.
bool press(state::State& state, std::size_t c, std::vector<std::size_t>* waiting) {
    state::WallContacts& contacts = state.wall_contacts;
    const state::Elements& elements = state.elements;
    const state::Wall& wall = state.walls[contacts.wall[c]];
    const std::size_t e = contacts.element[c];
    const Vec2 centre = seen_from(wall, contacts.part[c], elements.position(e), state.period);
    const WallGap gap = wall_gap(wall, contacts.part[c], centre);
    const double overlap = gap.meets ? elements.radius[e] - gap.distance : 0.0;
    contacts.overlap[c] = overlap;
    state::ContactHistory history = contacts.history.at(c);
    if (waiting != nullptr && passes(state, c, gap.meets, overlap, history)) {
        waiting->push_back(c);
        return true;
    }
    if (overlap <= 0.0 && at_rest(history)) {
        release(contacts, c);
        if (contacts.rolling.present()) rolling_moment(state, c, 0.0);
        return true;
    }
    const Vec2 tangent = turned_left(gap.normal);
    const Vec2 foot = centre - gap.distance * gap.normal;
    const Vec2 v = elements.velocity(e) - wall.velocity_at(foot);
    const law::Coulomb::Input<double> in{overlap, -dot(v, gap.normal),
                                         dot(v, tangent) - gap.distance * elements.spin[e], contacts.Cn[c],
                                         contacts.Ct[c]};
    law::Spent<double> spent = contacts.spent.at(c);
    const auto force =
        law::Coulomb::respond(state::wall_rule(state, contacts.wall[c], e).params(), in, state.dt, history, spent);
    contacts.history.store(c, history);
    contacts.spent.store(c, spent);
    const Vec2 f = force.pressure * gap.normal - force.shear * tangent;
    contacts.fx[c] = f.x;
    contacts.fy[c] = f.y;
    contacts.moment[c] = force.shear * gap.distance;
    contacts.turning[c] = -cross(foot - wall.centre_now(), f);
    if (contacts.rolling.present()) {
        const double couple = rolling_moment(state, c, force.pressure);
        contacts.moment[c] += couple;
        contacts.turning[c] -= couple;
    }
    return overlap <= (1.0 - least_clearance) * elements.radius[e];
}

void add_up(state::State& state) {
    const state::WallContacts& contacts = state.wall_contacts;
    state::Elements& elements = state.elements;
    for (state::Wall& wall : state.walls) {
        wall.force = {};
        wall.moment = 0.0;
        wall.stiffness = 0.0;
    }
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const std::size_t e = contacts.element[c];
        state::Wall& wall = state.walls[contacts.wall[c]];
        elements.fx[e] += contacts.fx[c];
        elements.fy[e] += contacts.fy[c];
        elements.moment[e] += contacts.moment[c];
        wall.force -= Vec2{contacts.fx[c], contacts.fy[c]};
        wall.moment += contacts.turning[c];
        if (contacts.overlap[c] > 0.0) wall.stiffness += state::wall_rule(state, contacts.wall[c], e).Kn;
    }
}

[[noreturn]] void refuse_pressed_through(const state::State& state, std::size_t c) {
    const state::Elements& elements = state.elements;
    const std::size_t e = state.wall_contacts.element[c];
    throw RunError(fmt::format(
        "element {} of body \"{}\" at ({:.6g}, {:.6g}) m has been pressed into wall \"{}\" by {:.4g} m in step {} "
        "(t = {:.6g} s): more than {:.3g} of its radius {:.4g} m; press or hit less hard, or take a stiffer material",
        e, state.bodies[elements.body[e]].name, elements.position(e).x, elements.position(e).y,
        state.walls[state.wall_contacts.wall[c]].name, state.wall_contacts.overlap[c], state.step, state.time,
        1.0 - least_clearance, elements.radius[e]));
}

} // namespace

void wall_forces(state::State& state, Team& team) {
    std::vector<std::size_t> pressed(team.parts(), no_row);
    std::vector<std::vector<std::size_t>> waits(team.parts());
    team.share(state.wall_contacts.size(), [&](Share part) {
        for (std::size_t c = part.begin; c < part.end; ++c) {
            if (!press(state, c, &waits[part.part])) pressed[part.part] = std::min(pressed[part.part], c);
        }
    });
    std::size_t first = *std::min_element(pressed.begin(), pressed.end());
    std::vector<std::size_t> waiting;
    for (const std::vector<std::size_t>& share : waits) waiting.insert(waiting.end(), share.begin(), share.end());
    pass_on(state, waiting);
    for (const std::size_t c : waiting) {
        if (!press(state, c, nullptr)) first = std::min(first, c);
    }
    if (first != no_row) refuse_pressed_through(state, first);
    add_up(state);
    if (!state.outline_contacts.rows.empty()) outline_forces(state);
}

} // namespace demlua::step
