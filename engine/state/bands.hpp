// Bonds in bands of elements, for loops that do one thing to a band while it is in near memory after the other.
#pragma once

#include "engine/base/column.hpp"

#include <cstddef>

namespace demlua::state {

/// Band b is the elements from b * elements on, counted from a body's first, and the bonds whose i is one of them, which
/// stand together: rows first_row[b] to first_row[b + 1]. The j of a bond is in the band of its i or in the next; that of the
/// first rows of a band, as many as bonding::run_block elements have, is in the band of its i.
struct Bands {
    std::size_t elements = 1; ///< in each band but the last
    Column<Index> first_row;

    [[nodiscard]] std::size_t size() const { return first_row.empty() ? 0 : first_row.size() - 1; }
};

/// The narrowest bands worth making of bonds (i[k], j[k]), i < j, ordered as bonding::order_in_runs does, over elements
/// `first` to `first + count`.
Bands bands_of(const Column<Index>& i, const Column<Index>& j, std::size_t first, std::size_t count);

} // namespace demlua::state
