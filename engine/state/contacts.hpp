// Pairs of elements that are not bonded and near enough to touch before the next search.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/struct_columns.hpp"
#include "engine/law/coulomb.hpp"
#include "engine/law/rolling.hpp"
#include "engine/law/spent.hpp"
#include "engine/state/history.hpp"
#include "engine/state/lane_sums.hpp"
#include "engine/state/pair_forces.hpp"
#include "engine/state/pair_slots.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace demlua::state {

using ContactHistory = law::Coulomb::History<double>;

/// Law of contact between two materials: the spring and friction, and the dashpots as a fraction of critical.
struct PairRule {
    double Kn = 0.0; ///< N/m
    double Kt = 0.0; ///< N/m
    double mu = 0.0;
    double damping_fraction = 0.0;
    double rolling_friction = 0.0;
    double shear_damping = 0.0; ///< Ct/Cn: dashpots are the same fraction of critical in both directions
    static constexpr std::array<double PairRule::*, 6> members{
        &PairRule::Kn,           &PairRule::Kt, &PairRule::mu, &PairRule::damping_fraction, &PairRule::rolling_friction,
        &PairRule::shear_damping};

    [[nodiscard]] law::Coulomb::Params params() const { return {Kn, Kt, mu}; }
};

/// Moments against rolling; empty columns where no material has any.
struct RollingContacts {
    Column<double> stiffness, dashpot; ///< N m, N m s
    Column<double> radius;             ///< reduced, m
    HistoryColumns<law::Rolling::History<double>> history;
    StructColumns<law::Spent<double>> spent;

    [[nodiscard]] bool present() const { return !stiffness.empty(); }
    void push_back(double reduced_radius, double Kt, double damping_fraction, double reduced_inertia,
                   const law::Rolling::History<double>& past, const law::Spent<double>& past_spent);
};

/// Rows in rising order of (i, j) from the last search on, and after them those of bonds that have broken since.
struct Contacts {
    Column<Index> i, j;       ///< rows of elements, i < j
    Column<Index> rule;       ///< row of `rules`
    Column<double> reference; ///< distance at which they touch, m
    Column<double> share_i;   ///< R_i/(R_i + R_j)
    Column<double> Cn;        ///< N s/m
    PairForces forces;        ///< in quads; zeros in the row `slots` names where there is no pair
    HistoryColumns<ContactHistory> history;
    LaneSums friction, damped; ///< spent by the rows but in rolling, J
    Column<double> slid;       ///< the friction of each row, J; empty where no element wears
    RollingContacts rolling;   ///< only if `rolls`
    bool rolls = false;        ///< whether any rule has rolling friction
    PairSlots slots;           ///< of the rows up to `in_slots`; those after are few
    std::size_t in_slots = 0;

    StructColumns<PairRule> rules; ///< of materials a and b at a * materials + b
    std::size_t materials = 0;
    law::Spent<double> booked; ///< in contacts that are no longer listed

    [[nodiscard]] std::size_t size() const { return i.size(); }
    /// By contacts of now and before, rolling of now left out, J.
    [[nodiscard]] law::Spent<double> spent() const {
        return {booked.friction + friction.total(), booked.damped + damped.total()};
    }
};

} // namespace demlua::state
