// Bonds of a freshly packed body, with the law the scene gives it.
#pragma once

#include "engine/law/rayleigh.hpp"
#include "engine/law/stiffness.hpp"
#include "engine/model/scene.hpp"
#include "engine/packing/cells.hpp"
#include "engine/state/state.hpp"

#include <optional>

namespace demlua::state {

/// A body to be bonded: its row of state.bodies, and the cells of its elements where the network needs them.
struct BondedBody {
    std::size_t body = 0;
    model::Network network = model::Network::contacts; ///< not automatic
    const packing::Cells* cells = nullptr;             ///< for facets and delaunay
};

/// Time in which a wave of the speed sqrt(E*/density) passes a mean diameter of the body's elements, s. `density` in kg/m^3.
double wave_time(const State& state, const Body& body, law::PlaneModuli moduli, double density);

/// Bonds of a body at zero force, or nothing when it asks for none or no two elements are near enough. The dashpots are
/// the law's own fraction of critical of one bond.
std::optional<AnyBondSet> bond_body(const State& state, const BondedBody& body, const model::BondChoice& choice,
                                    const model::Material& material, model::Plane plane);

/// Adds dashpots beta Kn and beta Kt (`beta` in s) to the bonds, or changes them by that much when present.
void add_stiffness_damping(AnyBondSet& bonds, double beta);

/// Breaks the bonds of `body` that the straight cut crosses: no force passes through them from the next computation of
/// forces on. Returns how many.
std::size_t cut(State& state, std::size_t body, Vec2 from, Vec2 to);

} // namespace demlua::state
