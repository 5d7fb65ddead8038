#include "engine/state/parts.hpp"

#include "engine/base/cell_grid.hpp"
#include "engine/base/disjoint_sets.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <variant>

namespace demlua::state {

std::vector<std::int32_t> part_of_elements(const State& state) {
    DisjointSets sets(state.elements.size());
    for (const AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                for (std::size_t k = 0; k < bonds.size(); ++k) {
                    if (!bonds.is_broken(k)) sets.join(bonds.i[k], bonds.j[k]);
                }
            },
            any);
    }
    for (const RigidBody& rigid : state.rigid_bodies) {
        const auto members = state.members(rigid);
        for (const Index k : members) sets.join(members.front(), k);
    }
    std::vector<std::int32_t> part(state.elements.size());
    std::int32_t next = 0;
    for (std::size_t k = 0; k < part.size(); ++k) {
        const std::size_t root = sets.root(k);
        part[k] = root == k ? next++ : part[root];
    }
    return part;
}

std::vector<std::vector<std::size_t>> elements_of_parts(const State& state) {
    std::vector<std::vector<std::size_t>> parts;
    const std::vector<std::int32_t> part = part_of_elements(state);
    for (std::size_t k = 0; k < part.size(); ++k) {
        const auto number = static_cast<std::size_t>(part[k]);
        if (number == parts.size()) parts.emplace_back();
        parts[number].push_back(k);
    }
    return parts;
}

std::string name_elements(const State& state, const std::vector<std::size_t>& elements) {
    constexpr std::size_t most_listed = 8;
    const std::string& body = state.bodies[state.elements.body[elements.front()]].name;
    if (elements.size() == 1) return fmt::format("element {} of body \"{}\"", elements.front(), body);
    const auto end = elements.begin() + static_cast<std::ptrdiff_t>(std::min(elements.size(), most_listed));
    const std::string more = elements.size() > most_listed ? fmt::format(" ... ({} in all)", elements.size()) : "";
    return fmt::format("elements {}{} of body \"{}\"", fmt::join(elements.begin(), end, ", "), more, body);
}

std::vector<std::string> separate_parts(const State& state) {
    std::vector<std::vector<std::vector<std::size_t>>> of_body(state.bodies.size());
    for (std::vector<std::size_t>& part : elements_of_parts(state)) {
        const bool apart = state.bodies[state.elements.body[part.front()]].in_clusters;
        if (part.size() > 1 && !apart) of_body[state.elements.body[part.front()]].push_back(std::move(part));
    }
    std::vector<std::string> notes;
    for (std::size_t body = 0; body < of_body.size(); ++body) {
        std::vector<std::vector<std::size_t>>& parts = of_body[body];
        if (parts.size() < 2) continue;
        std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
        constexpr std::size_t most_listed = 5;
        std::string text = fmt::format("{}: its bonds leave {} separate parts; beside the largest of {} elements",
                                       state.bodies[body].name, parts.size(), parts.front().size());
        for (std::size_t p = 1; p < std::min(parts.size(), most_listed); ++p) {
            text += (p == 1 ? ": " : "; ") + name_elements(state, parts[p]);
        }
        notes.push_back(std::move(text));
    }
    return notes;
}

std::vector<Problem> coincident_elements(const model::Scene& scene, const State& state) {
    constexpr double same_place = 1e-9; // of the smallest radius
    const Elements& elements = state.elements;
    std::vector<Vec2> points(elements.size());
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = elements.position(k);
    const double smallest = *std::min_element(elements.radius.begin(), elements.radius.end());
    CellGrid grid;
    grid.build(points, smallest);
    std::vector<std::vector<std::pair<Index, Index>>> found(state.bodies.size());
    grid.for_each_pair(same_place * smallest, [&](Index i, Index j) {
        if (elements.body[i] == elements.body[j]) found[elements.body[i]].emplace_back(std::minmax(i, j));
    });
    std::vector<Problem> problems;
    for (std::size_t body = 0; body < found.size(); ++body) {
        if (found[body].empty() || state.bodies[body].rigid) continue;
        const auto [i, j] = *std::min_element(found[body].begin(), found[body].end());
        problems.push_back(
            {scene.bodies[body].place, "body.packing", '"' + scene.bodies[body].name + '"',
             fmt::format("elements {} and {} are both at ({:.6g}, {:.6g}) m", i, j, points[i].x, points[i].y),
             "move one of them, or leave it out"});
    }
    return problems;
}

} // namespace demlua::state
