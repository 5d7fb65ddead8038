// Two rows at a time, as any 64-bit machine can.
#include "engine/step/kernel_table.hpp"
#include "engine/step/lane_widths.hpp"
#include "engine/step/several_lanes.hpp"

namespace demlua::step {

const Kernels& lanes_2() {
    static constexpr Kernels kernels = KernelTable<SeveralLanes<2>>::make();
    return kernels;
}

} // namespace demlua::step
