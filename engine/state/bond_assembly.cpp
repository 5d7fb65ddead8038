#include "engine/state/bond_assembly.hpp"

#include "engine/bonding/bonding.hpp"
#include "engine/state/incidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace demlua::state {

namespace {

std::vector<bonding::Pair> near_pairs(const State& state, const Body& body, double search) {
    std::vector<Vec2> centre;
    std::vector<double> radius;
    for (std::size_t k = body.first; k < body.last; ++k) {
        centre.push_back(state.elements.position(k));
        radius.push_back(state.elements.radius[k]);
    }
    return bonding::pairs_within(centre, radius, search);
}

template <class Law>
void lay_out(BondSet<Law>& bonds, const State& state, const std::vector<bonding::Pair>& pairs) {
    const Elements& elements = state.elements;
    const Body& body = state.bodies[bonds.body];
    for (const auto& [a, b] : pairs) {
        const std::size_t i = body.first + a;
        const std::size_t j = body.first + b;
        const Vec2 D = elements.position(j) - elements.position(i);
        bonds.i.push_back(static_cast<Index>(i));
        bonds.j.push_back(static_cast<Index>(j));
        bonds.Dx.push_back(D.x);
        bonds.Dy.push_back(D.y);
        bonds.length.push_back(norm(D));
        bonds.share_i.push_back(elements.radius[i] / (elements.radius[i] + elements.radius[j]));
        bonds.radius.push_back(0.5 * (elements.radius[i] + elements.radius[j]));
    }
    bonds.history.resize(pairs.size());
    for (Column<double>* column : {&bonds.fx, &bonds.fy, &bonds.moment_i, &bonds.moment_j}) {
        column->resize(pairs.size());
    }
    if constexpr (Law::breaks) {
        bonds.broken.resize(pairs.size());
        bonds.contact_length.resize(pairs.size());
        bonds.break_time.assign(pairs.size(), std::numeric_limits<double>::infinity());
    }
    bonds.incidence = incidence_of(bonds.i, bonds.j, body.first, body.size());
}

void grow_dashpots(BondDashpots& dashpots, std::size_t rows) {
    for (Column<double>* column : {&dashpots.Cn, &dashpots.Ct, &dashpots.normal, &dashpots.shear, &dashpots.spent}) {
        column->resize(rows);
    }
}

/// Dashpots at a fraction of the critical damping 2 sqrt(K m) of each bond, m the reduced mass of its elements.
template <class Law>
void add_dashpots(BondSet<Law>& bonds, const Elements& elements, double fraction) {
    grow_dashpots(bonds.dashpots, bonds.size());
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        const double m = 1.0 / (elements.inverse_mass[bonds.i[k]] + elements.inverse_mass[bonds.j[k]]);
        bonds.dashpots.Cn[k] += 2.0 * fraction * std::sqrt(bonds.params.Kn * m);
        bonds.dashpots.Ct[k] += 2.0 * fraction * std::sqrt(bonds.params.Kt * m);
    }
}

template <class Law>
std::optional<AnyBondSet> bonds_of(const State& state, std::size_t body, double search, double damping,
                                   const typename Law::Params& params) {
    const std::vector<bonding::Pair> pairs = near_pairs(state, state.bodies[body], search);
    if (pairs.empty()) return std::nullopt;
    BondSet<Law> bonds;
    bonds.params = params;
    bonds.body = body;
    lay_out(bonds, state, pairs);
    if (damping > 0.0) add_dashpots(bonds, state.elements, damping);
    return bonds;
}

} // namespace

std::optional<AnyBondSet> bond_body(const State& state, std::size_t body, const model::BondChoice& choice,
                                    const model::Material& material, model::Plane plane) {
    const law::PlaneModuli moduli =
        law::plane_moduli(material.youngs_modulus, material.poissons_ratio, plane == model::Plane::strain);
    const law::ContactStiffness k = law::contact_stiffness(moduli, state.thickness);
    return std::visit(
        [&](const auto& bonds) -> std::optional<AnyBondSet> {
            using Choice = std::decay_t<decltype(bonds)>;
            if constexpr (std::is_same_v<Choice, model::ElasticBonds>) {
                return bonds_of<law::Elastic>(state, body, bonds.search, bonds.damping, law::Elastic::derive(k));
            } else if constexpr (std::is_same_v<Choice, model::PlateauBonds>) {
                const law::Plateau::Params params = law::Plateau::derive(
                    k, moduli, state.thickness, material.tensile_strength.value(), material.fracture_toughness.value(),
                    material.rate_factor, bonds.break_in_shear);
                return bonds_of<law::Plateau>(state, body, bonds.search, bonds.damping, params);
            } else {
                return std::nullopt;
            }
        },
        choice);
}

void add_stiffness_damping(AnyBondSet& any, double beta) {
    std::visit(
        [&](auto& bonds) {
            if (!bonds.dashpots.present()) grow_dashpots(bonds.dashpots, bonds.size());
            for (std::size_t k = 0; k < bonds.size(); ++k) {
                bonds.dashpots.Cn[k] += beta * bonds.params.Kn;
                bonds.dashpots.Ct[k] += beta * bonds.params.Kt;
            }
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
                        const Vec2 b = state.elements.position(bonds.j[k]);
                        if (bonds.broken[k] != 0 || !bonding::cut_crosses(from, to, a, b)) continue;
                        const double touch = state.elements.radius[bonds.i[k]] + state.elements.radius[bonds.j[k]];
                        bonds.broken[k] = 1;
                        bonds.contact_length[k] = std::min(bonds.length[k], touch);
                        ++bonds.broken_count;
                        ++count;
                    }
                }
            },
            any);
    }
    return count;
}

} // namespace demlua::state
