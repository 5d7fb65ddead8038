#include "engine/step/wall_search.hpp"

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

/// Walks along the walls: each segment finds the elements near it, which it tells of its points too. A point between two
/// segments belongs to the one that begins there.
std::vector<Candidate> candidates(const state::State& state, double skin, const CellGrid& grid) {
    const state::Elements& elements = state.elements;
    const double reach = *std::max_element(elements.radius.begin(), elements.radius.end()) + skin;
    std::vector<Candidate> found;
    for (std::size_t w = 0; w < state.walls.size(); ++w) {
        const state::Wall& wall = state.walls[w];
        const std::size_t last = wall.segments() - 1;
        for (std::size_t segment = 0; segment <= last; ++segment) {
            const std::size_t end = segment == last ? wall.parts() : 2 * segment + 2;
            grid.for_each_near(wall.points[segment], wall.point_after(segment), reach, [&](Index e) {
                for (std::size_t part = 2 * segment; part < end; ++part) {
                    if (distance_to_part(wall, part, elements.position(e)) >= elements.radius[e] + skin) continue;
                    found.push_back({static_cast<Index>(w), e, static_cast<Index>(part)});
                }
            });
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.key() < b.key(); });
    return found;
}

void append_row(state::State& state, const Candidate& row, const state::ContactHistory& history) {
    state::WallContacts& contacts = state.wall_contacts;
    const state::PairRule& rule = state::wall_rule(state, row.wall, row.element);
    const std::optional<state::Matter>& matter = state.walls[row.wall].matter;
    const double m = 1.0 / (state.elements.inverse_mass[row.element] + (matter ? 1.0 / matter->mass : 0.0));
    contacts.wall.push_back(row.wall);
    contacts.element.push_back(row.element);
    contacts.part.push_back(row.part);
    contacts.Cn.push_back(2.0 * rule.damping_fraction * std::sqrt(rule.params.Kn * m));
    contacts.Ct.push_back(2.0 * rule.damping_fraction * std::sqrt(rule.params.Kt * m));
    contacts.history.resize(contacts.size());
    contacts.history.store(contacts.size() - 1, history);
}

} // namespace

void refresh_wall_contacts(state::State& state, double skin, const CellGrid& grid) {
    if (state.walls.empty()) return;
    const std::vector<Candidate> found = candidates(state, skin, grid);
    const state::WallContacts old = std::exchange(state.wall_contacts, {});
    state::WallContacts& contacts = state.wall_contacts;
    contacts.spent = old.spent;
    std::size_t next = 0;
    const auto book_next = [&] {
        const state::ContactHistory history = old.history.at(next++);
        contacts.spent.friction += history.friction;
        contacts.spent.damping += history.damped;
    };
    for (const Candidate& row : found) {
        while (next < old.size() && key_of(old, next) < row.key()) book_next();
        const bool stays = next < old.size() && key_of(old, next) == row.key();
        append_row(state, row, stays ? old.history.at(next++) : state::ContactHistory{});
    }
    while (next < old.size()) book_next();
    for (Column<double>* column :
         {&contacts.overlap, &contacts.fx, &contacts.fy, &contacts.moment, &contacts.turning}) {
        column->resize(contacts.size());
    }
}

} // namespace demlua::step
