#include "engine/step/outline_forces.hpp"

#include "engine/base/problems.hpp"
#include "engine/step/wall_forces.hpp"
#include "engine/step/wall_parts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <utility>
#include <vector>

namespace demlua::step {

namespace {

/// Where a row's corner stands to its part.
struct Seen {
    WallGap gap;
    Vec2 foot;            ///< on the wall, m
    Vec2 foot_on_outline; ///< the same point as the outline sees it: a width away where the plane repeats, m
};

Seen seen(const state::State& state, const state::OutlineContact& row) {
    const state::Wall& wall = state.walls[row.wall];
    const state::Wall& outline = state.walls[row.outline];
    const Vec2 at = outline.place_of(outline.matter->corners[row.corner].centre);
    const Vec2 centre = seen_from(wall, row.part, at, state.period);
    Seen now{wall_gap(wall, row.part, centre), {}, {}};
    now.foot = centre - now.gap.distance * now.gap.normal;
    now.foot_on_outline = now.foot + (at - centre);
    return now;
}

const state::Corner& corner_of(const state::State& state, const state::OutlineContact& row) {
    return state.walls[row.outline].matter->corners[row.corner];
}

[[noreturn]] void refuse_pressed_through(const state::State& state, const state::OutlineContact& row, Vec2 place) {
    const state::Wall& wall = state.walls[row.wall];
    throw RunError(fmt::format("a corner of outline \"{}\" has been pressed into {} \"{}\" by {:.4g} m at ({:.6g}, "
                               "{:.6g}) m in step {} (t = {:.6g} "
                               "s): more than {:.3g} of its rounding {:.4g} m; press or hit less hard, take a stiffer "
                               "material or a larger rounding",
                               state.walls[row.outline].name, wall.matter ? "outline" : "wall", wall.name, row.overlap,
                               place.x, place.y, state.step, state.time, 1.0 - least_clearance,
                               corner_of(state, row).radius));
}

bool at_rest(const state::ContactHistory& history) { return history.force == 0.0 && history.damping == 0.0; }

/// Hands what a contact remembers on to the part of the wall that its corner has come to.
void pass_on(std::vector<state::OutlineContact>& rows, const std::vector<Seen>& places, const state::State& state) {
    for (std::size_t from = 0; from < rows.size(); ++from) {
        if (places[from].gap.meets || at_rest(rows[from].history)) continue;
        for (std::size_t to = 0; to < rows.size(); ++to) {
            const bool same = rows[to].wall == rows[from].wall && rows[to].outline == rows[from].outline &&
                              rows[to].corner == rows[from].corner;
            if (!same || rows[to].overlap <= 0.0 || !at_rest(rows[to].history)) continue;
            if (!are_neighbours(state.walls[rows[to].wall], rows[from].part, rows[to].part)) continue;
            rows[to].history = std::exchange(rows[from].history, {});
            break;
        }
    }
}

void share_dashpots(std::vector<state::OutlineContact>& rows) {
    std::map<std::pair<std::size_t, std::size_t>, double> touching;
    const auto pair_of = [](const state::OutlineContact& row) { return std::minmax(row.wall, row.outline); };
    for (const state::OutlineContact& row : rows) touching[pair_of(row)] += row.overlap > 0.0 ? 1.0 : 0.0;
    for (state::OutlineContact& row : rows) row.damped = row.Cn / std::sqrt(std::max(touching[pair_of(row)], 1.0));
}

void press(state::State& state, state::OutlineContact& row, const Seen& place) {
    if (row.overlap <= 0.0 && at_rest(row.history)) return;
    state::Wall& wall = state.walls[row.wall];
    state::Wall& outline = state.walls[row.outline];
    const Vec2 tangent = turned_left(place.gap.normal);
    const Vec2 v = outline.velocity_at(place.foot_on_outline) - wall.velocity_at(place.foot);
    const double Ct = row.Cn > 0.0 ? row.Ct * (row.damped / row.Cn) : 0.0;
    const law::Coulomb::Input<double> in{row.overlap, -dot(v, place.gap.normal), dot(v, tangent), row.damped, Ct};
    const auto force = law::Coulomb::respond(row.rule.params(), in, state.dt, row.history, row.spent);
    const Vec2 f = force.pressure * place.gap.normal - force.shear * tangent;
    outline.force += f;
    outline.moment += cross(place.foot_on_outline - outline.centre_now(), f);
    wall.force -= f;
    wall.moment -= cross(place.foot - wall.centre_now(), f);
    if (row.overlap <= 0.0) return;
    wall.stiffness += row.rule.Kn;
    outline.stiffness += row.rule.Kn;
}

} // namespace

void outline_forces(state::State& state) {
    std::vector<state::OutlineContact>& rows = state.outline_contacts.rows;
    std::vector<Seen> places;
    for (state::OutlineContact& row : rows) {
        const Seen& place = places.emplace_back(seen(state, row));
        const double radius = corner_of(state, row).radius;
        row.overlap = place.gap.meets ? radius - place.gap.distance : 0.0;
        if (row.overlap > (1.0 - least_clearance) * radius) refuse_pressed_through(state, row, place.foot);
    }
    pass_on(rows, places, state);
    share_dashpots(rows);
    for (std::size_t k = 0; k < rows.size(); ++k) press(state, rows[k], places[k]);
}

} // namespace demlua::step
