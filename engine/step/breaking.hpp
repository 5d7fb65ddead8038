// What happens at the instant a bond fails.
#pragma once

#include "engine/state/state.hpp"

#include <vector>

namespace demlua::step {

/// A contact that must be on the list before contact forces are next computed.
struct NewContact {
    Index i = 0;
    Index j = 0;
    double reference = 0.0; ///< m
    state::ContactHistory history;
};

/// Takes the bonds named in `breaking` (rows, rising) out of the set: no force from this instant on, energies booked,
/// and a contact in each one's place. Its reference length is the bond's unstressed length, no longer than the sum of the
/// radii if the bond broke in tension: falling back to the radii would release the pack's overlap as energy.
template <class Law>
void settle_broken(state::State& state, state::BondSet<Law>& bonds, const std::vector<Index>& breaking,
                   std::vector<NewContact>& contacts);

} // namespace demlua::step
