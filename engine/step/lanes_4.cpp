// Four rows at a time: compiled for AVX2.
#include "engine/step/kernel_table.hpp"
#include "engine/step/lane_widths.hpp"
#include "engine/step/several_lanes.hpp"

namespace demlua::step {

const Kernels& lanes_4() {
    static constexpr Kernels kernels = KernelTable<SeveralLanes<4>>::make();
    return kernels;
}

} // namespace demlua::step
