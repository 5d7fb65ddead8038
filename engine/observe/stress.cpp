#include "engine/observe/stress.hpp"

#include "engine/step/cell_stress.hpp"
#include "engine/step/wall_parts.hpp"

namespace demlua::observe {

namespace {

/// `span(k)` leads from the centre of i to that of j of pair k, m.
template <class Pairs, class Span>
void add_pairs(const Pairs& pairs, const state::Elements& elements, const Span& span,
               std::vector<step::PlaneStress>& stress) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const std::size_t i = pairs.i[k];
        const std::size_t j = pairs.j[k];
        const double share = elements.radius[i] / (elements.radius[i] + elements.radius[j]);
        const Vec2 f = pairs.forces.at(k).f;
        stress[i].add(f, share * span(k));
        stress[j].add(-f, (share - 1.0) * span(k));
    }
}

/// A facet's force acts at its middle.
template <class Law, class Span>
void add_pairs(const state::FacetSet<Law>& bonds, const state::Elements& /*elements*/, const Span& span_of,
               std::vector<step::PlaneStress>& stress) {
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        const Vec2 span = span_of(k);
        const double length = norm(span);
        const step::FacetArms arms = step::facet_arms(bonds, k, span / length, length);
        const Vec2 f = bonds.forces.at(k).f;
        stress[bonds.i[k]].add(f, arms.of_i);
        stress[bonds.j[k]].add(-f, arms.of_j);
    }
}

} // namespace

std::vector<double> stress_of_elements(const state::State& state) {
    const state::Elements& elements = state.elements;
    std::vector<step::PlaneStress> stress(elements.size());
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                add_pairs(
                    bonds, elements, [&](std::size_t k) { return state::span_of(bonds, elements, k); }, stress);
            },
            any);
    }
    const state::Contacts& contacts = state.contacts;
    add_pairs(
        contacts, elements, [&](std::size_t c) { return state.between(contacts.i[c], contacts.j[c]); }, stress);
    for (std::size_t c = 0; c < state.wall_contacts.size(); ++c) {
        const std::size_t e = state.wall_contacts.element[c];
        if (state.wall_contacts.overlap[c] <= 0.0) continue;
        const state::Wall& wall = state.walls[state.wall_contacts.wall[c]];
        const std::size_t part = state.wall_contacts.part[c];
        const step::WallGap gap =
            step::wall_gap(wall, part, step::seen_from(wall, part, elements.position(e), state.period));
        stress[e].add({state.wall_contacts.fx[c], state.wall_contacts.fy[c]}, -gap.distance * gap.normal);
    }
    std::vector<double> components;
    components.reserve(3 * elements.size());
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const step::PlaneStress mean = (1.0 / (elements.cell_area[e] * state.thickness)) * stress[e];
        components.insert(components.end(), {mean.xx, mean.yy, mean.xy});
    }
    return components;
}

} // namespace demlua::observe
