#include "engine/observe/stress.hpp"

#include "engine/step/wall_parts.hpp"

namespace demlua::observe {

namespace {

void add(std::vector<double>& stress, std::size_t element, Vec2 force, Vec2 arm) {
    stress[3 * element] += force.x * arm.x;
    stress[3 * element + 1] += force.y * arm.y;
    stress[3 * element + 2] += 0.5 * (force.x * arm.y + force.y * arm.x);
}

template <class Pairs>
void add_pairs(const Pairs& pairs, const state::Elements& elements, std::vector<double>& stress) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const std::size_t i = pairs.i[k];
        const std::size_t j = pairs.j[k];
        const Vec2 span = elements.position(j) - elements.position(i);
        const double share = elements.radius[i] / (elements.radius[i] + elements.radius[j]);
        const Vec2 f{pairs.fx[k], pairs.fy[k]};
        add(stress, i, f, share * span);
        add(stress, j, -f, (share - 1.0) * span);
    }
}

/// A facet's force acts at its middle.
template <class Law>
void add_pairs(const state::FacetSet<Law>& bonds, const state::Elements& elements, std::vector<double>& stress) {
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        const Vec2 span = elements.position(bonds.j[k]) - elements.position(bonds.i[k]);
        const Vec2 aside = (bonds.centre[k] / norm(span)) * turned_left(span);
        const Vec2 f{bonds.fx[k], bonds.fy[k]};
        add(stress, bonds.i[k], f, bonds.share_i[k] * span + aside);
        add(stress, bonds.j[k], -f, (bonds.share_i[k] - 1.0) * span + aside);
    }
}

} // namespace

std::vector<double> stress_of_elements(const state::State& state) {
    const state::Elements& elements = state.elements;
    std::vector<double> stress(3 * elements.size(), 0.0);
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit([&](const auto& bonds) { add_pairs(bonds, elements, stress); }, any);
    }
    add_pairs(state.contacts, elements, stress);
    for (std::size_t c = 0; c < state.wall_contacts.size(); ++c) {
        const std::size_t e = state.wall_contacts.element[c];
        const step::WallGap gap =
            step::wall_gap(state.walls[state.wall_contacts.wall[c]], state.wall_contacts.part[c], elements.position(e));
        const state::ContactHistory history = state.wall_contacts.history.at(c);
        const law::ContactStiffness& k = state.materials[state.bodies[elements.body[e]].material].stiffness;
        const double overlap = state.wall_contacts.overlap[c];
        if (overlap <= 0.0) continue;
        const Vec2 f = (k.normal * overlap + history.damping) * gap.normal - history.force * turned_left(gap.normal);
        add(stress, e, f, -gap.distance * gap.normal);
    }
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const double volume = elements.cell_area[e] * state.thickness;
        for (std::size_t c = 0; c < 3; ++c) stress[3 * e + c] /= volume;
    }
    return stress;
}

} // namespace demlua::observe
