#include "engine/state/bond_assembly.hpp"

#include "engine/bonding/bonding.hpp"
#include "engine/model/derived_law.hpp"
#include "engine/state/facet_assembly.hpp"
#include "engine/state/free_wall.hpp"

#include "engine/bonding/runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace demlua::state {

namespace {

struct Disks {
    std::vector<Vec2> centre;
    std::vector<double> radius;
};

Disks disks_of(const State& state, const Body& body) {
    Disks disks;
    for (std::size_t k = body.first; k < body.last; ++k) {
        disks.centre.push_back(state.elements.position(k));
        disks.radius.push_back(state.elements.radius[k]);
    }
    return disks;
}

std::vector<bonding::Pair> neighbours(const packing::Cells& cells) {
    std::vector<bonding::Pair> pairs;
    for (const packing::Facet& facet : cells.facets) pairs.emplace_back(facet.i, facet.j);
    return pairs;
}

template <class Row>
std::vector<Row> ordered_in_runs(const std::vector<Row>& rows, const std::vector<bonding::Pair>& pairs,
                                 const Disks& disks) {
    std::vector<Row> ordered;
    ordered.reserve(rows.size());
    for (const std::size_t row : bonding::order_in_runs(pairs, disks.centre)) ordered.push_back(rows[row]);
    return ordered;
}

/// Whether most bonds are of the elements that follow those of the bond before.
template <class Law>
bool in_runs(const BondTable<Law>& bonds) {
    std::size_t follow = 0;
    for (std::size_t k = 1; k < bonds.size(); ++k) {
        if (bonds.i[k] == bonds.i[k - 1] + 1 && bonds.j[k] == bonds.j[k - 1] + 1) ++follow;
    }
    return 2 * follow > bonds.size();
}

/// Everything about the pairs but what holds them.
template <class Law>
void lay_out(BondTable<Law>& bonds, const State& state, const std::vector<bonding::Pair>& pairs) {
    const Elements& elements = state.elements;
    const Body& body = state.bodies[bonds.body];
    for (Column<Index>* column : {&bonds.i, &bonds.j}) column->reserve(pairs.size());
    for (NumberColumn* column :
         {&bonds.Dx, &bonds.Dy, &bonds.length, &bonds.inverse_length, &bonds.share_i, &bonds.radius}) {
        column->reserve(pairs.size());
    }
    for (const auto& [a, b] : pairs) {
        const std::size_t i = body.first + a;
        const std::size_t j = body.first + b;
        const Vec2 D = state.between(i, j);
        bonds.i.push_back(static_cast<Index>(i));
        bonds.j.push_back(static_cast<Index>(j));
        bonds.Dx.push_back(D.x);
        bonds.Dy.push_back(D.y);
        bonds.length.push_back(norm(D));
        bonds.inverse_length.push_back(1.0 / norm(D));
        bonds.share_i.push_back(elements.radius[i] / (elements.radius[i] + elements.radius[j]));
        bonds.radius.push_back(0.5 * (elements.radius[i] + elements.radius[j]));
    }
    bonds.history.resize(pairs.size());
    if (in_runs(bonds)) {
        bonds.forces.lay_out_columns(pairs.size() + 1);
    } else {
        bonds.forces.lay_out_quads(pairs.size() + 1);
        bonds.moved.resize(4 * body.size());
    }
    if constexpr (Law::breaks) bonds.broken.resize(pairs.size());
    bonds.slots = slots_of(bonds.i, bonds.j, body.first, body.size());
}

/// What is as large in every bond but for rounding in the places of elements takes one number; those may stand a thousand
/// bonds and more from the origin.
constexpr double rounding = 1e-11;

/// Adds dashpots, or to those there are: `extra(k)` gives {N s/m, N s/m} for the bond k.
template <class Law, class Extra>
void raise_dashpots(BondTable<Law>& bonds, const Extra& extra) {
    BondDashpots& dashpots = bonds.dashpots;
    NumberColumn Cn;
    NumberColumn Ct;
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        const law::ContactStiffness more = extra(k);
        Cn.push_back((dashpots.present() ? dashpots.Cn[k] : 0.0) + more.normal);
        Ct.push_back((dashpots.present() ? dashpots.Ct[k] : 0.0) + more.shear);
    }
    Cn.even_out(rounding);
    Ct.even_out(rounding);
    dashpots.Cn = std::move(Cn);
    dashpots.Ct = std::move(Ct);
    dashpots.normal.resize(bonds.size());
    dashpots.shear.resize(bonds.size());
    dashpots.spent.cover(bonds.size());
    bonds.speeds.resize(bonds.moved.size());
}

