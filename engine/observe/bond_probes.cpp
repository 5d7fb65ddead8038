#include "engine/observe/bond_probes.hpp"

#include "engine/model/setting.hpp"
#include "engine/observe/bond_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace demlua::observe {

namespace {

/// The bond whose middle is nearest to `at`, the first of equals, if it is no farther than its own length.
template <class Bonds>
std::optional<std::size_t> nearest_bond(const Bonds& bonds, const state::Elements& elements, Vec2 at) {
    std::optional<std::size_t> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        const Vec2 middle = elements.position(bonds.i[k]) + 0.5 * state::span_of(bonds, elements, k);
        const double distance = norm(middle - at);
        if (distance < least) {
            least = distance;
            nearest = k;
        }
    }
    return nearest && least <= bonds.length[*nearest] ? nearest : std::nullopt;
}

template <class Bonds>
std::optional<std::size_t> bond_between(const Bonds& bonds, model::IdPair ids) {
    const auto [low, high] = std::minmax(ids[0], ids[1]);
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        if (bonds.i[k] == low && bonds.j[k] == high) return k;
    }
    return std::nullopt;
}

[[noreturn]] void refuse(const model::BondProbe& probe, const char* setting, std::string value, std::string rule) {
    throw SceneError(Problem{probe.place, std::string("bond_probe") + setting, std::move(value), std::move(rule), ""});
}

} // namespace

ProbedBond bond_of(const model::BondProbe& probe, const state::State& state) {
    const std::string& body = state.bodies[probe.body].name;
    for (std::size_t set = 0; set < state.bond_sets.size(); ++set) {
        if (std::visit([](const auto& bonds) { return bonds.body; }, state.bond_sets[set]) != probe.body) continue;
        const auto found = std::visit(
            [&](const auto& bonds) {
                return probe.at ? nearest_bond(bonds, state.elements, *probe.at)
                                : bond_between(bonds, probe.between.value());
            },
            state.bond_sets[set]);
        if (found) return {set, *found};
        if (probe.at) {
            refuse(probe, ".at", fmt::format("{{ {}, {} }}", probe.at->x, probe.at->y),
                   fmt::format("must lie no farther from the middle of a bond of body \"{}\" than that bond is long",
                               body));
        }
        refuse(probe, ".between", model::text_of(*probe.between),
               fmt::format("must be two bonded elements of body \"{}\"", body));
    }
    refuse(probe, ".body", '"' + body + '"', "has no bonds");
}

void add_bond_columns(HistoryRow& row, const std::string& name, const state::State& state, ProbedBond probed) {
    const auto column = [&](const char* what, double value) { row.emplace_back(name + what, value); };
    std::visit(
        [&](const auto& bonds) {
            const BondReading bond = read_bond(bonds, state.elements, probed.bond);
            column("_normal", bond.force.normal);
            column("_shear", bond.force.shear);
            column("_stretch", bond.stretch);
            column("_slide", bond.slide);
            if constexpr (std::decay_t<decltype(bonds)>::law::breaks) {
                column("_cap_normal", bond.caps.normal);
                if (bond.caps.shear != uncapped) column("_cap_shear", bond.caps.shear);
                column("_damage", bond.damage);
                column("_state", bond.state);
            }
        },
        state.bond_sets[probed.set]);
}

} // namespace demlua::observe
