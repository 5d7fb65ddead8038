// Pairs of elements that are not bonded and near enough to touch before the next search.
#pragma once

#include "engine/base/column.hpp"
#include "engine/law/coulomb.hpp"
#include "engine/law/rolling.hpp"
#include "engine/state/bonds.hpp"
#include "engine/state/history.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace demlua::state {

using ContactHistory = law::Coulomb::History<double>;

/// Law of contact between two materials: the spring and friction, and the dashpots as a fraction of critical.
struct PairRule {
    law::Coulomb::Params params;
    double damping_fraction = 0.0;
    double rolling_friction = 0.0;
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

/// Rows in rising order of (i, j).
struct Contacts {
    Column<Index> i, j;       ///< rows of elements, i < j
    Column<Index> rule;       ///< row of `rules`
    Column<double> reference; ///< distance at which they touch, m
    Column<double> Cn, Ct;    ///< N s/m
    Column<double> overlap;   ///< positive while touching, m
    Column<double> fx, fy;    ///< on i; on j the opposite, N
    Column<double> moment_i, moment_j;
    HistoryColumns<ContactHistory> history;
    RollingContacts rolling; ///< only if `rolls`
    bool rolls = false;      ///< whether any rule has rolling friction
    Incidence incidence;

    std::vector<PairRule> rules; ///< of materials a and b at a * materials + b
    std::size_t materials = 0;
    SpentInContacts spent;

    [[nodiscard]] std::size_t size() const { return i.size(); }
};

} // namespace demlua::state