template <class Law>
law::ContactStiffness stiffness_of(const BondSet<Law>& bonds, std::size_t /*k*/) {
    return {bonds.params.Kn, bonds.params.Kt};
}

/// Of a facet whose neighbours stand still.
template <class Law>
law::ContactStiffness stiffness_of(const FacetSet<Law>& bonds, std::size_t k) {
    const double at_i = bonds.pressure_per_growth[bonds.i[k] - bonds.slots.first];
    const double at_j = bonds.pressure_per_growth[bonds.j[k] - bonds.slots.first];
    const law::FacetVector<double>& g_i = bonds.growth_i[k];
    const law::FacetVector<double>& g_j = bonds.growth_j[k];
    return {bonds.springs[k].nn + at_i * g_i.normal * g_i.normal + at_j * g_j.normal * g_j.normal,
            bonds.springs[k].tt + at_i * g_i.shear * g_i.shear + at_j * g_j.shear * g_j.shear};
}

/// Dashpots at a fraction of the critical damping 2 sqrt(K m) of each bond, m the reduced mass of its elements.
template <class Bonds>
void add_dashpots(Bonds& bonds, const Elements& elements, double fraction) {
    raise_dashpots(bonds, [&](std::size_t k) -> law::ContactStiffness {
        const double m = 1.0 / (elements.inverse_mass[bonds.i[k]] + elements.inverse_mass[bonds.j[k]]);
        const law::ContactStiffness spring = stiffness_of(bonds, k);
        return {2.0 * fraction * std::sqrt(spring.normal * m), 2.0 * fraction * std::sqrt(spring.shear * m)};
    });
}

template <class Law>
void free_wall(BondSet<Law>& /*bonds*/, std::size_t /*k*/) {}

template <class Law>
void leave_cells(BondSet<Law>& /*bonds*/, std::size_t /*k*/) {}
template <class Law>
void leave_cells(FacetSet<Law>& bonds, std::size_t k) {
    bonds.grown_i.set(k, 0.0);
    bonds.grown_j.set(k, 0.0);
}

template <class Law>
FacetSet<Law> facets_of(const State& state, const BondedBody& said, double damping, const law::FacetModuli& moduli,
                        const typename Law::Tractions& tractions) {
    const Body& body = state.bodies[said.body];
    const Disks disks = disks_of(state, body);
    packing::Cells cells = *said.cells;
    cells.facets = ordered_in_runs(cells.facets, neighbours(cells), disks);
    const bonding::FacetNetwork network =
        bonding::facet_network(cells, disks.centre, disks.radius, moduli, state.thickness);
    FacetSet<Law> bonds;
    bonds.tractions = tractions;
    bonds.body = said.body;
    lay_out(bonds, state, neighbours(cells));
    fill_facets(bonds, network, moduli, state.thickness, state.mixed_precision);
    if (damping > 0.0) add_dashpots(bonds, state.elements, damping);
    return bonds;
}

/// In a close packing all bonds are as long.
template <class Law>
void even_out(BondSet<Law>& bonds) {
    for (NumberColumn* column : {&bonds.length, &bonds.inverse_length, &bonds.share_i, &bonds.radius}) {
        column->even_out(rounding);
    }
    if (bonds.share_i.even() && bonds.share_i[0] == 0.5) bonds.forces.share_moments();
}

template <class Law>
BondSet<Law> pairs_of(const State& state, const BondedBody& said, double damping,
                      const std::vector<bonding::Pair>& pairs, const typename Law::Params& params) {
    BondSet<Law> bonds;
    bonds.params = params;
    bonds.body = said.body;
    lay_out(bonds, state, pairs);
    even_out(bonds);
    if (state.mixed_precision) bonds.keep_single();
    if (damping > 0.0) add_dashpots(bonds, state.elements, damping);
    return bonds;
}

void keep_within_clusters(const State& state, const Body& body, std::vector<bonding::Pair>& pairs) {
    const Column<Index>& cluster = state.elements.cluster;
    std::erase_if(pairs, [&](const bonding::Pair& pair) {
        return cluster[body.first + pair.first] != cluster[body.first + pair.second];
    });
}

