// The energy and momentum of a state at a settled instant.
//
// Kinetic energy is m v- v+ / 2, of the half steps before and after: with it and the stored energy of the instant, central
// difference keeps the energy of a linear system exactly, so that what the ledger shows as error is not its own.
#pragma once

#include "engine/observe/snapshot.hpp"
#include "engine/state/state.hpp"

namespace demlua::observe {

/// Without `error`, which needs the start.
Ledger ledger_of(const state::State& state);

/// Sum of all energies less the work done: constant but for the error.
double balance(const Ledger& ledger);

Momentum momentum_of(const state::State& state);

BodyMotion motion_of_body(const state::State& state, std::size_t body);

WallMotion motion_of_wall(const state::State& state, std::size_t wall);

/// Walls and outlines with what they do.
void add_walls_to(Snapshot& snapshot, const state::State& state);

/// Velocity at the instant itself, m/s.
Vec2 velocity_now(const state::State& state, std::size_t element);

/// Spin at the instant itself, rad/s.
double spin_now(const state::State& state, std::size_t element);

} // namespace demlua::observe
