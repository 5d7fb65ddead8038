#include "tools/benchmark/cost.hpp"

#include "engine/step/bond_rows.hpp"
#include "engine/step/element_rows.hpp"
#include "tools/benchmark/counting_lane.hpp"

#include <algorithm>
#include <variant>

namespace demlua::bench {

namespace {

constexpr std::size_t most_rows = 16000; // of elements: enough for the count, and quick

/// Of a row of a facet, from step/facet_forces.hpp: bond_motion 60, growth 13, springs and pressures 34, law 21, force 10.
constexpr std::uint64_t facet_operations = 138;
constexpr std::uint64_t facet_divisions = 4;
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
    void count(state::BondSet<Law>& bonds) {
        const auto run = bonds.dashpots.present() ? step::bond_forces<CountingLane, Law, true>
                                                  : step::bond_forces<CountingLane, Law, false>;
        run(step::rows_of(bonds), step::rows_of(elements_), state_.dt, 0, sampled(bonds.size()));
        count_slots(bonds);
    }

    template <class Law>
    void count(state::FacetSet<Law>& bonds) {
        const std::size_t facets = sampled(bonds.size());
        for (std::size_t k = 0; k < facets; ++k) {
            read_row(k, bonds.i, bonds.j, bonds.Dx, bonds.Dy, bonds.length, bonds.inverse_length, bonds.share_i);
            read_row(k, bonds.growth_i, bonds.growth_j, bonds.springs);
            for (const std::size_t e : {std::size_t{bonds.i[k]}, std::size_t{bonds.j[k]}}) {
                read_row(e, elements_.ux, elements_.uy, elements_.rotation);
                write_row(e - bonds.incidence.first, bonds.pressure);
            }
            if constexpr (Law::breaks) {
                read_row(k, bonds.broken, bonds.yielding, bonds.area, bonds.normal, bonds.shear);
                for (const Column<double>& column : bonds.history.columns) read_row(k, column);
                write_row(k, bonds.normal, bonds.shear);
            }
            write_row(k, bonds.motion, bonds.grown_i, bonds.grown_j);
            write_row(k, bonds.fx, bonds.fy, bonds.moment_i, bonds.moment_j);
        }
        count_list(bonds.incidence);
        Tally::operations += facets * facet_operations;
        Tally::divisions += facets * facet_divisions;
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
