// One row at a time.
#include "engine/step/kernel_table.hpp"
#include "engine/step/lane_widths.hpp"

namespace demlua::step {

const Kernels& lanes_1() {
    static constexpr Kernels kernels = KernelTable<OneLane>::make();
    return kernels;
}

} // namespace demlua::step
