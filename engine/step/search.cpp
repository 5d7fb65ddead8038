#include "engine/step/search.hpp"

#include "engine/state/pair_slots.hpp"
#include "engine/step/contact_past.hpp"
#include "engine/step/outline_search.hpp"
#include "engine/step/wall_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <variant>

namespace demlua::step {

namespace {

// A wider skin is searched less often but lists more pairs. Of a disk of radius R in a bed, 1.7 s/R pairs more are listed
// with a skin s; a search is due every s/(2v) steps, v the path in a step. The cheapest skin is s = R sqrt(c v/R), c the cost
// of a search over 0.85 of that of a listed pair in a step: about a hundred.
constexpr double search_over_pair = 100.0;
constexpr double least_skin = 0.05; // in largest radii: beds at rest tremble
constexpr double greatest_skin = 0.8;

double skin_at(double path_in_a_step, double largest) {
    return largest * std::clamp(std::sqrt(search_over_pair * path_in_a_step / largest), least_skin, greatest_skin);
}

/// What the bonds of a body say about a pair of its elements, i < j.
struct BondedPair {
    bool intact = false;
    double reference = 0.0; ///< of the contact a broken bond left; 0 when there never was a bond, m
};

BondedPair look_up(const state::State& state, const Search& search, std::size_t i, std::size_t j) {
    const std::size_t set = search.bond_set_of_body[state.elements.body[i]];
    if (set == state.bond_sets.size()) return {};
    return std::visit(
        [&](const auto& bonds) -> BondedPair {
            BondedPair pair;
            state::for_each_pair_from(bonds.slots, i, [&](std::size_t bond) {
                if (bonds.j[bond] != j) return;
                // What is marked to break holds until the bonds of this step are computed, and then leaves its contact.
                pair.intact = !bonds.is_broken(bond) || bonds.broken[bond] == state::failing;
                if (!pair.intact) pair.reference = bonds.contact_length[bond];
            });
            return pair;
        },
        state.bond_sets[set]);
}

/// A row of the list while it is being made.
struct Candidate {
    Index i;
    Index j;
    double reference;

