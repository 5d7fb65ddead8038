#include "engine/state/bands.hpp"

#include "engine/bonding/runs.hpp"

#include <algorithm>

namespace demlua::state {

Bands bands_of(const Column<Index>& i, const Column<Index>& j, std::size_t first, std::size_t count) {
    constexpr std::size_t least = 2 * bonding::run_block; // half a megabyte of facets
    std::size_t reach = 0;
    for (std::size_t k = 0; k < i.size(); ++k) reach = std::max(reach, std::size_t{j[k] - i[k]});
    reach = std::max(reach + bonding::run_block, least);

    Bands bands;
    bands.elements = (reach + bonding::run_block - 1) / bonding::run_block * bonding::run_block;
    bands.first_row.assign((count + bands.elements - 1) / bands.elements + 1, 0);
    for (const Index element : i) ++bands.first_row[(element - first) / bands.elements + 1];
    for (std::size_t b = 1; b < bands.first_row.size(); ++b) bands.first_row[b] += bands.first_row[b - 1];
    return bands;
}

} // namespace demlua::state
