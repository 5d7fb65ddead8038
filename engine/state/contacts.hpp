// Pairs of elements that are not bonded and near enough to touch before the next search.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/struct_columns.hpp"
#include "engine/law/coulomb.hpp"
#include "engine/law/rolling.hpp"
#include "engine/state/history.hpp"
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
    static constexpr std::array<double PairRule::*, 5> members{
        &PairRule::Kn, &PairRule::Kt, &PairRule::mu, &PairRule::damping_fraction, &PairRule::rolling_friction};

    [[nodiscard]] law::Coulomb::Params params() const { return {Kn, Kt, mu}; }
};

/// Moments against rolling; empty columns where no material has any.
struct RollingContacts {
    Column<double> stiffness, dashpot; ///< N m, N m s
    Column<double> radius;             ///< reduced, m
    HistoryColumns<law::Rolling::History<double>> history;

    [[nodiscard]] bool present() const { return !stiffness.empty(); }
    void push_back(double reduced_radius, double Kt, double damping_fraction, double reduced_inertia,
                   const law::Rolling::History<double>& past);
};

/// Energy spent in contacts that are no longer listed, J.
struct SpentInContacts {
    double friction = 0.0;
    double damping = 0.0;
};

/// Rows in rising order of (i, j) from the last search on, and after them those of bonds that have broken since.
struct Contacts {
    Column<Index> i, j;       ///< rows of elements, i < j
    Column<Index> rule;       ///< row of `rules`
    Column<double> reference; ///< distance at which they touch, m
    Column<double> share_i;   ///< R_i/(R_i + R_j)
    Column<double> Cn, Ct;    ///< N s/m
    Column<double> overlap;   ///< positive while touching, m
    Column<double> fx, fy;    ///< on i; on j the opposite, N; zeros in the row `slots` names where there is no pair
    Column<double> moment_i, moment_j; ///< N m; likewise
    HistoryColumns<ContactHistory> history;
    RollingContacts rolling; ///< only if `rolls`
    bool rolls = false;      ///< whether any rule has rolling friction
    PairSlots slots;         ///< of the rows up to `in_slots`; those after are few
    std::size_t in_slots = 0;

    StructColumns<PairRule> rules; ///< of materials a and b at a * materials + b
    std::size_t materials = 0;
    SpentInContacts spent;

    [[nodiscard]] std::size_t size() const { return i.size(); }
};

} // namespace demlua::state
