#include "engine/step/wear.hpp"

#include "engine/step/rigid_motion.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <variant>
#include <vector>

namespace demlua::step {

namespace {

/// Calls `work(row)` for the contacts of element k that are listed now, with elements of its own cluster (`inside`) or of others.
template <class Work>
void for_each_contact(const state::State& state, std::size_t k, bool inside, const Work& work) {
    const state::Contacts& contacts = state.contacts;
    const Column<Index>& cluster = state.elements.cluster;
    const auto visit = [&](std::size_t c) {
        if ((cluster[contacts.i[c]] == cluster[contacts.j[c]]) == inside) work(c);
    };
    state::for_each_pair_of(contacts.slots, k, [&](std::size_t c, bool /*is_j*/) { visit(c); });
    for (std::size_t c = contacts.in_slots; c < contacts.size(); ++c) {
        if (contacts.i[c] == k || contacts.j[c] == k) visit(c);
    }
}

/// Sliding work of the contacts of element k with elements of other clusters, J.
double listed_work(const state::State& state, std::size_t k) {
    double work = 0.0;
    for_each_contact(state, k, false, [&](std::size_t c) { work += state.contacts.slid[c]; });
    return work;
}

/// Friction between mates was none of the cluster's wear, and is not to become so.
void forget_inner_work(state::State& state, std::size_t k) {
    const state::Contacts& contacts = state.contacts;
    for_each_contact(state, k, true, [&](std::size_t c) {
        state.wear.past[contacts.i[c]] -= contacts.slid[c];
        state.wear.past[contacts.j[c]] -= contacts.slid[c];
    });
}

template <class Bonds>
bool mark_bonds(Bonds& bonds, std::size_t k) {
    bool some = false;
    if constexpr (Bonds::law::breaks) {
        state::for_each_pair_of(bonds.slots, k, [&](std::size_t bond, bool /*is_j*/) {
            if (bonds.is_broken(bond)) return;
            bonds.broken[bond] = state::failing;
            some = true;
        });
    }
    return some;
}

/// Contacts of an element with those it was rigidly joined to, at the distance there is: they overlapped for nothing.
std::vector<NewContact> part_from_mates(state::State& state, const std::vector<Index>& mates, std::size_t k) {
    const state::Elements& elements = state.elements;
    std::vector<NewContact> contacts;
    for (const Index mate : mates) {
        if (mate == k) continue;
        const Index i = std::min(mate, static_cast<Index>(k));
        const Index j = std::max(mate, static_cast<Index>(k));
        const double touch = elements.radius[i] + elements.radius[j];
        const double distance = state.distance(i, j);
        const double reference = std::min(touch, distance);
        if (distance < touch) state.former_mates.push_back({i, j, reference});
        contacts.push_back({i, j, reference, {}});
    }
    std::sort(state.former_mates.begin(), state.former_mates.end(),
              [](const auto& a, const auto& b) { return std::tie(a.i, a.j) < std::tie(b.i, b.j); });
    return contacts;
}

/// Whether there was a rigid body to leave.
bool leave_rigid(state::State& state, Search& search, std::size_t k) {
    const std::optional<std::size_t> row = state.rigid_of(k);
    if (!row) return false;
    const auto members = state.members(state.rigid_bodies[*row]);
    const std::vector<Index> mates(members.begin(), members.end());
    let_go_of_rigid(state, k);
    append_contacts(state, search, part_from_mates(state, mates, k));
    return true;
}

/// Whether bonds were marked. The last element of a cluster has none to leave.
bool leave_cluster(state::State& state, Search& search, std::size_t k) {
    forget_inner_work(state, k);
    const bool left_rigid = leave_rigid(state, search, k);
    bool marked = false;
    for (state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](auto& bonds) {
                if (bonds.body == state.elements.body[k]) marked = mark_bonds(bonds, k);
            },
            any);
    }
    state.wear.limit[k] = std::numeric_limits<double>::infinity();
    if (!left_rigid && !marked) return false;
    state.elements.cluster[k] = state.wear.next_cluster++;
    ++state.wear.left;
    return marked;
}

} // namespace

Column<double> sliding_work(const state::State& state, Team& team) {
    Column<double> work(state.elements.size());
    team.share(work.size(), [&](Share part) {
        for (std::size_t k = part.begin; k < part.end; ++k) work[k] = state.wear.past[k] + listed_work(state, k);
    });
    const state::WallContacts& walls = state.wall_contacts;
    for (std::size_t c = 0; c < walls.size(); ++c) work[walls.element[c]] += walls.spent.at(c).friction;
    return work;
}

bool wear_out(state::State& state, Search& search, Team& team) {
    const Column<double> work = sliding_work(state, team);
    bool marked = false;
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        if (work[k] > state.wear.limit[k]) marked = leave_cluster(state, search, k) || marked;
    }
    return marked;
}

} // namespace demlua::step
