// Corners of outlines near enough to a wall, or to another outline, to touch it before the next search.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/law/spent.hpp"
#include "engine/state/contacts.hpp"

#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace demlua::state {

/// Few, so that a row is a whole and not columns.
struct OutlineContact {
    std::size_t wall = 0;    ///< row of State::walls: whose part is met
    std::size_t outline = 0; ///< likewise: whose corner meets it
    std::size_t corner = 0;  ///< row of Matter::corners
    std::size_t part = 0;    ///< of the wall, as in WallContacts
    PairRule rule;
    double Cn = 0.0; ///< where no other corner of the two touches, N s/m
    double Ct = 0.0;
    double overlap = 0.0; ///< positive while touching, m
    double damped = 0.0;  ///< Cn as it counts now, N s/m
    ContactHistory history;
    law::Spent<double> spent;

    [[nodiscard]] auto key() const { return std::tie(wall, outline, corner, part); }
};

/// Rows in rising order of (wall, outline, corner, part); none where no outline is free or none has company.
struct OutlineContacts {
    std::vector<OutlineContact> rows;
    double smallest_corner = std::numeric_limits<double>::infinity(); ///< of outlines that may meet something, m
    law::Spent<double> booked;                                        ///< in contacts that are no longer listed
};

} // namespace demlua::state
