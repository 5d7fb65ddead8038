#include "engine/state/material_assembly.hpp"

#include "engine/law/restitution.hpp"
#include "engine/law/stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace demlua::state {

namespace {

/// Facets take materials that eq. 16 has no shear stiffness for; loose elements of these meet as if nu* were 1/4.
law::ContactStiffness stiffness_in_contact(law::PlaneModuli moduli, double thickness) {
    if (moduli.poissons_ratio > 1.0 / 3.0) moduli.poissons_ratio = 0.25;
    return law::contact_stiffness(moduli, thickness);
}

MaterialFacts facts_of(const model::Material& material, const model::Scene& scene) {
    MaterialFacts facts;
    facts.stiffness = stiffness_in_contact(
        law::plane_moduli(material.youngs_modulus, material.poissons_ratio, scene.plane == model::Plane::strain),
        scene.thickness);
    facts.friction = material.friction;
    facts.rolling_friction = material.rolling_friction;
    if (material.contact_damping) facts.damping_fraction = *material.contact_damping;
    if (material.restitution) facts.damping_fraction = law::damping_fraction(*material.restitution);
    return facts;
}

PairRule pair_rule(const MaterialFacts& a, const MaterialFacts& b) {
    PairRule rule;
    rule.Kn = law::in_series(a.stiffness.normal, b.stiffness.normal);
    rule.Kt = law::in_series(a.stiffness.shear, b.stiffness.shear);
    rule.shear_damping = std::sqrt(rule.Kt / rule.Kn);
    rule.mu = std::min(a.friction, b.friction);
    rule.rolling_friction = std::min(a.rolling_friction, b.rolling_friction);
    rule.damping_fraction = 0.5 * (a.damping_fraction + b.damping_fraction);
    return rule;
}

void apply(const model::ContactRule& said, Contacts& contacts) {
    for (const auto& [a, b] : {std::pair{said.first, said.second}, std::pair{said.second, said.first}}) {
        PairRule rule = contacts.rules[a * contacts.materials + b];
        if (said.friction) rule.mu = *said.friction;
        if (said.rolling_friction) rule.rolling_friction = *said.rolling_friction;
        if (said.contact_damping) rule.damping_fraction = *said.contact_damping;
        if (said.restitution) rule.damping_fraction = law::damping_fraction(*said.restitution);
        contacts.rules.store(a * contacts.materials + b, rule);
    }
}

} // namespace

void lay_out_materials(const model::Scene& scene, State& state) {
    for (const model::Material& material : scene.materials) state.materials.push_back(facts_of(material, scene));
    state.contacts.materials = state.materials.size();
    for (const MaterialFacts& a : state.materials) {
        for (const MaterialFacts& b : state.materials) state.contacts.rules.push_back(pair_rule(a, b));
    }
    for (const model::ContactRule& said : scene.contact_rules) apply(said, state.contacts);
    for (const double friction : state.contacts.rules.column<&PairRule::rolling_friction>()) {
        state.contacts.rolls |= friction > 0.0;
    }
}

} // namespace demlua::state
