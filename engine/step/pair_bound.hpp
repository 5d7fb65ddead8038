// The pair-energy bound of one body (time_step.hpp), and what it takes to know about the scene around it.
#pragma once

#include "engine/state/state.hpp"
#include "engine/step/contact_room.hpp"
#include "engine/step/springs.hpp"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace demlua::step {

/// What a step must allow for.
struct Facts {
    double smallest_radius = 0.0; ///< of the scene, m
    bool has_company = false;     ///< other bodies or walls
    std::vector<std::size_t>
        neighbours; ///< of each element: bonds that hold it, or elements of its rigid body beside it
};

Facts facts_of(const state::State& state);

/// Whether elements of the body can touch each other: it is not bonded, or by bonds that break.
bool can_loosen(const state::State& state, std::size_t body);

/// Contacts of element k with others beside the bonds it has.
Felt beside_bonds(const state::State& state, const Facts& facts, std::size_t k, bool loosens);

struct Tightest {
    double step = std::numeric_limits<double>::infinity();
    std::size_t at = 0; ///< element, or body
    std::string why;

    void offer(double candidate, std::size_t where, const std::string& reason) {
        if (candidate >= step) return;
        step = candidate;
        at = where;
        why = reason;
    }
};

/// `springs` of the body's bonds, scaled by M^-1/2. Safe for the bonds there are with contacts beside them and, when the body
/// can loosen, for contacts all round.
Tightest bound_of(const state::State& state, const Facts& facts, std::size_t body, const Springs& springs);

/// Safe for rigid bodies, and single elements of bodies called rigid, with contacts wherever they have room.
Tightest bound_of_rigid(const state::State& state, const Facts& facts);

/// The same for bonds alone, s.
double bound_of_bonds(const Springs& springs);

} // namespace demlua::step
