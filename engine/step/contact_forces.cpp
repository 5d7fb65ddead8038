#include "engine/step/contact_forces.hpp"

#include "engine/step/pair_sums.hpp"

#include <cstddef>

namespace demlua::step {

namespace {

template <class History>
auto begins_of(state::HistoryColumns<History>& history) {
    std::array<double*, History::members.size()> begins{};
    for (std::size_t m = 0; m < begins.size(); ++m) begins[m] = history.columns[m].data();
    return begins;
}

RuleRows rows_of(const StructColumns<state::PairRule>& rules) {
    using state::PairRule;
    return {rules.column<&PairRule::Kn>().data(), rules.column<&PairRule::Kt>().data(),
            rules.column<&PairRule::mu>().data(), rules.column<&PairRule::rolling_friction>().data()};
}

/// Bonds that broke since the last search: few, and in no order of elements.
void add_late(const state::Contacts& contacts, state::Elements& elements) {
    for (std::size_t c = contacts.in_slots; c < contacts.size(); ++c) {
        const std::size_t i = contacts.i[c];
        const std::size_t j = contacts.j[c];
        elements.fx[i] += contacts.fx[c];
        elements.fy[i] += contacts.fy[c];
        elements.moment[i] += contacts.moment_i[c];
        elements.fx[j] -= contacts.fx[c];
        elements.fy[j] -= contacts.fy[c];
        elements.moment[j] += contacts.moment_j[c];
    }
}

} // namespace

ContactRows rows_of(state::Contacts& contacts) {
    state::RollingContacts& rolling = contacts.rolling;
    return {
        contacts.i.data(),           contacts.j.data(),        contacts.materials > 1 ? contacts.rule.data() : nullptr,
        contacts.reference.data(),   contacts.share_i.data(),  contacts.Cn.data(),
        contacts.Ct.data(),          contacts.overlap.data(),  contacts.fx.data(),
        contacts.fy.data(),          contacts.moment_i.data(), contacts.moment_j.data(),
        begins_of(contacts.history), rows_of(contacts.rules),  rolling.stiffness.data(),
        rolling.dashpot.data(),      rolling.radius.data(),    begins_of(rolling.history)};
}

PlaceRows places_of(const state::Elements& elements) {
    return {elements.reference_x.data(), elements.reference_y.data(), rows_of(elements)};
}

void contact_forces(state::State& state, const Kernels& kernels, Team& team) {
    state::Contacts& contacts = state.contacts;
    const ContactRows rows = rows_of(contacts);
    const PlaceRows elements = places_of(state.elements);
    const std::size_t kind = (contacts.rolls ? 1U : 0U) + (state.period.repeats() ? 2U : 0U);
    team.share(contacts.size(), [&](Share part) {
        run_rows(kernels, part, [&](const Kernels& width, std::size_t begin, std::size_t end) {
            width.contact_forces[kind](rows, elements, state.period, state.dt, begin, end);
        });
    });
    add_pair_forces(contacts, state.elements, kernels, team);
    add_late(contacts, state.elements);
}

} // namespace demlua::step
