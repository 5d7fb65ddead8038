// What can be seen of one bond.
#pragma once

#include "engine/state/state.hpp"
#include "engine/step/facet_forces.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace demlua::observe {

inline constexpr double uncapped = std::numeric_limits<double>::infinity();

enum BondState : std::int32_t { elastic = 0, yielded = 1, broken = 2 };

struct BondReading {
    law::BondForce<double> force{}; ///< of its springs; zero when broken, N
    law::BondForce<double> caps{
        uncapped, uncapped}; ///< greatest tension and shear force it bears now, infinite where the law has no cap, N
    double stretch = 0.0;    ///< m
    double slide = 0.0;      ///< shear displacement, m
    double damage = 0.0;     ///< 0 to 1, which is broken
    BondState state = elastic;
};

/// 0 for laws that do not break.
template <class Bonds>
double bond_damage(const Bonds& bonds, std::size_t k) {
    using Law = typename Bonds::law;
    if constexpr (Law::breaks) {
        if (bonds.is_broken(k)) return 1.0;
        return Law::damage(step::params_of(bonds, k), step::law_radius(bonds, k), bonds.history.at(k));
    }
    return 0.0;
}

/// Bond k at the present instant.
template <class Bonds>
BondReading read_bond(const Bonds& bonds, const state::Elements& elements, std::size_t k) {
    using Law = typename Bonds::law;
    const law::BondMotion<double> motion = step::motion_of(bonds, elements, k);
    BondReading bond;
    bond.stretch = motion.stretch;
    bond.slide = motion.shear;
    bond.damage = bond_damage(bonds, k);
    if constexpr (Law::breaks) {
        bond.caps = Law::caps(step::params_of(bonds, k), step::law_radius(bonds, k), bonds.history.at(k));
    }
    if (bonds.is_broken(k)) {
        bond.state = broken;
        for (double* cap : {&bond.caps.normal, &bond.caps.shear}) {
            if (*cap != uncapped) *cap = 0.0;
        }
        return bond;
    }
    bond.force = step::held_force(bonds, elements, k);
    if (bond.damage > 0.0) bond.state = yielded;
    return bond;
}

} // namespace demlua::observe
