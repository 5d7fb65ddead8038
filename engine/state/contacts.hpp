// Pairs of elements that are not bonded and near enough to touch before the next search.
#pragma once

#include "engine/base/column.hpp"
#include "engine/law/coulomb.hpp"
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
    Incidence incidence;

    std::vector<PairRule> rules; ///< of materials a and b at a * materials + b
    std::size_t materials = 0;
    SpentInContacts spent;

    [[nodiscard]] std::size_t size() const { return i.size(); }
};

} // namespace demlua::state
