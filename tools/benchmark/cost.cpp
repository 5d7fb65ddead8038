#include "tools/benchmark/cost.hpp"

#include "engine/step/bond_rows.hpp"
#include "engine/step/element_rows.hpp"
#include "engine/step/facet_forces.hpp"
#include "tools/benchmark/counting_lane.hpp"

#include <algorithm>
#include <variant>

namespace demlua::bench {

namespace {

constexpr std::size_t most_rows = 16000; // of elements: enough for the count, and quick
/// Of a contact that touches, from step/contact_forces.cpp with law/coulomb.hpp.
constexpr std::uint64_t contact_operations = 86;
constexpr std::uint64_t contact_divisions = 4;

template <class... Columns>
void read_row(std::size_t row, const Columns&... columns) {
    (Tally::note_read(columns.data() + row), ...);
}
template <class... Columns>
void write_row(std::size_t row, const Columns&... columns) {
    (Tally::note_written(columns.data() + row), ...);
}

/// One loop after the other over the first rows of a state.
class Counting {
public:
    explicit Counting(state::State& state)
        : state_(state), elements_(state.elements), rows_(std::min(state.elements.size(), most_rows)) {}

    template <class Law>
    void count(state::BondSet<law::RateDependent<Law>>& /*bonds*/) {}

    template <class Law>
    void count(state::BondSet<Law>& bonds) {
        const auto run = bonds.dashpots.present() ? step::bond_forces<CountingLane, Law, true>
                                                  : step::bond_forces<CountingLane, Law, false>;
        run(step::rows_of(bonds), step::rows_of(elements_), state_.dt, 0, sampled(bonds.size()));
        count_slots(bonds);
    }

    template <class Law>
    void count(state::FacetSet<Law>& bonds) {
        const std::size_t facets = sampled(bonds.size());
        const step::FacetRows rows = step::rows_of(bonds);
        const step::ElementRows moving = step::rows_of(elements_);
        step::measure_facets<CountingLane>(rows, moving, 0, facets);
        step::press_cells<CountingLane>(step::cells_of(bonds), 0, std::min(rows_, bonds.slots.elements));
        if (bonds.dashpots.present()) {
            step::facet_dashpots<CountingLane>(rows, moving, state_.dt, 0, facets);
            step::facet_forces<CountingLane, true>(rows, moving, 0, facets);
        } else {
            step::facet_forces<CountingLane, false>(rows, moving, 0, facets);
        }
        if constexpr (Law::breaks) step::mark_suspects<CountingLane, Law>(step::suspects_of(bonds), 0, facets);
        if constexpr (Law::wakes) step::mark_waking<CountingLane, Law>(step::suspects_of(bonds), 0, facets);
        count_slots(bonds);
    }

    void count(const state::Contacts& contacts) {
        const std::size_t pairs = sampled(contacts.size());
        for (std::size_t c = 0; c < pairs; ++c) {
            read_row(c, contacts.i, contacts.j, contacts.reference);
            for (const Column<double>& column : contacts.history.columns) read_row(c, column);
            for (const std::size_t e : {std::size_t{contacts.i[c]}, std::size_t{contacts.j[c]}}) {
                read_row(e, elements_.ux, elements_.uy, elements_.reference_x, elements_.reference_y);
                if (contacts.overlap[c] <= 0.0) continue;
                read_row(e, elements_.vx, elements_.vy, elements_.spin, elements_.radius);
            }
            write_row(c, contacts.overlap, contacts.fx, contacts.fy, contacts.moment_i, contacts.moment_j);
            if (contacts.overlap[c] <= 0.0) continue;
            read_row(c, contacts.rule, contacts.Cn, contacts.Ct);
            for (const Column<double>& column : contacts.history.columns) write_row(c, column);
            Tally::operations += contact_operations;
            Tally::divisions += contact_divisions;
        }
        if (pairs > 0) count_list(contacts.incidence);
    }

    void count_motion() {
        const step::MotionRows rows{elements_.ux.data(),
                                    elements_.uy.data(),
                                    elements_.rotation.data(),
                                    elements_.vx.data(),
                                    elements_.vy.data(),
                                    elements_.spin.data(),
                                    elements_.fx.data(),
                                    elements_.fy.data(),
                                    elements_.moment.data(),
                                    elements_.inverse_mass.data(),
                                    elements_.inverse_inertia.data(),
                                    nullptr};
        step::MotionTerms terms;
        terms.dt = terms.gain = state_.dt;
        const auto move = state_.gravity == Vec2{} ? step::move_rows<CountingLane, false, false>
                                                   : step::move_rows<CountingLane, false, true>;
        move(rows, terms, 0, rows_);
    }

    [[nodiscard]] Cost whole() const {
        const auto per_element = [this](std::uint64_t count) {
            return static_cast<double>(count) / static_cast<double>(rows_);
        };
        std::unordered_set<std::uintptr_t> touched = Tally::read;
        touched.insert(Tally::written.begin(), Tally::written.end());
        return {per_element(Tally::line * (Tally::read.size() + Tally::written.size())),
                per_element(Tally::line * touched.size()), per_element(Tally::operations),
                per_element(Tally::divisions)};
    }

private:
    /// As many rows of pairs as the elements looked at have on the average.
    [[nodiscard]] std::size_t sampled(std::size_t pairs) const { return pairs * rows_ / elements_.size(); }

    void count_list(const state::Incidence& incidence) const {
        const std::size_t elements = std::min(rows_, incidence.start.size() - 1);
        for (std::size_t e = 0; e < elements; ++e) read_row(e, incidence.start);
        for (std::size_t entry = incidence.start[0]; entry < incidence.start[elements]; ++entry) {
            read_row(entry, incidence.end);
        }
    }

    template <class Law>
    void count_slots(state::BondTable<Law>& bonds) {
        const state::PairSlots& slots = bonds.slots;
        const step::PairSums sums{bonds.fx.data(),
                                  bonds.fy.data(),
                                  bonds.moment_i.data(),
                                  bonds.moment_j.data(),
                                  slots.start.data(),
                                  slots.row.data(),
                                  elements_.fx.data() + slots.first,
                                  elements_.fy.data() + slots.first,
                                  elements_.moment.data() + slots.first};
        step::sum_pairs<CountingLane>(sums, 0, std::min(slots.elements, rows_));
    }

    state::State& state_;
    state::Elements& elements_;
    std::size_t rows_;
};

} // namespace

Cost cost_of(state::State& state) {
    Counting counting(state);
    counting.count_motion();
    for (state::AnyBondSet& any : state.bond_sets) {
        std::visit([&](auto& bonds) { counting.count(bonds); }, any);
    }
    counting.count(state.contacts);
    return counting.whole();
}

} // namespace demlua::bench