template <class Choice, class Law>
AnyBondSet bonds_of(const State& state, const BondedBody& said, const Choice& choice, law::PlaneModuli moduli,
                    const model::DerivedLaw<Law>& law) {
    if (said.network == model::Network::facets) {
        return facets_of<Law>(state, said, choice.damping, law::facet_moduli(moduli), law.tractions);
    }
    if constexpr (Choice::facets_only) {
        throw std::logic_error("this bond law is for facets alone");
    } else {
        const Disks disks = disks_of(state, state.bodies[said.body]);
        std::vector<bonding::Pair> pairs =
            said.network == model::Network::delaunay
                ? neighbours(*said.cells)
                : bonding::pairs_within(disks.centre, disks.radius, choice.search, state.period);
        if (state.bodies[said.body].in_clusters) keep_within_clusters(state, state.bodies[said.body], pairs);
        return pairs_of<Law>(state, said, choice.damping, ordered_in_runs(pairs, pairs, disks), law.params);
    }
}

/// With the strain-rate factors that the choice asks for.
template <class Choice>
AnyBondSet under_rates(const State& state, const BondedBody& said, const Choice& choice,
                       const model::Material& material, const model::Matter& matter) {
    const auto plain = derived(choice, matter);
    if constexpr (model::takes_rates<Choice>) {
        if (choice.rate_compressive_strength) {
            const double wave = wave_time(state, state.bodies[said.body], matter.moduli, material.density);
            const law::RateParams rate{law::rate_exponent(*choice.rate_compressive_strength),
                                       choice.rate_window.value_or(10.0 * wave)};
            return bonds_of(state, said, choice, matter.moduli, model::rate_dependent(plain, rate));
        }
    }
    return bonds_of(state, said, choice, matter.moduli, plain);
}

} // namespace

double wave_time(const State& state, const Body& body, law::PlaneModuli moduli, double density) {
    double radii = 0.0;
    for (std::size_t k = body.first; k < body.last; ++k) radii += state.elements.radius[k];
    return 2.0 * radii / static_cast<double>(body.size()) * std::sqrt(density / moduli.youngs_modulus);
}

std::optional<AnyBondSet> bond_body(const State& state, const BondedBody& said, const model::BondChoice& choice,
                                    const model::Material& material, model::Plane plane) {
    const model::Matter matter = model::matter_of(material, plane, state.thickness);
    return std::visit(
        [&](const auto& bonds) -> std::optional<AnyBondSet> {
            if constexpr (std::is_same_v<std::decay_t<decltype(bonds)>, model::NoBonds>) {
                return std::nullopt;
            } else {
                AnyBondSet set = under_rates(state, said, bonds, material, matter);
                const bool empty = std::visit([](const auto& made) { return made.size() == 0; }, set);
                return empty ? std::nullopt : std::optional<AnyBondSet>(std::move(set));
            }
        },
        choice);
}

void add_stiffness_damping(AnyBondSet& any, double beta) {
    std::visit(
        [&](auto& bonds) {
            raise_dashpots(bonds, [&](std::size_t k) -> law::ContactStiffness {
                const law::ContactStiffness spring = stiffness_of(bonds, k);
                return {beta * spring.normal, beta * spring.shear};
            });
        },
        any);
}

std::size_t cut(State& state, std::size_t body, Vec2 from, Vec2 to) {
    std::size_t count = 0;
    for (AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](auto& bonds) {
                using Law = typename std::decay_t<decltype(bonds)>::law;
                if (bonds.body != body) return;
                if constexpr (Law::breaks) {
                    for (std::size_t k = 0; k < bonds.size(); ++k) {
                        const Vec2 a = state.elements.position(bonds.i[k]);
                        const Vec2 span = span_of(bonds, state.elements, k);
                        if (bonds.broken[k] != 0 || !bonding::cut_crosses(from, to, a, a + span)) continue;
                        const double touch = state.elements.radius[bonds.i[k]] + state.elements.radius[bonds.j[k]];
                        Crack crack = crack_of(bonds, state.elements, k, state.time, state.step);
                        crack.mode = CrackMode::notch;
                        state.cracks.push_back(crack);
                        free_wall(bonds, k);
                        leave_cells(bonds, k);
                        bonds.note_break(k, std::numeric_limits<double>::infinity(), std::min(norm(span), touch));
                        ++count;
                    }
                }
            },
            any);
    }
    return count;
}

} // namespace demlua::state
