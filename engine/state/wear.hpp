// What sliding has done to the elements of clusters (Tavarez & Plesha 2007, section 3, eqs 1 and 2).
//
//   W_i = sum over contacts with elements of other clusters, and with walls, of the integral of Ft d(slip)
//
// An element leaves its cluster when W_i exceeds W0 times its volume. Both sides of a contact count its whole work.
#pragma once

#include "engine/base/column.hpp"
#include "engine/state/elements.hpp"

#include <cstddef>

namespace demlua::state {

struct Wear {
    Column<double> limit;   ///< W0 V of an element; infinite for one that has no cluster to leave, J
    Column<double> past;    ///< W in contacts that are no longer listed, J
    std::size_t left = 0;   ///< elements that have left their cluster
    Index next_cluster = 0; ///< number for the next that leaves

    [[nodiscard]] bool present() const { return !limit.empty(); }
    /// Keeps what a contact of i and j that leaves the list has spent in sliding, J.
    void book(const Elements& elements, Index i, Index j, double friction) {
        if (elements.cluster[i] == elements.cluster[j]) return;
        past[i] += friction;
        past[j] += friction;
    }
};

} // namespace demlua::state
