#include "engine/step/outline_search.hpp"

#include "engine/step/wall_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace demlua::step {

namespace {

/// Calls `work(wall, outline, free)` for every outline and every wall or other outline; `free`: whether one of them moves freely.
template <class Work>
void for_each_pair_of_walls(const state::State& state, const Work& work) {
    for (std::size_t w = 0; w < state.walls.size(); ++w) {
        for (std::size_t o = 0; o < state.walls.size(); ++o) {
            if (o == w || !state.walls[o].matter) continue;
            work(w, o, state.walls[w].moves_freely() || state.walls[o].moves_freely());
        }
    }
}

/// The same for those that may meet.
template <class Work>
void for_each_meeting(const state::State& state, const Work& work) {
    for_each_pair_of_walls(state, [&](std::size_t w, std::size_t o, bool free) {
        if (free) work(w, o);
    });
}

/// Whether their farthest points are nearer to each other than `skin`.
bool in_reach(const state::State& state, const state::Wall& a, const state::Wall& b, double skin) {
    const Vec2 between = b.centre_now() - a.centre_now();
    return norm(state.period.repeats() ? state.period.shortest(between) : between) < a.reach + b.reach + skin;
}

double inverse_mass(const state::Wall& wall) {
    return wall.matter && (wall.free_x() || wall.free_y()) ? 1.0 / wall.matter->mass : 0.0;
}

state::OutlineContact row_of(const state::State& state, std::size_t wall, std::size_t outline) {
    state::OutlineContact row;
    row.wall = wall;
    row.outline = outline;
    row.rule = state::outline_rule(state, wall, outline);
    const double freedom = inverse_mass(state.walls[wall]) + inverse_mass(state.walls[outline]);
    const double m = freedom > 0.0 ? 1.0 / freedom : state.walls[outline].matter->mass;
    row.Cn = 2.0 * row.rule.damping_fraction * std::sqrt(row.rule.Kn * m);
    row.Ct = 2.0 * row.rule.damping_fraction * std::sqrt(row.rule.Kt * m);
    return row;
}

/// Parts of a wall within `skin` of anything of an outline; all, where the plane repeats and parts see different images.
std::vector<std::size_t> parts_near(const state::State& state, const state::Wall& wall, const state::Wall& outline,
                                    double skin) {
    std::vector<std::size_t> near;
    for (std::size_t part = 0; part < wall.parts(); ++part) {
        const bool far =
            !state.period.repeats() && distance_to_part(wall, part, outline.centre_now()) >= outline.reach + skin;
        if (!far) near.push_back(part);
    }
    return near;
}

std::vector<state::OutlineContact> candidates(const state::State& state, double skin) {
    std::vector<state::OutlineContact> found;
    for_each_meeting(state, [&](std::size_t w, std::size_t o) {
        const state::Wall& wall = state.walls[w];
        const state::Wall& outline = state.walls[o];
        if (!in_reach(state, wall, outline, skin)) return;
        const std::vector<std::size_t> near = parts_near(state, wall, outline, skin);
        state::OutlineContact row = row_of(state, w, o);
        for (row.corner = 0; row.corner < outline.matter->corners.size(); ++row.corner) {
            const state::Corner& corner = outline.matter->corners[row.corner];
            if (!corner.meets) continue;
            const Vec2 at = outline.place_of(corner.centre);
            for (const std::size_t part : near) {
                row.part = part;
                const double gap = distance_to_part(wall, part, seen_from(wall, part, at, state.period));
                if (gap < corner.radius + skin) found.push_back(row);
            }
        }
    });
    return found;
}

double smallest_corner(const state::State& state) {
    double smallest = std::numeric_limits<double>::infinity();
    for_each_meeting(state, [&](std::size_t /*w*/, std::size_t o) {
        for (const state::Corner& corner : state.walls[o].matter->corners) {
            if (corner.meets) smallest = std::min(smallest, corner.radius);
        }
    });
    return smallest;
}

/// Where the lines from a to b and from c to d cross, if they do.
std::optional<Vec2> crossing_of(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const double area = cross(b - a, d - c);
    if (area == 0.0) return std::nullopt;
    const double along = cross(c - a, d - c) / area;
    const double across = cross(c - a, b - a) / area;
    if (along < 0.0 || along > 1.0 || across < 0.0 || across > 1.0) return std::nullopt;
    return a + along * (b - a);
}

/// The middles of an outline's corners, moved by `shift`.
std::vector<Vec2> middles(const state::Wall& outline, Vec2 shift) {
    std::vector<Vec2> places;
    for (const state::Corner& corner : outline.matter->corners) {
        places.push_back(outline.place_of(corner.centre) + shift);
    }
    return places;
}

std::optional<Vec2> crossing_of(const state::Wall& wall, const std::vector<Vec2>& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        for (std::size_t segment = 0; segment < wall.segments(); ++segment) {
            const auto found =
                crossing_of(ring[k], ring[(k + 1) % ring.size()], wall.points[segment], wall.point_after(segment));
            if (found) return found;
        }
    }
    if (wall.matter && is_inside(wall, ring.front())) return ring.front();
    return std::nullopt;
}

/// Of an outline, or any image of it, with a wall.
std::optional<Vec2> crossing_of(const state::State& state, const state::Wall& wall, const state::Wall& outline) {
    if (!in_reach(state, wall, outline, 0.0)) return std::nullopt;
    for (const Vec2 shift : shifts_to_images(wall.centre_now() - outline.centre_now(), state.period)) {
        if (const auto found = crossing_of(wall, middles(outline, shift))) return found;
    }
    return std::nullopt;
}

std::vector<Crossing> crossings(const state::State& state, bool of_free) {
    std::vector<Crossing> found;
    for_each_pair_of_walls(state, [&](std::size_t w, std::size_t o, bool free) {
        if (free != of_free) return;
        if (const auto place = crossing_of(state, state.walls[w], state.walls[o])) found.push_back({w, o, *place});
    });
    return found;
}

} // namespace

void refresh_outline_contacts(state::State& state, double skin) {
    if (state.walls.size() < 2) return;
    state::OutlineContacts& contacts = state.outline_contacts;
    contacts.smallest_corner = smallest_corner(state);
    const std::vector<state::OutlineContact> old = std::exchange(contacts.rows, candidates(state, skin));
    auto next = contacts.rows.begin();
    for (const state::OutlineContact& before : old) {
        while (next != contacts.rows.end() && next->key() < before.key()) ++next;
        if (next == contacts.rows.end() || next->key() != before.key()) {
            contacts.booked += before.spent;
            continue;
        }
        next->overlap = before.overlap;
        next->damped = before.damped;
        next->history = before.history;
        next->spent = before.spent;
    }
}

std::vector<Crossing> crossing_outlines(const state::State& state) { return crossings(state, true); }
std::vector<Crossing> passing_outlines(const state::State& state) { return crossings(state, false); }

} // namespace demlua::step
