// What happens at the instant a bond fails.
#pragma once

#include "engine/state/state.hpp"
#include "engine/step/facet_forces.hpp"

#include <algorithm>
#include <vector>

namespace demlua::step {

/// A contact that must be on the list before contact forces are next computed.
struct NewContact {
    Index i = 0;
    Index j = 0;
    double reference = 0.0; ///< m
    state::ContactHistory history;
};

/// The contact a bond leaves while its elements are pressed together: it carries on with the bond's shear force, as far as
/// friction lets it. The step's own displacement is taken off because the contact loop will count it.
state::ContactHistory inherited(const law::Coulomb::Params& contact, double overlap, double shear_force, double slide);

/// Takes bond `k` out of the energy of its set and gives what is lost, J.
template <class Law>
double let_go(const state::BondSet<Law>& bonds, const state::Elements& elements, std::size_t k, double /*dt*/) {
    return stored_energy(bonds, elements, k);
}

/// How a bond with params `spring` broke: in tension when it had opened more than it had slid, that is when an unyielding
/// spring would have stored at least as much in the opening, Kn e^2 >= Kt ut^2 with e > 0.
template <class Params>
state::CrackMode crack_mode(const Params& spring, const law::BondMotion<double>& motion) {
    const double opened = spring.Kn * motion.stretch * motion.stretch;
    const double slid = spring.Kt * motion.shear * motion.shear;
    return motion.stretch > 0.0 && opened >= slid ? state::CrackMode::tension : state::CrackMode::shear;
}

/// Spent by bond `k` while it yielded, J.
template <class Law>
double plastic_work(const state::BondTable<Law>& bonds, std::size_t k) {
    if constexpr (Law::yields) return bonds.history.at(k).work;
    return 0.0;
}

/// Takes back what the dashpots of bond `k` booked for the end of the step, where they no longer act.
template <class Law>
void let_go_of_dashpots(state::BondTable<Law>& bonds, std::size_t k, law::BondForce<double> rate, double dt) {
    state::BondDashpots& dashpots = bonds.dashpots;
    if (!dashpots.present()) return;
    dashpots.spent.sums[state::LaneSums::place(k)] -=
        0.5 * dt * (dashpots.normal[k] * rate.normal + dashpots.shear[k] * rate.shear);
    dashpots.normal[k] = dashpots.shear[k] = 0.0;
}

/// Takes the bonds named in `breaking` (rows, rising) out of the set: no force from this instant on, energies booked,
/// a row of the cracks, and a contact in each one's place. Its reference length is that at which the contact carries on
/// with the bond's normal force (which is the bond's unstressed length where both are as stiff), no longer than the sum of
/// the radii unless the bond broke under pressure: falling back to the radii would release the pack's overlap as energy.
template <class Bonds>
void settle_broken(state::State& state, Bonds& bonds, const std::vector<Index>& breaking,
                   std::vector<NewContact>& contacts) {
    if constexpr (Bonds::law::breaks) {
        const state::Elements& elements = state.elements;
        const std::size_t material = state.bodies[bonds.body].material;
        const law::Coulomb::Params contact =
            state.contacts.rules[material * state.contacts.materials + material].params();
        for (const Index k : breaking) {
            const std::size_t i = bonds.i[k];
            const std::size_t j = bonds.j[k];
            const law::BondMotion<double> motion = motion_of(bonds, elements, k);
            const law::BondForce<double> force = held_force(bonds, elements, k);
            const law::BondForce<double> rate = rates_of(bonds, elements, k, motion);
            const double touch = elements.radius[i] + elements.radius[j];
            const double length = bonds.length[k] + motion.stretch;
            const double unstressed = bonds.length[k] + (motion.stretch - force.normal / contact.Kn);
            const double reference = force.normal < 0.0 ? unstressed : std::min(unstressed, touch);
            const double overlap = reference - length;

            NewContact left{static_cast<Index>(i), static_cast<Index>(j), reference,
                            inherited(contact, overlap, force.shear, rate.shear * state.dt)};
            state::ContactHistory settled = left.history;
            if (overlap > 0.0) settled.shear += rate.shear * state.dt;
            const law::BondForce<double> kept{-contact.Kn * std::max(overlap, 0.0), contact.Kt * settled.shear};
            // The step that led here moved under the mean of the forces at its ends, not under the bond's alone.
            const double moved_by_less =
                0.5 * state.dt * ((force.normal - kept.normal) * rate.normal + (force.shear - kept.shear) * rate.shear);
            const double lost = let_go(bonds, elements, k, state.dt) -
                                law::Coulomb::stored_energy(contact, overlap, settled) - moved_by_less;
            bonds.fracture_work += lost;
            state::Crack crack = state::crack_of(bonds, elements, k, state.time, state.step);
            const bool worn = state.wear.present() && elements.cluster[i] != elements.cluster[j];
            crack.mode = worn ? state::CrackMode::wear : crack_mode(params_of(bonds, k), motion);
            crack.energy = plastic_work(bonds, k) + lost;
            state.cracks.push_back(crack);
            let_go_of_dashpots(bonds, k, rate, state.dt);
            bonds.note_break(k, state.time, reference);
            contacts.push_back(left);
        }
    }
}

} // namespace demlua::step
