#include "tools/benchmark/cost.hpp"

#include "engine/step/bond_rows.hpp"
#include "engine/step/contact_forces.hpp"
#include "engine/step/element_rows.hpp"
#include "engine/step/facet_forces.hpp"
#include "engine/step/pair_sums.hpp"
#include "tools/benchmark/counting_lane.hpp"

#include <algorithm>
#include <variant>

namespace demlua::bench {

namespace {

constexpr std::size_t most_rows = 16000; // of elements: enough for the count, and quick

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
        count_quads(bonds);
        run(step::rows_of(bonds), step::rows_of(elements_, bonds), state_.dt, 0, sampled(bonds.size()));
        count_slots(bonds);
    }

    template <class Law>
    void count(state::FacetSet<Law>& bonds) {
        const std::size_t facets = sampled(bonds.size());
        const step::FacetRows rows = step::rows_of(bonds);
        const step::ElementRows moving = step::rows_of(elements_, bonds);
        count_quads(bonds);
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

    void count(state::Contacts& contacts) {
        if (contacts.size() == 0) return;
        const auto run = contacts.rolls ? step::contact_forces<CountingLane, true, false>
                                        : step::contact_forces<CountingLane, false, false>;
        Column<double> records(step::record::width * elements_.size());
        step::fill_records<CountingLane>(step::rows_of_places(elements_), records.data(), 0, rows_);
        run(step::rows_of(contacts), records.data(), state_.period, state_.dt, 0, sampled(contacts.size()));
        count_slots(contacts);
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

    template <class Bonds>
    void count_quads(Bonds& bonds) {
        step::for_each_quads(bonds, elements_, [&](const auto& columns, double* quads) {
            step::fill_quads<CountingLane>(columns, quads, 0, std::min(rows_, bonds.slots.elements));
        });
    }

    template <class Pairs>
    void count_slots(const Pairs& bonds) {
        const state::PairSlots& slots = bonds.slots;
        const step::PairSums sums{bonds.forces.rows(),
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
