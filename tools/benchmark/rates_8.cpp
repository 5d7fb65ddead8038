#include "tools/benchmark/rates.hpp"

namespace demlua::bench {

RateLoops rate_loops_8() {
#if defined(__x86_64__)
    return rate_loops<8>();
#else
    return {};
#endif
}

} // namespace demlua::bench
