#include "engine/step/contact_forces.hpp"

#include "engine/step/pair_sums.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace demlua::step {

namespace {

template <class Struct>
auto begins_of(StructColumns<Struct>& table) {
    std::array<double*, Struct::members.size()> begins{};
    for (std::size_t m = 0; m < begins.size(); ++m) begins[m] = table.columns[m].data();
    return begins;
}

RuleRows rows_of(const StructColumns<state::PairRule>& rules) {
    using state::PairRule;
    return {rules.column<&PairRule::Kn>().data(), rules.column<&PairRule::Kt>().data(),
            rules.column<&PairRule::mu>().data(), rules.column<&PairRule::rolling_friction>().data(),
            rules.column<&PairRule::shear_damping>().data()};
}

/// Of the elements of contacts, and of some beside them.
void fill_records(const state::State& state, Column<double>& records, const Kernels& kernels, Team& team) {
    const state::Contacts& contacts = state.contacts;
    const std::size_t count = state.elements.size();
    records.resize(record::width * count);
    const PlaceRows elements = rows_of_places(state.elements);
    const Column<Index>& start = contacts.slots.start;
    constexpr std::size_t block = state::PairSlots::block;
    team.share(count, [&](Share part) {
        const auto touches = [&](std::size_t e) { return start[2 * (e / block)] < start[2 * (e / block) + 2]; };
        std::size_t e = part.begin;
        while (e < part.end) {
            while (e < part.end && !touches(e)) e += block;
            const std::size_t first = std::min(e, part.end);
            while (e < part.end && touches(e)) e += block;
            run_rows(kernels, {first, std::min(e, part.end), part.part},
                     [&](const Kernels& width, std::size_t begin, std::size_t end) {
                         width.fill_records(elements, records.data(), begin, end);
                     });
        }
    });
    for (std::size_t c = contacts.in_slots; c < contacts.size(); ++c) {
        for (const std::size_t e : {std::size_t{contacts.i[c]}, std::size_t{contacts.j[c]}}) {
            fill_records<OneLane>(elements, records.data(), e, e + 1);
        }
    }
}

/// Bonds that broke since the last search: few, and in no order of elements.
void add_late(const state::Contacts& contacts, state::Elements& elements) {
    for (std::size_t c = contacts.in_slots; c < contacts.size(); ++c) {
        const std::size_t i = contacts.i[c];
        const std::size_t j = contacts.j[c];
        const state::PairForce force = contacts.forces.at(c);
        elements.fx[i] += force.f.x;
        elements.fy[i] += force.f.y;
        elements.moment[i] += force.moment_i;
        elements.fx[j] -= force.f.x;
        elements.fy[j] -= force.f.y;
        elements.moment[j] += force.moment_j;
    }
}

} // namespace

ContactRows rows_of(state::Contacts& contacts) {
    state::RollingContacts& rolling = contacts.rolling;
    return {contacts.i.data(),
            contacts.j.data(),
            contacts.materials > 1 ? contacts.rule.data() : nullptr,
            contacts.reference.data(),
            contacts.share_i.data(),
            contacts.Cn.data(),
            contacts.forces.targets(),
            begins_of(contacts.history),
            contacts.friction.sums.data(),
            contacts.damped.sums.data(),
            contacts.slid.empty() ? nullptr : contacts.slid.data(),
            rows_of(contacts.rules),
            rolling.stiffness.data(),
            rolling.dashpot.data(),
            rolling.radius.data(),
            begins_of(rolling.history),
            begins_of(rolling.spent)};
}

PlaceRows rows_of_places(const state::Elements& elements) {
    return {elements.reference_x.data(), elements.reference_y.data(), rows_of(elements)};
}

void contact_forces(state::State& state, Column<double>& records, const Kernels& kernels, Team& team) {
    state::Contacts& contacts = state.contacts;
    fill_records(state, records, kernels, team);
    const ContactRows rows = rows_of(contacts);
    const std::size_t kind = (contacts.rolls ? 1U : 0U) + (state.period.repeats() ? 2U : 0U);
    team.share(contacts.size(), [&](Share part) {
        run_rows(kernels, part, [&](const Kernels& width, std::size_t begin, std::size_t end) {
            width.contact_forces[kind](rows, records.data(), state.period, state.dt, begin, end);
        });
    });
    add_pair_forces(contacts, state.elements, kernels, team);
    add_late(contacts, state.elements);
}

} // namespace demlua::step
