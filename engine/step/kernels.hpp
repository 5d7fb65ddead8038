// The loops of a step for as many rows at a time as the machine's registers hold.
#pragma once

#include "engine/base/team.hpp"
#include "engine/law/laws.hpp"
#include "engine/step/bond_rows.hpp"
#include "engine/step/contact_rows.hpp"
#include "engine/step/element_rows.hpp"
#include "engine/step/facet_rows.hpp"

#include <array>
#include <cstddef>
#include <tuple>

namespace demlua::step {

/// Null where the law has none of this width.
template <class Law>
struct PairKernels {
    BondKernel<Law> plain;
    BondKernel<Law> damped;
};

/// Null where the law breaks nothing, or where its facets are never dormant.
template <class Law>
struct FacetKernels {
    SuspectKernel<Law> mark_suspects;
    SuspectKernel<Law> mark_waking;
};

struct Kernels {
    std::size_t width; ///< rows at a time
    SumKernel sum_pairs;
    MeasureKernel measure_facets;
    PressureKernel press_cells;
    DashpotKernel facet_dashpots;
    std::array<FacetKernel, 2> facet_forces; ///< second with dashpots
    QuadKernel fill_quads;
    RecordKernel fill_records;
    std::array<ContactKernel, 4> contact_forces; ///< + 1 with rolling, + 2 where the plane repeats
    std::array<MotionKernel, 4> move;            ///< + 1 with mass damping, + 2 with gravity
    law::ForEachBondLaw<PairKernels, FacetKernels, std::tuple> bonds;
};

/// All give the same result to the last bit. `width` 1 always; 2, 4 and 8 where the machine can.
const Kernels& kernels_of(std::size_t width);

/// The widest that this machine can run.
std::size_t widest_kernels();

/// Calls `run(kernels, begin, end)` for the rows of a share that fill the kernels' width, and for the few left one by one.
template <class Run>
void run_rows(const Kernels& kernels, Share part, const Run& run) {
    const std::size_t rest = part.end - (part.end - part.begin) % kernels.width;
    run(kernels, part.begin, rest);
    run(kernels_of(1), rest, part.end);
}

} // namespace demlua::step
