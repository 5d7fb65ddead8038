#include "engine/observe/cracks.hpp"

#include <algorithm>

namespace demlua::observe {

namespace {

/// Length of crack that one broken bond stands for, m.
template <class Law>
double crack_across(const state::BondSet<Law>& bonds, std::size_t k) {
    return 2.0 * bonds.radius[k];
}

template <class Law>
double crack_across(const state::FacetSet<Law>& bonds, std::size_t k) {
    return bonds.area[k];
}

template <class Sum, class Of>
Sum over_bond_sets(const state::State& state, const Of& of) {
    Sum sum{};
    for (const state::AnyBondSet& any : state.bond_sets) {
        sum += std::visit([&](const auto& bonds) -> Sum { return of(bonds); }, any);
    }
    return sum;
}

} // namespace

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
            if (bonds.is_broken(k)) length += crack_across(bonds, k);
        }
        return length;
    });
}

std::size_t fragment_count(const std::vector<std::int32_t>& fragment) {
    return fragment.empty() ? 0 : static_cast<std::size_t>(*std::max_element(fragment.begin(), fragment.end())) + 1;
}

} // namespace demlua::observe
