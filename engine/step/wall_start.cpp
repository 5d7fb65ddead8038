#include "engine/step/wall_start.hpp"

#include "engine/step/outline_search.hpp"
#include "engine/step/wall_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <map>
#include <string>
#include <utility>

namespace demlua::step {

namespace {

constexpr double deepest_allowed = 0.1; // of the radius

/// By wall and body.
using Deepest = std::map<std::pair<std::size_t, std::size_t>, double>;

const Place& place_of(const model::Scene& scene, std::size_t wall) {
    return wall < scene.walls.size() ? scene.walls[wall].place : scene.outlines[wall - scene.walls.size()].place;
}

Deepest overlaps(const state::State& state) {
    Deepest deepest;
    const state::WallContacts& contacts = state.wall_contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const std::size_t e = contacts.element[c];
        const double R = state.elements.radius[e];
        const state::Wall& wall = state.walls[contacts.wall[c]];
        const double gap = distance_to_part(
            wall, contacts.part[c], seen_from(wall, contacts.part[c], state.elements.position(e), state.period));
        double& found = deepest[{contacts.wall[c], state.elements.body[e]}];
        found = std::max(found, 1.0 - gap / R);
    }
    return deepest;
}

/// Whether an outline has the place, or an image of it, in it.
bool holds(const state::State& state, const state::Wall& outline, Vec2 place) {
    for (const Vec2 shift : shifts_to_images(outline.centre_now() - place, state.period)) {
        if (is_inside(outline, place + shift)) return true;
    }
    return false;
}

bool turns(const state::Wall& outline) {
    if (!outline.turning) return true;
    const std::vector<double>& values = outline.turning->values;
    return std::any_of(values.begin(), values.end(), [](double value) { return value != 0.0; });
}

/// How far an outline may reach along x, however it turns if it does, m.
double greatest_width(const state::Wall& outline) {
    const bool all_round = turns(outline);
    double width = 0.0;
    for (const Vec2 a : outline.points) {
        for (const Vec2 b : outline.points) width = std::max(width, all_round ? norm(b - a) : b.x - a.x);
    }
    return width;
}

/// The same by wall and outline, of the outline's corners.
Deepest deepest_corners(const state::State& state) {
    Deepest deepest;
    for (const state::OutlineContact& row : state.outline_contacts.rows) {
        const state::Wall& wall = state.walls[row.wall];
        const state::Wall& outline = state.walls[row.outline];
        const state::Corner& corner = outline.matter->corners[row.corner];
        const Vec2 at = seen_from(wall, row.part, outline.place_of(corner.centre), state.period);
        double& found = deepest[{row.wall, row.outline}];
        found = std::max(found, 1.0 - distance_to_part(wall, row.part, at) / corner.radius);
    }
    return deepest;
}

} // namespace

std::vector<Problem> outlines_meeting_images(const model::Scene& scene, const state::State& state) {
    constexpr double rounding = 1e-9;
    std::vector<Problem> problems;
    if (!state.period.repeats()) return problems;
    for (std::size_t w = 0; w < state.walls.size(); ++w) {
        const state::Wall& outline = state.walls[w];
        if (!outline.matter) continue;
        const double width = greatest_width(outline);
        if (width <= (1.0 + rounding) * state.period.length) continue;
        problems.push_back({place_of(scene, w), "outline.path", '"' + outline.name + '"',
                            fmt::format("is {:.6g} m across{} and would meet its own image in a box that repeats every "
                                        "{:.6g} m",
                                        width, turns(outline) ? " where it is longest" : "", state.period.length),
                            turns(outline)
                                ? "make it smaller or the box wider, or keep it from turning: outline:move { spin = 0 }"
                                : "make it smaller or the box wider"});
    }
    return problems;
}

std::vector<Problem> elements_across_walls(const model::Scene& scene, const state::State& state) {
    std::vector<Problem> problems = outlines_meeting_images(scene, state);
    if (!problems.empty()) return problems;
    const auto add = [&](std::size_t wall, std::size_t body, const std::string& rule) {
        problems.push_back({place_of(scene, wall), state.walls[wall].matter ? "outline.path" : "wall.path",
                            '"' + state.walls[wall].name + '"', rule + " at the start",
                            "move the wall or body \"" + state.bodies[body].name + "\" away"});
    };
    for (const auto& [pair, depth] : overlaps(state)) {
        if (depth <= deepest_allowed) continue;
        add(pair.first, pair.second,
            fmt::format("lies across an element of body \"{}\", by {:.0f} % of its radius,",
                        state.bodies[pair.second].name, 100.0 * depth));
    }
    for (const auto& [pair, depth] : deepest_corners(state)) {
        if (depth <= deepest_allowed) continue;
        const state::Wall& wall = state.walls[pair.first];
        problems.push_back({place_of(scene, pair.second), "outline.path", '"' + state.walls[pair.second].name + '"',
                            fmt::format("lies in {} \"{}\" with a corner, by {:.0f} % of its rounding, at the start",
                                        wall.matter ? "outline" : "wall", wall.name, 100.0 * depth),
                            "move one of them away, or give the motion of both"});
    }
    if (!problems.empty()) return problems;
    for (const Crossing& crossing : crossing_outlines(state)) {
        const state::Wall& wall = state.walls[crossing.wall];
        problems.push_back(
            {place_of(scene, crossing.outline), "outline.path", '"' + state.walls[crossing.outline].name + '"',
             fmt::format("lies across {} \"{}\" at ({:.6g}, {:.6g}) m at the start", wall.matter ? "outline" : "wall",
                         wall.name, crossing.place.x, crossing.place.y),
             "move one of them away, or give the motion of both"});
    }
    if (!problems.empty()) return problems;
    for (std::size_t w = 0; w < state.walls.size(); ++w) {
        if (!state.walls[w].matter) continue;
        for (std::size_t e = 0; e < state.elements.size(); ++e) {
            if (!holds(state, state.walls[w], state.elements.position(e))) continue;
            add(w, state.elements.body[e],
                fmt::format("holds an element of body \"{}\"", state.bodies[state.elements.body[e]].name));
            break;
        }
    }
    return problems;
}

} // namespace demlua::step
