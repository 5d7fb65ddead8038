#include "engine/step/wall_search.hpp"

#include "engine/step/contact_past.hpp"
#include "engine/step/wall_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace demlua::step {

namespace {

/// A row of the list while it is being made.
struct Candidate {
    Index wall;
    Index element;
    Index part;

    [[nodiscard]] auto key() const { return std::tie(wall, element, part); }
};

auto key_of(const state::WallContacts& contacts, std::size_t row) {
    return std::tie(contacts.wall[row], contacts.element[row], contacts.part[row]);
}

/// By how much to shift a segment to find all images of elements near it, m.
std::vector<Vec2> shifts_of(const state::Wall& wall, std::size_t segment, Period period) {
    if (!period.repeats()) return {Vec2{}};
    const double inside = period.shift_inside(0.5 * (wall.points[segment].x + wall.point_after(segment).x));
    return {{inside - period.length, 0.0}, {inside, 0.0}, {inside + period.length, 0.0}};
}

ContactPast kept_of(const state::WallContacts& old, std::size_t row) {
    ContactPast past = past_of(old, row);
    past.spent = old.spent.at(row);
    return past;
}

/// What a row that leaves the list had spent, and what it still stores if its element was taken out.
void book(state::State& state, const state::WallContacts& old, std::size_t row) {
    const ContactPast past = kept_of(old, row);
    const Index e = old.element[row];
    state.wall_contacts.booked += past.spent;
    state.wall_contacts.booked += past.spent_in_rolling;
    if (state.wear.present()) state.wear.past[e] += past.spent.friction;
    if (!state.is_gone(e)) return;
    const double kr = old.rolling.present() ? old.rolling.stiffness[row] : 0.0;
    state.booked.removed += stored_in(past, state::wall_rule(state, old.wall[row], e).params(), old.overlap[row], kr);
}

/// Walks along the walls: each segment finds the elements near it, which it tells of its points too. A point between two
/// segments belongs to the one that begins there.
/// In a plane that repeats it finds those near its images too, and some more than once.
std::vector<Candidate> candidates(const state::State& state, double skin, const Places& places, const CellGrid& grid) {
    const state::Elements& elements = state.elements;
    const double reach = *std::max_element(elements.radius.begin(), elements.radius.end()) + skin;
    std::vector<Candidate> found;
    for (std::size_t w = 0; w < state.walls.size(); ++w) {
        const state::Wall& wall = state.walls[w];
        const std::size_t last = wall.segments() - 1;
        for (std::size_t segment = 0; segment <= last; ++segment) {
            const std::size_t end = segment == last ? wall.parts() : 2 * segment + 2;
            const auto look = [&](Index place) {
                const Index e = places.element[place];
                for (std::size_t part = 2 * segment; part < end; ++part) {
                    const Vec2 centre = seen_from(wall, part, elements.position(e), state.period);
                    if (distance_to_part(wall, part, centre) >= elements.radius[e] + skin) continue;
                    found.push_back({static_cast<Index>(w), e, static_cast<Index>(part)});
                }
            };
            for (const Vec2 shift : shifts_of(wall, segment, state.period)) {
                grid.for_each_near(wall.points[segment] + shift, wall.point_after(segment) + shift, reach, look);
            }
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.key() < b.key(); });
    found.erase(
        std::unique(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.key() == b.key(); }),
        found.end());
    return found;
}

void append_row(state::State& state, const Candidate& row, const ContactPast& past) {
    state::WallContacts& contacts = state.wall_contacts;
    const state::PairRule& rule = state::wall_rule(state, row.wall, row.element);
    const std::optional<state::Matter>& matter = state.walls[row.wall].matter;
    const double m = 1.0 / (1.0 / state.pushed_mass(row.element) + (matter ? 1.0 / matter->mass : 0.0));
    contacts.wall.push_back(row.wall);
    contacts.element.push_back(row.element);
    contacts.part.push_back(row.part);
    contacts.Cn.push_back(2.0 * rule.damping_fraction * std::sqrt(rule.Kn * m));
    contacts.Ct.push_back(2.0 * rule.damping_fraction * std::sqrt(rule.Kt * m));
    contacts.history.push_back(past.contact);
    contacts.spent.push_back(past.spent);
    if (!state.contacts.rolls) return;
    contacts.rolling.push_back(state.elements.radius[row.element], rule.Kt, rule.damping_fraction,
                               state.elements.inertia(row.element), past.rolling, past.spent_in_rolling);
}

} // namespace

void refresh_wall_contacts(state::State& state, double skin, const Places& places, const CellGrid& grid) {
    if (state.walls.empty()) return;
    const std::vector<Candidate> found = candidates(state, skin, places, grid);
    const state::WallContacts old = std::exchange(state.wall_contacts, {});
    state::WallContacts& contacts = state.wall_contacts;
    contacts.booked = old.booked;
    std::size_t next = 0;
    for (const Candidate& row : found) {
        while (next < old.size() && key_of(old, next) < row.key()) book(state, old, next++);
        const bool stays = next < old.size() && key_of(old, next) == row.key();
        append_row(state, row, stays ? kept_of(old, next++) : ContactPast{});
    }
    while (next < old.size()) book(state, old, next++);
    for (Column<double>* column :
         {&contacts.overlap, &contacts.fx, &contacts.fy, &contacts.moment, &contacts.turning}) {
        column->resize(contacts.size());
    }
}

} // namespace demlua::step
