// Bonds of a freshly packed body, with the law the scene gives it.
#pragma once

#include "engine/law/rayleigh.hpp"
#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"

#include <optional>

namespace demlua::state {

/// Bonds of `body` (a row of state.bodies) at zero force, or nothing when it asks for none or no two elements are near
/// enough. The dashpots are the law's own fraction of critical of one bond.
std::optional<AnyBondSet> bond_body(const State& state, std::size_t body, const model::BondChoice& choice,
                                    const model::Material& material, model::Plane plane);

/// Adds dashpots beta Kn and beta Kt (`beta` in s) to the bonds, or changes them by that much when present.
void add_stiffness_damping(AnyBondSet& bonds, double beta);

/// Breaks the bonds of `body` that the straight cut crosses, before any force has passed through them. Returns how many.
std::size_t cut(State& state, std::size_t body, Vec2 from, Vec2 to);

} // namespace demlua::state
