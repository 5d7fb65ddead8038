#include "engine/observe/bond_breaks.hpp"

#include "engine/observe/simulation.hpp"

#include <type_traits>
#include <variant>

namespace demlua::observe {

namespace {

template <class Bonds>
BondBreak break_of(const state::State& state, const Bonds& bonds, std::size_t k) {
    const Index i = bonds.i[k];
    const Index j = bonds.j[k];
    const Vec2 from = state.elements.position(i);
    return {bonds.break_time[k], from + bonds.share_i[k] * state::span_of(bonds, state.elements, k), i, j,
            state.bodies[bonds.body].name};
}

/// Appends the bonds broken in `bonds` but not in `seen`, and brings that up to date.
template <class Bonds>
void collect(const state::State& state, const Bonds& bonds, Column<std::uint8_t>& seen,
             std::vector<BondBreak>& breaks) {
    for (std::size_t k = 0; k < seen.size(); ++k) {
        if (bonds.broken[k] == seen[k]) continue;
        seen[k] = bonds.broken[k];
        breaks.push_back(break_of(state, bonds, k));
    }
}

} // namespace

std::vector<BondBreak> BreakWatch::fresh(const Simulation& simulation) {
    const std::size_t count = simulation.broken_bonds();
    if (begun_ && count == count_) return {};
    count_ = count;
    const state::State& state = simulation.state();
    broken_.resize(state.bond_sets.size());
    std::vector<BondBreak> breaks;
    for (std::size_t set = 0; set < state.bond_sets.size(); ++set) {
        std::visit(
            [&](const auto& bonds) {
                using Law = typename std::decay_t<decltype(bonds)>::law;
                if constexpr (Law::breaks) {
                    if (!begun_) broken_[set] = bonds.broken;
                    collect(state, bonds, broken_[set], breaks);
                }
            },
            state.bond_sets[set]);
    }
    begun_ = true;
    return breaks;
}

} // namespace demlua::observe
