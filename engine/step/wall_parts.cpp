#include "engine/step/wall_parts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace demlua::step {

namespace {

/// Where the foot of `centre` lies along the segment from a to b: 0 at a, 1 at b.
double foot(Vec2 a, Vec2 b, Vec2 centre) { return dot(centre - a, b - a) / dot(b - a, b - a); }

WallGap gap_from(Vec2 nearest, Vec2 centre, bool meets) {
    const Vec2 between = centre - nearest;
    const double distance = norm(between);
    return {meets && distance > 0.0, distance > 0.0 ? between / distance : Vec2{}, distance};
}

double distance_to_part(const state::Wall& wall, std::size_t part, Vec2 centre) {
    const std::size_t k = part / 2;
    const Vec2 a = wall.path[k] + wall.offset;
    if (part % 2 == 0) return norm(centre - a);
    const Vec2 b = wall.path[k + 1] + wall.offset;
    return norm(centre - (a + std::clamp(foot(a, b, centre), 0.0, 1.0) * (b - a)));
}

std::size_t part_count(const state::Wall& wall) { return 2 * wall.path.size() - 1; }

law::Coulomb::Params wall_rule(const state::State& state, const state::Wall& wall, std::size_t element) {
    const state::MaterialFacts& facts = state.materials[state.bodies[state.elements.body[element]].material];
    return {facts.stiffness.normal, facts.stiffness.shear, std::min(facts.friction, wall.friction)};
}

void append_row(state::State& state, std::size_t wall, std::size_t element, std::size_t part,
                const state::ContactHistory& history) {
    state::WallContacts& contacts = state.wall_contacts;
    const state::MaterialFacts& facts = state.materials[state.bodies[state.elements.body[element]].material];
    const double m = state.elements.mass(element);
    contacts.wall.push_back(static_cast<Index>(wall));
    contacts.element.push_back(static_cast<Index>(element));
    contacts.part.push_back(static_cast<Index>(part));
    contacts.Cn.push_back(2.0 * facts.damping_fraction * std::sqrt(facts.stiffness.normal * m));
    contacts.Ct.push_back(2.0 * facts.damping_fraction * std::sqrt(facts.stiffness.shear * m));
    contacts.overlap.push_back(0.0);
    contacts.history.resize(contacts.size());
    contacts.history.store(contacts.size() - 1, history);
}

auto key(const state::WallContacts& contacts, std::size_t row) {
    return std::make_tuple(contacts.wall[row], contacts.element[row], contacts.part[row]);
}

} // namespace

WallGap wall_gap(const state::Wall& wall, std::size_t part, Vec2 centre) {
    const std::size_t k = part / 2;
    const Vec2 a = wall.path[k] + wall.offset;
    if (part % 2 == 1) {
        const Vec2 b = wall.path[k + 1] + wall.offset;
        const double along = foot(a, b, centre);
        return gap_from(a + along * (b - a), centre, along > 0.0 && along < 1.0);
    }
    const bool past_previous = k == 0 || foot(wall.path[k - 1] + wall.offset, a, centre) >= 1.0;
    const bool before_next = k + 1 == wall.path.size() || foot(a, wall.path[k + 1] + wall.offset, centre) <= 0.0;
    return gap_from(a, centre, past_previous && before_next);
}

void refresh_wall_contacts(state::State& state, double skin) {
    const state::WallContacts old = std::exchange(state.wall_contacts, {});
    state.wall_contacts.spent = old.spent;
    std::size_t next = 0;
    const auto book_next = [&] {
        const state::ContactHistory history = old.history.at(next++);
        state.wall_contacts.spent.friction += history.friction;
        state.wall_contacts.spent.damping += history.damped;
    };
    for (std::size_t w = 0; w < state.walls.size(); ++w) {
        const state::Wall& wall = state.walls[w];
        for (std::size_t e = 0; e < state.elements.size(); ++e) {
            const double reach = state.elements.radius[e] + skin;
            for (std::size_t part = 0; part < part_count(wall); ++part) {
                if (distance_to_part(wall, part, state.elements.position(e)) > reach) continue;
                const auto wanted =
                    std::make_tuple(static_cast<Index>(w), static_cast<Index>(e), static_cast<Index>(part));
                while (next < old.size() && key(old, next) < wanted) book_next();
                state::ContactHistory history;
                if (next < old.size() && key(old, next) == wanted) history = old.history.at(next++);
                append_row(state, w, e, part, history);
            }
        }
    }
    while (next < old.size()) book_next();
}

void wall_forces(state::State& state) {
    state::Elements& elements = state.elements;
    state::WallContacts& contacts = state.wall_contacts;
    for (state::Wall& wall : state.walls) wall.force = {};
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        state::Wall& wall = state.walls[contacts.wall[c]];
        const std::size_t e = contacts.element[c];
        const WallGap gap = wall_gap(wall, contacts.part[c], elements.position(e));
        const double overlap = gap.meets ? elements.radius[e] - gap.distance : 0.0;
        const Vec2 tangent = turned_left(gap.normal);
        const Vec2 v = elements.velocity(e) - wall.velocity;
        const law::Coulomb::Input<double> in{overlap, -dot(v, gap.normal),
                                             dot(v, tangent) - gap.distance * elements.spin[e], contacts.Cn[c],
                                             contacts.Ct[c]};
        state::ContactHistory history = contacts.history.at(c);
        const auto force = law::Coulomb::respond(wall_rule(state, wall, e), in, state.dt, history);
        contacts.history.store(c, history);
        contacts.overlap[c] = overlap;
        const Vec2 f = force.pressure * gap.normal - force.shear * tangent;
        elements.fx[e] += f.x;
        elements.fy[e] += f.y;
        elements.moment[e] += force.shear * gap.distance;
        wall.force -= f;
    }
    for (const state::Wall& wall : state.walls) {
        state.booked.walls -= 0.5 * state.dt * dot(wall.force, wall.velocity);
    }
}

void move_walls(state::State& state) {
    const double middle = state.time + 0.5 * state.dt;
    for (state::Wall& wall : state.walls) {
        wall.velocity = {wall.velocity_x.at(middle), wall.velocity_y.at(middle)};
        state.booked.walls -= 0.5 * state.dt * dot(wall.force, wall.velocity);
        wall.offset += state.dt * wall.velocity;
    }
}

} // namespace demlua::step
