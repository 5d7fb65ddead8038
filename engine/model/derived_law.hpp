// What a choice of bonds means for a material: the law and its parameters.
#pragma once

#include "engine/law/facet.hpp"
#include "engine/law/laws.hpp"
#include "engine/model/scene.hpp"

#include <optional>
#include <utility>

namespace demlua::model {

/// What laws take from a material, in the plane. Strength and toughness are 0 where the material does not say them.
struct Matter {
    law::PlaneModuli moduli{};
    law::ContactStiffness stiffness{}; ///< of one contact
    double thickness = 1.0;            ///< m
    double strength = 0.0;             ///< Pa
    double toughness = 0.0;            ///< Pa m^0.5
    double rate_factor = 1.0;
    double friction = 0.0;
};

inline law::PlaneModuli plane_moduli_of(const Material& material, Plane plane) {
    return law::plane_moduli(material.youngs_modulus, material.poissons_ratio, plane == Plane::strain);
}

/// Pa m^0.5, whichever way the material says it.
inline std::optional<double> fracture_toughness_of(const Material& material, Plane plane) {
    if (material.fracture_toughness || !material.fracture_energy) return material.fracture_toughness;
    return law::fracture_toughness(*material.fracture_energy, plane_moduli_of(material, plane));
}

/// `thickness` in m.
inline Matter matter_of(const Material& material, Plane plane, double thickness) {
    const law::PlaneModuli moduli = plane_moduli_of(material, plane);
    return {moduli,
            law::contact_stiffness(moduli, thickness),
            thickness,
            material.tensile_strength.value_or(0.0),
            fracture_toughness_of(material, plane).value_or(0.0),
            material.rate_factor,
            material.friction};
}

/// Parameters for pairs and for facets.
template <class Law>
struct DerivedLaw {
    using law = Law;
    typename Law::Params params;
    typename Law::Tractions tractions;
};

inline DerivedLaw<law::Elastic> derived(const ElasticBonds& /*said*/, const Matter& matter) {
    return {law::Elastic::derive(matter.stiffness), {}};
}

inline law::StrengthCaps strength_caps_of(const Matter& m) {
    return law::strength_caps(m.stiffness, m.moduli, m.thickness, m.strength, m.toughness, m.rate_factor);
}
inline law::FacetCaps facet_caps_of(const Matter& m) {
    return law::facet_caps(m.moduli, m.thickness, m.strength, m.toughness, m.rate_factor);
}

inline DerivedLaw<law::Plateau> derived(const PlateauBonds& said, const Matter& matter) {
    return {law::Plateau::derive(strength_caps_of(matter), said.break_in_shear),
            law::Plateau::derive(facet_caps_of(matter), said.break_in_shear)};
}

inline DerivedLaw<law::Softening> derived(const SofteningBonds& /*said*/, const Matter& matter) {
    return {strength_caps_of(matter), facet_caps_of(matter)};
}

inline DerivedLaw<law::BrittleTensile> derived(const BrittleTensileBonds& /*said*/, const Matter& m) {
    return {law::BrittleTensile::derive(m.stiffness, m.thickness, m.strength, m.rate_factor),
            law::BrittleTensile::derive_tractions(m.thickness, m.strength, m.rate_factor)};
}

inline DerivedLaw<law::BrittleToughness> derived(const BrittleToughnessBonds& /*said*/, const Matter& m) {
    return {law::BrittleToughness::derive(m.stiffness, m.thickness, m.toughness, m.rate_factor),
            law::BrittleToughness::derive_tractions(m.thickness, m.toughness, m.rate_factor)};
}

inline DerivedLaw<law::Cohesive> derived(const CohesiveBonds& /*said*/, const Matter& m) {
    return {{},
            law::Cohesive::derive_tractions(m.moduli, m.thickness, m.strength, m.toughness, m.rate_factor, m.friction)};
}

/// Whether a choice of bonds takes strain-rate factors.
template <class Choice>
inline constexpr bool takes_rates = requires(const Choice& said) {
    said.rate_compressive_strength;
};

/// The same law under strain-rate factors.
template <class Law>
DerivedLaw<law::RateDependent<Law>> rate_dependent(const DerivedLaw<Law>& plain, law::RateParams rate) {
    return {{plain.params, rate}, {plain.tractions, rate}};
}

template <class Choice>
using LawOf = typename decltype(derived(std::declval<const Choice&>(), std::declval<const Matter&>()))::law;

} // namespace demlua::model