    [[nodiscard]] auto key() const { return std::tie(i, j); }
};

/// What one share of the grid's points has found.
struct Found {
    std::vector<Candidate> pairs;
    double clearance = std::numeric_limits<double>::infinity(); ///< least gap, m
};

/// By i, then by j.
std::vector<Candidate> in_order(const std::vector<Found>& shares, std::size_t elements, Team& team) {
    Column<Index> next(elements + 1, 0);
    for (const Found& share : shares) {
        for (const Candidate& pair : share.pairs) ++next[pair.i + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Candidate> ordered(next[elements]);
    for (const Found& share : shares) {
        for (const Candidate& pair : share.pairs) ordered[next[pair.i]++] = pair;
    }
    const auto at = [&](std::size_t row) { return ordered.begin() + static_cast<std::ptrdiff_t>(row); };
    team.share(elements, [&](Share part) {
        for (std::size_t i = part.begin; i < part.end; ++i) {
            std::sort(at(i == 0 ? 0 : next[i - 1]), at(next[i]),
                      [](const auto& a, const auto& b) { return a.j < b.j; });
        }
    });
    return ordered;
}

/// Reference length of a pair that was in one rigid cluster, or that of its radii.
double touch_of(const state::State& state, Index i, Index j) {
    const double touch = state.elements.radius[i] + state.elements.radius[j];
    const auto found = std::lower_bound(
        state.former_mates.begin(), state.former_mates.end(), std::tie(i, j),
        [](const state::FormerMates& mates, const auto& key) { return std::tie(mates.i, mates.j) < key; });
    const bool mates = found != state.former_mates.end() && found->i == i && found->j == j;
    return mates ? found->reference : touch;
}

/// The pairs of points `part` of the grid that are to be listed.
Found found_by(const state::State& state, const Search& search, double reach, Share part) {
    const state::Elements& elements = state.elements;
    const Places& places = search.places;
    Found found;
    search.grid.for_each_pair_of(part.begin, part.end, reach, [&](Index a, Index b) {
        if (std::min(a, b) >= places.first_image) return;
        const Index i = std::min(places.element[a], places.element[b]);
        const Index j = std::max(places.element[a], places.element[b]);
        double reference = touch_of(state, i, j);
        if (elements.body[i] == elements.body[j]) {
            if (const auto rigid = state.rigid_of(i); rigid && rigid == state.rigid_of(j)) return;
            const BondedPair bonded = look_up(state, search, i, j);
            if (bonded.intact) return;
            if (bonded.reference > 0.0) reference = bonded.reference;
        }
        const double gap = norm(places.at[a] - places.at[b]) - reference;
        if (gap >= search.skin) return;
        found.clearance = std::min(found.clearance, gap);
        found.pairs.push_back({i, j, reference});
    });
    return found;
}

std::vector<Candidate> candidates(const state::State& state, Search& search, Team& team) {
    const state::Elements& elements = state.elements;
    const double largest = *std::max_element(elements.radius.begin(), elements.radius.end());
    const double reach = 2.0 * largest + search.excess + search.skin;
    search.places = places_of(state, reach);
    search.grid.build(search.places.at, reach);
    std::vector<Found> shares(team.parts());
    team.share(search.places.at.size(), [&](Share part) { shares[part.part] = found_by(state, search, reach, part); });
    search.clearance = std::numeric_limits<double>::infinity();
    for (const Found& share : shares) search.clearance = std::min(search.clearance, share.clearance);
    return in_order(shares, elements.size(), team);
}

void append_row(state::State& state, const Candidate& pair, const ContactPast& past) {
    state::Contacts& contacts = state.contacts;
    const state::Elements& elements = state.elements;
    const std::size_t a = state.bodies[elements.body[pair.i]].material;
    const std::size_t b = state.bodies[elements.body[pair.j]].material;
    const std::size_t row = a * contacts.materials + b;
    const state::PairRule rule = contacts.rules[row];
    const double m = 1.0 / (1.0 / state.pushed_mass(pair.i) + 1.0 / state.pushed_mass(pair.j));
    contacts.i.push_back(pair.i);
    contacts.j.push_back(pair.j);
    contacts.rule.push_back(static_cast<Index>(row));
    contacts.reference.push_back(pair.reference);
    contacts.share_i.push_back(elements.radius[pair.i] / (elements.radius[pair.i] + elements.radius[pair.j]));
    contacts.Cn.push_back(2.0 * rule.damping_fraction * std::sqrt(rule.Kn * m));
    contacts.history.push_back(past.contact);
    if (state.wear.present()) contacts.slid.push_back(past.spent.friction);
    if (!contacts.rolls) return;
    const double r = 1.0 / (1.0 / elements.radius[pair.i] + 1.0 / elements.radius[pair.j]);
    const double inertia = 1.0 / (elements.inverse_inertia[pair.i] + elements.inverse_inertia[pair.j]);
    contacts.rolling.push_back(r, rule.Kt, rule.damping_fraction, inertia, past.rolling, past.spent_in_rolling);
}

/// Room for contacts that broken bonds leave before the next search, so that slots are not made anew for each of them.
constexpr std::size_t spare_rows = 256;

void finish(state::State& state) {
    state::Contacts& contacts = state.contacts;
    if (contacts.in_slots > 0 && contacts.size() < contacts.slots.none) return;
    contacts.slots = state::slots_of(contacts.i, contacts.j, 0, state.elements.size(), spare_rows);
    contacts.in_slots = contacts.size();
    contacts.forces.lay_out_quads(contacts.slots.none + 1);
    contacts.friction.cover(contacts.slots.none);
    contacts.damped.cover(contacts.slots.none);
}

state::Contacts emptied(const state::Contacts& old) {
    state::Contacts contacts;
    contacts.rules = old.rules;
    contacts.materials = old.materials;
    contacts.rolls = old.rolls;
    contacts.booked = old.spent();
    return contacts;
}

ContactPast kept_of(const state::Contacts& old, std::size_t row) {
    ContactPast past = past_of(old, row);
    if (!old.slid.empty()) past.spent.friction = old.slid[row];
    return past;
}

bool has_force(const ContactPast& past) {
    return past.contact.force != 0.0 || past.contact.damping != 0.0 || past.rolling.moment != 0.0;
}

/// What a pair that leaves the list had spent, and what it still stores if an element was taken out.
void book(state::State& state, const state::Contacts& old, std::size_t row) {
    const ContactPast past = kept_of(old, row);
    const Index i = old.i[row];
    const Index j = old.j[row];
    state.contacts.booked += past.spent_in_rolling;
    if (state.wear.present()) state.wear.book(state.elements, i, j, past.spent.friction);
    if (!state.is_gone(i) && !state.is_gone(j)) return;
    const double overlap = old.reference[row] - state.distance(i, j);
    const double kr = old.rolls ? old.rolling.stiffness[row] : 0.0;
    state.booked.removed += stored_in(past, old.rules[old.rule[row]].params(), overlap, kr);
}

/// Rows of the old list in rising order of (i, j): bonds that broke since the last search stand unsorted at its end.
std::vector<std::size_t> sorted_rows(const state::Contacts& old) {
    std::vector<std::size_t> rows(old.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    const auto before = [&](std::size_t a, std::size_t b) {
        return std::tie(old.i[a], old.j[a]) < std::tie(old.i[b], old.j[b]);
    };
    const auto late = std::is_sorted_until(rows.begin(), rows.end(), before);
    std::sort(late, rows.end(), before);
    std::inplace_merge(rows.begin(), late, rows.end(), before);
    return rows;
}

void refresh_pairs(state::State& state, Search& search, Team& team) {
    const std::vector<Candidate> found = candidates(state, search, team);
    const state::Contacts old = std::exchange(state.contacts, emptied(state.contacts));
    const std::vector<std::size_t> rows = sorted_rows(old);
    auto next = rows.begin();
    const auto book_until = [&](const Candidate& pair) {
        for (; next != rows.end() && std::tie(old.i[*next], old.j[*next]) < pair.key(); ++next) {
            book(state, old, *next);
        }
    };
    for (const Candidate& pair : found) {
        book_until(pair);
        ContactPast past;
        if (next != rows.end() && std::tie(old.i[*next], old.j[*next]) == pair.key()) {
            past = kept_of(old, *next++);
            if (has_force(past)) search.clearance = std::min(search.clearance, 0.0);
        }
        append_row(state, pair, past);
    }
    for (; next != rows.end(); ++next) book(state, old, *next);
    finish(state);
}

} // namespace

Search start_search(const state::State& state) {
    Search search;
    const Column<double>& radius = state.elements.radius;
    search.skin = search.greatest_skin = greatest_skin * *std::max_element(radius.begin(), radius.end());
    search.bond_set_of_body.assign(state.bodies.size(), state.bond_sets.size());
    for (std::size_t set = 0; set < state.bond_sets.size(); ++set) {
        std::visit([&](const auto& bonds) { search.bond_set_of_body[bonds.body] = set; }, state.bond_sets[set]);
    }
    return search;
}

void refresh_contacts(state::State& state, Search& search, Team& team) {
    if (search.steps > 0) {
        const double path = search.travelled / static_cast<double>(search.steps);
        search.skin = skin_at(path, search.greatest_skin / greatest_skin);
    }
    refresh_pairs(state, search, team);
    refresh_wall_contacts(state, search.skin, search.places, search.grid);
    refresh_outline_contacts(state, search.skin);
    // An intact body is searched once: what that took would be held for the whole run.
    if (state.contacts.size() == 0) {
        search.places = {};
        search.grid = {};
    }
    search.travelled = 0.0;
    search.steps = 0;
    ++search.searches;
}

void append_contacts(state::State& state, Search& search, const std::vector<NewContact>& contacts) {
    if (contacts.empty()) return;
    search.clearance = 0.0;
    for (const NewContact& contact : contacts) {
        const double touch = state.elements.radius[contact.i] + state.elements.radius[contact.j];
        search.excess = std::max(search.excess, contact.reference - touch);
        append_row(state, {contact.i, contact.j, contact.reference}, {contact.history, {}, {}, {}});
    }
    finish(state);
}

} // namespace demlua::step
