#include "tools/benchmark/rates.hpp"

namespace demlua::bench {

RateLoops rate_loops_2() { return rate_loops<2>(); }

} // namespace demlua::bench
