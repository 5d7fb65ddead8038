// What a facet leaves behind in its two cells when it breaks: a free wall that gives way to their pressure.
//
//   U(d) = b (2G A/a) d^2/2 + b lam (D + A d)^2/(2 V)       d how far the wall moves out by itself, a its distance
//   least over d:  b lam D^2/(2 (V + (lam/2G) A a))
//
// so the cell grows by (lam/2G) A a, and b lam/V, its pressure per growth g, becomes g/(1 + g A a/(2G b)). Symbols of
// law/facet.hpp; a = share of the bond's length. In a body pulled along a straight crack the pressure beside it is then that of
// the rest of the body. Source: derived above; the energy never rises. Limit: the wall's own motion is along the facet's
// normal, so a flank that zigzags is only met on average.
#pragma once

#include "engine/state/bonds.hpp"

#include <cstddef>

namespace demlua::state {

template <class Law>
void free_wall(FacetSet<Law>& bonds, std::size_t k) {
    const auto soften = [&](Index element, double share) {
        double& per_growth = bonds.pressure_per_growth[element - bonds.slots.first];
        per_growth /= 1.0 + per_growth * bonds.area[k] * share * bonds.length[k] / bonds.twice_shear;
    };
    soften(bonds.i[k], bonds.share_i[k]);
    soften(bonds.j[k], 1.0 - bonds.share_i[k]);
}

} // namespace demlua::state
