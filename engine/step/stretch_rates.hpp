// How fast bonds stretch, averaged over a while, for laws that ask (law/rate_dependent.hpp).
#pragma once

#include "engine/law/rate_dependent.hpp"
#include "engine/step/bond_forces.hpp"

#include <cmath>

namespace demlua::step {

template <class Law>
law::RateParams rate_params(const state::BondSet<Law>& bonds) {
    return bonds.params.rate;
}
template <class Law>
law::RateParams rate_params(const state::FacetSet<Law>& bonds) {
    return bonds.tractions.rate;
}

/// By how much the mean comes nearer to the present rate in a step of `dt` seconds.
template <class Bonds>
double rate_weight(const Bonds& bonds, double dt) {
    return -std::expm1(-dt / rate_params(bonds).window);
}

/// Brings the mean rates of the bonds of one share up to the present instant. Bonds that have yielded keep theirs.
template <class Law>
void mean_rates(state::BondTable<Law>& bonds, const state::Elements& elements, double weight, Share part) {
    using History = typename state::BondTable<Law>::History;
    auto& mean = bonds.history.columns[History::rate_column];
    const auto& factor = bonds.history.columns[History::factor_column];
    for (std::size_t k = part.begin; k < part.end; ++k) {
        if (bonds.is_broken(k) || factor[k] != 0.0) continue;
        const double speed = rates_of(bonds, elements, k, motion_of(bonds, elements, k)).normal;
        mean[k] += weight * (std::fabs(speed) / bonds.length[k] - mean[k]);
    }
}

} // namespace demlua::step
