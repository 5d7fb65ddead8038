#include "engine/observe/cracks.hpp"

#include "engine/base/cell_grid.hpp"
#include "engine/base/disjoint_sets.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace demlua::observe {

namespace {

template <class Sum, class Of>
Sum over_bond_sets(const state::State& state, const Of& of) {
    Sum sum{};
    for (const state::AnyBondSet& any : state.bond_sets) {
        sum += std::visit([&](const auto& bonds) -> Sum { return of(bonds); }, any);
    }
    return sum;
}

using Rows = std::vector<std::size_t>;

/// Joins the cracks `rows`, of this set of bonds, that share an element.
template <class Law>
void join_cracks(const state::State& state, const state::BondSet<Law>& bonds, const Rows& rows, DisjointSets& joined) {
    const state::Body& body = state.bodies[bonds.body];
    constexpr auto none = static_cast<std::size_t>(-1);
    Rows first_at(body.size(), none);
    for (const std::size_t row : rows) {
        for (const std::size_t element : {state.cracks[row].i, state.cracks[row].j}) {
            std::size_t& first = first_at[element - body.first];
            if (first == none) first = row;
            joined.join(first, row);
        }
    }
}

/// `point`, or where the plane repeats its image inside, and if that lies within `reach` of the left edge the next one too.
std::vector<Vec2> images_near_edge(Vec2 point, Period period, double reach) {
    if (!period.repeats()) return {point};
    point.x += period.shift_inside(point.x);
    if (point.x - period.left > reach) return {point};
    return {point, point + Vec2{period.length, 0.0}};
}

/// The same for those whose facets shared an end where they were bonded.
template <class Law>
void join_cracks(const state::State& state, const state::FacetSet<Law>& bonds, const Rows& rows, DisjointSets& joined) {
    constexpr double coincident = 1e-6; // in radii; facets shorter than 1e-9 are left out of cells
    const state::Elements& elements = state.elements;
    std::vector<Vec2> ends;
    Rows row_of_end;
    double least_radius = bonds.radius[state.cracks[rows.front()].bond];
    for (const std::size_t row : rows) least_radius = std::min(least_radius, bonds.radius[state.cracks[row].bond]);
    for (const std::size_t row : rows) {
        const Index k = state.cracks[row].bond;
        const Vec2 stood{elements.reference_x[bonds.i[k]], elements.reference_y[bonds.i[k]]};
        for (const Vec2 end : state::crack_across(bonds, k, stood, {bonds.Dx[k], bonds.Dy[k]})) {
            for (const Vec2 image : images_near_edge(end, state.period, least_radius)) {
                ends.push_back(image);
                row_of_end.push_back(row);
            }
        }
    }
    CellGrid grid;
    grid.build(ends, least_radius);
    grid.for_each_pair(coincident * least_radius, [&](Index a, Index b) { joined.join(row_of_end[a], row_of_end[b]); });
}

/// Columns of the cracks while they are being filled.
struct CrackColumns {
    std::vector<double> time, step, energy;
    std::vector<std::int32_t> mode, i, j;

    void add(const state::Crack& crack) {
        time.push_back(crack.time);
        step.push_back(static_cast<double>(crack.step));
        energy.push_back(crack.energy);
        mode.push_back(static_cast<std::int32_t>(crack.mode));
        i.push_back(static_cast<std::int32_t>(crack.i));
        j.push_back(static_cast<std::int32_t>(crack.j));
    }
};

} // namespace

bool can_break(const state::State& state) {
    return std::any_of(state.bond_sets.begin(), state.bond_sets.end(), [](const state::AnyBondSet& any) {
        return std::visit([](const auto& bonds) { return std::decay_t<decltype(bonds)>::law::breaks; }, any);
    });
}

std::size_t bond_count(const state::State& state) {
    return over_bond_sets<std::size_t>(state, [](const auto& bonds) { return bonds.size(); });
}

std::size_t broken_bond_count(const state::State& state) {
    return over_bond_sets<std::size_t>(state, [](const auto& bonds) { return bonds.broken_count; });
}

double crack_length_of(const state::State& state) {
    return over_bond_sets<double>(state, [](const auto& bonds) {
        double length = 0.0;
        for (std::size_t k = 0; k < bonds.size(); ++k) {
            if (bonds.is_broken(k)) length += state::crack_part(bonds, k).area;
        }
        return length;
    });
}

double surface_energy_of(const state::State& state) {
    double sum = 0.0;
    for (const state::Crack& crack : state.cracks) sum += crack.energy;
    return sum;
}

std::vector<std::int32_t> crack_clusters(const state::State& state) {
    std::vector<Rows> of_body(state.bodies.size());
    for (std::size_t row = 0; row < state.cracks.size(); ++row) of_body[state.cracks[row].body].push_back(row);
    DisjointSets joined(state.cracks.size());
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                const Rows& rows = of_body[bonds.body];
                if (!rows.empty()) join_cracks(state, bonds, rows, joined);
            },
            any);
    }
    std::vector<std::int32_t> clusters;
    for (std::size_t row = 0; row < state.cracks.size(); ++row) {
        clusters.push_back(static_cast<std::int32_t>(joined.root(row)));
    }
    return clusters;
}

void add_cracks_to(Snapshot& snapshot, const state::State& state) {
    if (!can_break(state)) return;
    CrackColumns columns;
    for (const state::Crack& crack : state.cracks) {
        snapshot.crack_ends.push_back(crack.ends);
        columns.add(crack);
    }
    snapshot.crack_fields.push_back({"time", "s", 1, std::move(columns.time)});
    snapshot.crack_fields.push_back({"step", "", 1, std::move(columns.step)});
    snapshot.crack_fields.push_back({"mode", "", 1, std::move(columns.mode)});
    snapshot.crack_fields.push_back({"energy", "J", 1, std::move(columns.energy)});
    snapshot.crack_fields.push_back({"i", "", 1, std::move(columns.i)});
    snapshot.crack_fields.push_back({"j", "", 1, std::move(columns.j)});
    snapshot.crack_fields.push_back({"cluster", "", 1, crack_clusters(state)});
}

std::size_t fragment_count(const std::vector<std::int32_t>& fragment) {
    return fragment.empty() ? 0 : static_cast<std::size_t>(*std::max_element(fragment.begin(), fragment.end())) + 1;
}

} // namespace demlua::observe
