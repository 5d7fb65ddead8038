#include "tools/benchmark/rates.hpp"

namespace demlua::bench {

RateLoops rate_loops_4() {
#if defined(__x86_64__)
    return rate_loops<4>();
#else
    return {};
#endif
}

} // namespace demlua::bench
