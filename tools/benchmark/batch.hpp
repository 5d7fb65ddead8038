// Time of short batches.
#pragma once

#include <chrono>

namespace demlua::bench {

/// Seconds that `work` takes.
template <class Work>
double time_of(const Work& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Seconds that one of as many calls takes as are done when `seconds` are over; one at least.
template <class Work>
double mean_time(double seconds, const Work& work) {
    double taken = 0.0;
    int calls = 0;
    const auto begin = std::chrono::steady_clock::now();
    do {
        work();
        ++calls;
        taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    } while (taken < seconds);
    return taken / calls;
}

} // namespace demlua::bench
