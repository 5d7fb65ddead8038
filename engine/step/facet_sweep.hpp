// The two passes over facets, band by band: the second finds in near memory what the first has left there.
#pragma once

#include "engine/step/facet_forces.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace demlua::step {

/// Bands whose first element lies in a share of a body's elements.
struct BandRange {
    std::size_t begin;
    std::size_t end;
};

inline BandRange bands_in(const state::Bands& bands, Share part) {
    const auto at_or_after = [&](std::size_t element) { return (element + bands.elements - 1) / bands.elements; };
    return {at_or_after(part.begin), at_or_after(part.end)};
}

/// Rows of a band, but from one whole run of lane sums to another: measured are some of the next band's with them, pulled
/// some of the band's before.
inline Share rows_ahead(const state::Bands& bands, std::size_t band, Share part) {
    constexpr std::size_t run = state::LaneSums::run;
    const std::size_t last = bands.first_row.back();
    const auto up = [&](std::size_t row) { return std::min((row + run - 1) / run * run, last); };
    return {up(bands.first_row[band]), up(bands.first_row[band + 1]), part.part};
}
inline Share rows_behind(const state::Bands& bands, std::size_t band, Share part) {
    constexpr std::size_t run = state::LaneSums::run;
    const auto down = [&](std::size_t at) {
        const std::size_t row = bands.first_row[at];
        return at + 1 == bands.first_row.size() ? row : row / run * run;
    };
    return {down(band), down(band + 1), part.part};
}

/// Motions, pressures and forces of all facets. A band's cells are complete once the facets of this band and of the one
/// before have been measured; its facets' forces once its own cells and those of the next band are. The bands at the ends
/// of a share wait for their neighbours' shares. Facets that may yield are appended to `failing`, one list for each share.
template <class Law>
void sweep_facets(state::FacetSet<Law>& bonds, const state::Elements& elements, double dt, const Kernels& kernels,
                  Team& team, std::vector<std::vector<Failing<Law>>>& failing) {
    const state::Bands& bands = bonds.bands;
    const std::size_t cells = bonds.pressure.size();
    const auto press = [&](std::size_t band, Share part) {
        const std::size_t first = band * bands.elements;
        press_cells(bonds, kernels, {first, std::min(first + bands.elements, cells), part.part});
    };
    const auto pull = [&](std::size_t band, Share part) {
        facet_forces(bonds, elements, dt, kernels, rows_behind(bands, band, part), failing[part.part]);
    };
    team.share(cells, [&](Share part) {
        const BandRange own = bands_in(bands, part);
        for (std::size_t band = own.begin; band < own.end; ++band) {
            measure_facets(bonds, elements, kernels, rows_ahead(bands, band, part));
            if (band > own.begin) press(band, part);
            if (band > own.begin + 2) pull(band - 1, part);
        }
    });
    team.share(cells, [&](Share part) {
        const BandRange own = bands_in(bands, part);
        if (own.begin < own.end) press(own.begin, part);
    });
    team.share(cells, [&](Share part) {
        const BandRange own = bands_in(bands, part);
        for (std::size_t band = own.begin; band < std::min(own.begin + 2, own.end); ++band) pull(band, part);
        if (own.begin + 2 < own.end) pull(own.end - 1, part);
    });
}

} // namespace demlua::step
