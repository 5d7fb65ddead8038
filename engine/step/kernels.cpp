#include "engine/step/kernels.hpp"

#include "engine/step/lane_widths.hpp"

#include <stdexcept>

namespace demlua::step {

std::size_t widest_kernels() {
#if defined(__x86_64__)
    __builtin_cpu_init();
    const bool all_of_v4 = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                           __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
                           __builtin_cpu_supports("avx512cd") != 0;
    if (all_of_v4) return 8;
    if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
        __builtin_cpu_supports("bmi2") != 0)
        return 4;
#endif
    return 2;
}

const Kernels& kernels_of(std::size_t width) {
    switch (width) {
    case 1:
        return lanes_1();
    case 2:
        return lanes_2();
    case 4:
        return lanes_4();
    case 8:
        return lanes_8();
    default:
        throw std::logic_error("there are kernels for 1, 2, 4 and 8 rows at a time");
    }
}

} // namespace demlua::step
