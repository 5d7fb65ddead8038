// Bonds across the facets of the cells of a pack.
#pragma once

#include "engine/law/facet.hpp"
#include "engine/packing/cells.hpp"

#include <vector>

namespace demlua::bonding {

/// A bond between neighbouring cells as the law sees it.
struct FacetBond {
    double share_i = 0.5; ///< of the bond's length that lies in the cell of i
    law::FacetPart whole; ///< the facet: its length is what carries the bond's traction
    bool walled = false;  ///< ends on a free wall: `springs` and growths are not those of `whole` alone
    law::FacetSprings<double> springs;
    law::FacetVector<double> growth_i; ///< of the cell of i
    law::FacetVector<double> growth_j;
};

struct FacetNetwork {
    std::vector<FacetBond> bonds; ///< one per facet of the cells, in their order
    std::vector<double> volume;   ///< of each cell as its bonds close it, m^2; 0 for a cell that they do not close
};

/// Source: head of law/facet.hpp. `radius` only decides the share of a facet between unequal elements. `thickness` in m.
FacetNetwork facet_network(const packing::Cells& cells, const std::vector<Vec2>& centre,
                           const std::vector<double>& radius, const law::FacetModuli& moduli, double thickness);

} // namespace demlua::bonding
