#include "engine/state/assemble.hpp"

#include "engine/base/cell_grid.hpp"
#include "engine/model/check_fracture.hpp"
#include "engine/model/derived_law.hpp"
#include "engine/packing/grains.hpp"
#include "engine/packing/packing.hpp"
#include "engine/packing/repeating.hpp"
#include "engine/state/bond_assembly.hpp"
#include "engine/state/cluster_assembly.hpp"
#include "engine/state/edge_pairs.hpp"
#include "engine/state/material_assembly.hpp"
#include "engine/state/parts.hpp"
#include "engine/state/wall_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <type_traits>
#include <utility>

namespace demlua::state {

namespace {

packing::Packing listed(const model::ListedDisks& list) {
    packing::Packing pack;
    for (const model::Disk& disk : list.disks) {
        pack.centre.push_back(disk.centre);
        pack.radius.push_back(disk.radius);
        const std::size_t k = pack.cluster.size();
        pack.cluster.push_back(list.clusters.empty() ? static_cast<Index>(k) : list.clusters[k]);
        pack.cell_area.push_back(std::numbers::pi * disk.radius * disk.radius);
    }
    return pack;
}

template <class Choice>
packing::Packing porous(packing::Packing whole, const Choice& choice) {
    return choice.removed > 0.0 ? packing::thinned(whole, choice.removed, choice.seed) : std::move(whole);
}

/// Where a pack cannot be made, the packing says why and the scene says where.
template <class Pack>
packing::Packing told_where(const model::Body& body, const Pack& pack) {
    try {
        return pack();
    } catch (const RunError& error) {
        throw SceneError(Problem{body.place, "body.packing", '"' + body.name + '"', error.what(), ""});
    }
}

packing::Packing packed(const model::Body& body, Period period, const packing::PackStore* packs) {
    return std::visit(
        [&](const auto& choice) -> packing::Packing {
            using Choice = std::decay_t<decltype(choice)>;
            if constexpr (std::is_same_v<Choice, model::ClosePacking>) {
                return porous(packing::close_packed_across(body.region, choice, period), choice);
            } else if constexpr (std::is_same_v<Choice, model::Consolidation>) {
                return porous(packing::kept(packs, body.region, choice, packing::consolidated), choice);
            } else if constexpr (std::is_same_v<Choice, model::GrainPacking>) {
                return packing::kept(packs, body.region, choice, packing::grains);
            } else if constexpr (std::is_same_v<Choice, model::Relaxation>) {
                return packing::kept(packs, body.region, choice, packing::relaxed);
            } else if constexpr (std::is_same_v<Choice, model::ListedDisks>) {
                return listed(choice);
            } else {
                return {};
            }
        },
        body.packing);
}

/// The cells of a body whose network needs them. What the elements weigh then follows from their cells.
std::optional<packing::Cells> shared_out(const model::Body& body, Period period, packing::Packing& pack) {
    const std::optional<model::Network> network = model::network_of(body);
    if (pack.centre.empty() || (network != model::Network::facets && network != model::Network::delaunay)) return {};
    packing::Cells cells = packing::cells_across(pack.centre, pack.radius, body.region, period);
    for (std::size_t k = 0; k < pack.centre.size(); ++k) {
        if (cells.area[k] > 0.0) continue;
        throw SceneError(Problem{body.place, "body.packing", '"' + body.name + '"',
                                 fmt::format("element {} at ({:.6g}, {:.6g}) m has no cell of its own", k,
                                             pack.centre[k].x, pack.centre[k].y),
                                 "is it hidden by larger ones, or outside the region?"});
    }
    for (const packing::Facet& facet : cells.facets) {
        const double apart = pack.centre[facet.j].x + facet.to_image.x - pack.centre[facet.i].x;
        if (!period.repeats() || std::fabs(apart) < 0.5 * period.length) continue;
        throw SceneError(Problem{
            body.place, "body.packing", '"' + body.name + '"',
            fmt::format("the cells of elements {} and {} meet half a periodic box apart or more", facet.i, facet.j),
            "make the box wider or the elements smaller"});
    }
    pack.cell_area = cells.area;
    return cells;
}

/// Elements held by facets that never break cannot roll, and only their rotations among each other would need the shortest
/// steps: with three times a disk's rotational inertia the step may be longer, and waves long against the
/// elements travel as before.
double inertia_factor(const model::Body& said) {
    const bool never_loose = std::holds_alternative<model::ElasticBonds>(said.bonds);
    return never_loose && model::network_of(said) == model::Network::facets ? 3.0 : 1.0;
}

void place_body(const model::Scene& scene, std::size_t row, const packing::Packing& pack, Index first_cluster,
                State& state) {
    const model::Body& said = scene.bodies[row];
    const double density = scene.materials[said.material].density;
    Elements& elements = state.elements;
    Body body{said.name, said.material, elements.size(), elements.size() + pack.centre.size(), false, said.in_clusters};
    elements.grow(pack.centre.size());
    const double factor = inertia_factor(said);
    for (std::size_t p = 0; p < pack.centre.size(); ++p) {
        const std::size_t k = body.first + p;
        const double R = pack.radius[p];
        const double mass = density * pack.cell_area[p] * scene.thickness;
        elements.reference_x[k] = pack.centre[p].x;
        elements.reference_y[k] = pack.centre[p].y;
        elements.radius[k] = R;
        elements.cell_area[k] = pack.cell_area[p];
        elements.inverse_mass[k] = 1.0 / mass;
        elements.inverse_inertia[k] = 2.0 / (factor * mass * R * R);
        elements.body[k] = static_cast<Index>(row);
        elements.cluster[k] = first_cluster + pack.cluster[p];
    }
    state.bodies.push_back(std::move(body));
}

/// Bodies that lie in one another by more than a pack may overlap its region start with forces nobody asked for.
std::vector<Problem> overlapping_bodies(const model::Scene& scene, const State& state) {
    const Elements& elements = state.elements;
    std::vector<Vec2> points(elements.size());
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = elements.position(k);
    const double largest = *std::max_element(elements.radius.begin(), elements.radius.end());
    CellGrid grid;
    grid.build(points, 2.0 * largest);
    std::vector<std::vector<double>> deepest(state.bodies.size(), std::vector<double>(state.bodies.size(), 0.0));
    grid.for_each_pair(2.0 * largest, [&](Index i, Index j) {
        const std::size_t a = std::min(elements.body[i], elements.body[j]);
        const std::size_t b = std::max(elements.body[i], elements.body[j]);
        if (a == b) return;
        const double touch = elements.radius[i] + elements.radius[j];
        deepest[a][b] = std::max(deepest[a][b], (touch - norm(points[j] - points[i])) / touch);
    });
    std::vector<Problem> problems;
    for (std::size_t a = 0; a < deepest.size(); ++a) {
        for (std::size_t b = a + 1; b < deepest.size(); ++b) {
            if (deepest[a][b] < 0.01) continue;
            problems.push_back({scene.bodies[b].place, "body.region", '"' + scene.bodies[b].name + '"',
                                fmt::format("overlaps body \"{}\" at the start, by {:.0f} % of a diameter",
                                            scene.bodies[a].name, 100.0 * deepest[a][b]),
                                "move one of them apart"});
        }
    }
    return problems;
}

const char* words_for(model::Network network) {
    switch (network) {
    case model::Network::facets:
        return "across facets: E and nu as given";
    case model::Network::unit_cell:
        return "unit cell: E and nu as given inside a close-packed body";
    case model::Network::delaunay:
        return "between neighbouring cells";
    case model::Network::contacts:
    case model::Network::automatic:
        break;
    }
    return "between touching elements";
}

std::string describe(const State& state, std::size_t body, std::optional<model::Network> network,
                     const AnyBondSet* bonds) {
    const Body& facts = state.bodies[body];
    std::string text = fmt::format("{}: {} elements", facts.name, facts.size());
    if (facts.rigid && !facts.in_clusters) return text + ", rigid";
    if (facts.in_clusters) text += fmt::format(" in {} clusters", cluster_count(state, facts));
    if (facts.rigid) return text + ", rigid";
    if (bonds == nullptr) return text + ", loose";
    return std::visit(
        [&](const auto& set) {
            using Law = typename std::decay_t<decltype(set)>::law;
            return fmt::format("{}, {} bonds ({}), coordination {:.2f}, {}", text, set.size(), Law::name,
                               2.0 * static_cast<double>(set.size()) / static_cast<double>(facts.size()),
                               words_for(*network));
        },
        *bonds);
}

/// Mean radius of the elements of a body's bonds, or length of these where facets hold the body: one that a quarter of the bonds
/// stay below, and the greatest, m.
std::pair<double, double> bond_sizes(const AnyBondSet& any, model::Network network) {
    return std::visit(
        [&](const auto& bonds) -> std::pair<double, double> {
            Column<double> size =
                (network == model::Network::facets ? bonds.length : bonds.radius).spread(bonds.size());
            const auto quarter = size.begin() + static_cast<std::ptrdiff_t>(size.size() / 4);
            std::nth_element(size.begin(), quarter, size.end());
            return {*quarter, *std::max_element(quarter, size.end())};
        },
        any);
}

/// A body most of whose bonds cannot run the course of their law is a problem; one that is too coarse in places, as a graded
/// pack may be where nothing is to break, is told of.
void look_at_sizes(const model::Scene& scene, const model::Body& said, model::Network network, const AnyBondSet& bonds,
                   std::vector<Problem>& problems, std::vector<std::string>& notes) {
    const auto [quarter, greatest] = bond_sizes(bonds, network);
    const std::optional<Problem> problem = model::unresolved_bonds(scene, said, network, greatest);
    if (!problem) return;
    if (model::unresolved_bonds(scene, said, network, quarter)) {
        problems.push_back(*problem);
    } else {
        notes.push_back(fmt::format("warning: {} is too coarse to break in places: {} {}; {}", said.name,
                                    problem->value, problem->rule, problem->hint));
    }
}

/// Strain rates averaged over less than a few steps would be those of the shortest vibration.
void look_at_window(const model::Scene& scene, const model::Body& said, const State& state, std::size_t row,
                    std::vector<Problem>& problems) {
    const model::Material& material = scene.materials[said.material];
    std::visit(
        [&](const auto& bonds) {
            using Choice = std::decay_t<decltype(bonds)>;
            if constexpr (model::takes_rates<Choice>) {
                if (!bonds.rate_window) return;
                const double shortest =
                    5.0 * wave_time(state, state.bodies[row], model::plane_moduli_of(material, scene.plane),
                                    material.density);
                if (*bonds.rate_window >= shortest) return;
                problems.push_back({said.place, std::string(model::LawOf<Choice>::name) + ".rate_window",
                                    fmt::format("{} s", *bonds.rate_window),
                                    fmt::format("must be at least {:.6g} s, five times that in which a wave passes "
                                                "one of the elements of body \"{}\"",
                                                shortest, said.name),
                                    ""});
            }
        },
        said.bonds);
}

/// A lattice that is another one period on leaves a seam at the edge.
void look_at_edge(const model::Body& said, Period period, std::vector<std::string>& notes) {
    const auto* lattice = std::get_if<model::ClosePacking>(&said.packing);
    if (lattice == nullptr || !packing::goes_on(said.region, period)) return;
    if (packing::lattice_repeats(*lattice, period)) return;
    notes.push_back(fmt::format("warning: {}: its close packing does not go on across the edges of the periodic box, "
                                "which is {:.6g} diameters wide and would have to be a whole number of {}",
                                said.name, 0.5 * period.length / lattice->radius,
                                lattice->rows == packing::Rows::horizontal ? "them" : "sqrt(3) diameters"));
}

} // namespace

Assembly assemble(const model::Scene& scene, const packing::PackStore* packs) {
    Assembly assembly;
    State& state = assembly.state;
    state.thickness = scene.thickness;
    state.mixed_precision = scene.precision == model::Precision::mixed;
    state.gravity = scene.gravity;
    if (scene.periodic_x) state.period = {scene.periodic_x->x, scene.periodic_x->y - scene.periodic_x->x};
    lay_out_materials(scene, state);

    std::vector<Problem> problems;
    std::vector<std::optional<packing::Cells>> cells;
    Index clusters = 0;
    for (std::size_t row = 0; row < scene.bodies.size(); ++row) {
        const model::Body& said = scene.bodies[row];
        packing::Packing pack = told_where(said, [&] { return packed(said, state.period, packs); });
        cells.push_back(shared_out(said, state.period, pack));
        if (pack.centre.empty()) {
            problems.push_back({said.place, "body.region", '"' + said.name + '"', "is too small for one element",
                                "make the region larger or the elements smaller"});
        }
        place_body(scene, row, pack, clusters, state);
        bring_clusters_together(state.bodies.back(), state);
        if (!pack.cluster.empty()) clusters += *std::max_element(pack.cluster.begin(), pack.cluster.end()) + 1;
    }
    if (!problems.empty()) throw SceneError(std::move(problems));
    if (state.elements.size() == 0) {
        throw SceneError(Problem{scene.place, "simulation", "", "has no body to move", ""});
    }
    problems = overlapping_bodies(scene, state);
    for (Problem& problem : coincident_elements(scene, state)) problems.push_back(std::move(problem));
    for (Problem& problem : overlaps_across_edge(scene, state)) problems.push_back(std::move(problem));
    if (!problems.empty()) throw SceneError(std::move(problems));

    for (std::size_t row = 0; row < scene.bodies.size(); ++row) {
        const model::Body& said = scene.bodies[row];
        set_moving(said, row, state);
        if (said.rigid) make_rigid(said, row, state);
        std::optional<AnyBondSet> bonds;
        const std::optional<model::Network> network = model::network_of(said);
        if (network) {
            const BondedBody body{row, *network, cells[row] ? &*cells[row] : nullptr};
            bonds = bond_body(state, body, said.bonds, scene.materials[said.material], scene.plane);
        }
        if (bonds) {
            look_at_sizes(scene, said, *network, *bonds, problems, assembly.notes);
            look_at_window(scene, said, state, row, problems);
        }
        look_at_edge(said, state.period, assembly.notes);
        assembly.notes.push_back(describe(state, row, network, bonds ? &*bonds : nullptr));
        if (bonds) state.bond_sets.push_back(std::move(*bonds));
    }
    if (!problems.empty()) throw SceneError(std::move(problems));
    lay_out_wear(scene, state);
    if (!scene.domain.bounds().empty()) state.gone.resize(state.elements.size());
    for (std::string& note : separate_parts(state)) assembly.notes.push_back(std::move(note));
    lay_out_walls(scene, state);
    return assembly;
}

} // namespace demlua::state
