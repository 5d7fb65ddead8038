// Eight rows at a time: compiled for AVX-512.
#include "engine/step/kernel_table.hpp"
#include "engine/step/lane_widths.hpp"
#include "engine/step/several_lanes.hpp"

namespace demlua::step {

const Kernels& lanes_8() {
    static constexpr Kernels kernels = KernelTable<SeveralLanes<8>>::make();
    return kernels;
}

} // namespace demlua::step
