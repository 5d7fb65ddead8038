// Which pairs may touch: searched only when something has moved far enough for the last answer to be in doubt.
#pragma once

#include "engine/base/cell_grid.hpp"
#include "engine/base/team.hpp"
#include "engine/state/state.hpp"
#include "engine/step/breaking.hpp"
#include "engine/step/places.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace demlua::step {

/// Every pair that could come nearer than its reference length is on the list as long as no two surfaces have closed by
/// more than `skin` since the list was made.
struct Search {
    double skin = 0.0;          ///< m
    double greatest_skin = 0.0; ///< m
    double travelled = 0.0;     ///< upper bound of what any element or wall has moved since the list was made, m
    std::uint64_t steps = 0;    ///< since the list was made; 0 also where what has been travelled is not known
    double clearance = 0.0;     ///< least gap of the pairs listed, m; at most 0 if one touches or has just let go
    double excess = 0.0;        ///< most by which a broken bond's reference length exceeds its radii, m
    std::uint64_t searches = 0;
    std::vector<std::size_t> bond_set_of_body; ///< row of State::bond_sets, or its size for none
    Places places;                             ///< of the last search
    CellGrid grid;                             ///< of these
};

/// Skin and tables for a freshly assembled state; the list itself is made by refresh_contacts.
Search start_search(const state::State& state);

[[nodiscard]] inline bool in_doubt(const Search& search) { return 2.0 * search.travelled > search.skin; }

/// Whether any pair listed may touch by now.
[[nodiscard]] inline bool may_touch(const Search& search) { return 2.0 * search.travelled >= search.clearance; }

/// Adds a step in which nothing has moved farther than `farthest`, m.
inline void travel(Search& search, double farthest) {
    search.travelled += farthest;
    ++search.steps;
}
/// The list is to be made anew before it is used again.
inline void put_in_doubt(Search& search) {
    search.travelled = std::numeric_limits<double>::infinity();
    search.steps = 0;
}
/// Whether elements have been moved by other than steps since the list was made.
[[nodiscard]] inline bool is_unknown(const Search& search) {
    return search.travelled == std::numeric_limits<double>::infinity();
}

/// Makes the lists of contacts and wall contacts anew, with a skin for the pace of late. Histories of pairs that stay are
/// kept; what the others had spent is booked.
void refresh_contacts(state::State& state, Search& search, Team& team);

/// Puts the contacts of bonds that have just broken on the list.
void append_contacts(state::State& state, Search& search, const std::vector<NewContact>& contacts);

} // namespace demlua::step
