// Fills the table of kernels for one way of reading rows. Included once per width, in files compiled for it.
#pragma once

#include "engine/step/kernels.hpp"

namespace demlua::step {

template <class Lane>
struct KernelTable {
    template <class Law>
    static constexpr PairKernels<Law> of(PairKernels<Law>* /*wanted*/) {
        // Laws that follow rates are written for one row only.
        if constexpr (Lane::width > 1 && law::follows_rate<Law>)
            return {nullptr, nullptr};
        else
            return {bond_forces<Lane, Law, false>, bond_forces<Lane, Law, true>};
    }
    template <class Law>
    static constexpr FacetKernels<Law> of(FacetKernels<Law>* /*wanted*/) {
        if constexpr (Law::wakes)
            return {mark_suspects<Lane, Law>, mark_waking<Lane, Law>};
        else if constexpr (Law::breaks)
            return {mark_suspects<Lane, Law>, nullptr};
        else
            return {nullptr, nullptr};
    }
    template <class... Each>
    static constexpr std::tuple<Each...> all(std::tuple<Each...>* /*wanted*/) {
        return {of(static_cast<Each*>(nullptr))...};
    }
    static constexpr Kernels make() {
        return {Lane::width,
                sum_pairs<Lane>,
                measure_facets<Lane>,
                press_cells<Lane>,
                facet_dashpots<Lane>,
                {facet_forces<Lane, false>, facet_forces<Lane, true>},
                fill_quads<Lane>,
                fill_records<Lane>,
                {contact_forces<Lane, false, false>, contact_forces<Lane, true, false>,
                 contact_forces<Lane, false, true>, contact_forces<Lane, true, true>},
                {move_rows<Lane, false, false>, move_rows<Lane, true, false>, move_rows<Lane, false, true>,
                 move_rows<Lane, true, true>},
                all(static_cast<decltype(Kernels::bonds)*>(nullptr))};
    }
};

} // namespace demlua::step
