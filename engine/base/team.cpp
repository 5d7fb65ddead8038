#include "engine/base/team.hpp"

#include <algorithm>

namespace demlua {

namespace {

// Long enough to bridge the gap between two stages of a step, short enough not to burn a core between runs.
constexpr int spins_before_sleep = 1000;

template <class Value>
void await_change(const std::atomic<Value>& value, Value old) {
    for (int spin = 0; spin < spins_before_sleep; ++spin) {
        if (value.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
        __builtin_ia32_pause();
#endif
    }
    while (value.load(std::memory_order_acquire) == old) value.wait(old, std::memory_order_acquire);
}

} // namespace

Team::Team(Threads threads) : shortest_shared_loop_(threads.shortest_shared_loop) {
    const auto others = static_cast<std::size_t>(std::max(threads.count, 1) - 1);
    taken_.store(static_cast<std::uint32_t>(parts_per_thread * (others + 1)), std::memory_order_relaxed);
    workers_.reserve(others);
    for (std::size_t k = 0; k < others; ++k) workers_.emplace_back([this] { work(); });
}

Team::~Team() {
    stopping_.store(true, std::memory_order_release);
    round_.fetch_add(1, std::memory_order_acq_rel);
    round_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void Team::dispatch(std::size_t count, const void* context, Trampoline call) {
    count_ = count;
    context_ = context;
    call_ = call;
    left_.store(static_cast<std::uint32_t>(parts()), std::memory_order_relaxed);
    // From here on a worker, even one late from the loop before, may take parts of this loop.
    taken_.store(0, std::memory_order_release);
    round_.fetch_add(1, std::memory_order_acq_rel);
    round_.notify_all();
    while (take_part()) {
    }
    for (std::uint32_t left = left_.load(std::memory_order_acquire); left != 0;
         left = left_.load(std::memory_order_acquire)) {
        await_change(left_, left);
    }
}

void Team::work() {
    std::uint32_t seen = 0;
    while (true) {
        await_change(round_, seen);
        seen = round_.load(std::memory_order_acquire);
        if (stopping_.load(std::memory_order_acquire)) return;
        while (take_part()) {
        }
    }
}

bool Team::take_part() {
    std::uint32_t part = taken_.load(std::memory_order_acquire);
    do {
        if (part >= parts()) return false;
    } while (!taken_.compare_exchange_weak(part, part + 1, std::memory_order_acq_rel, std::memory_order_acquire));
    run_part(part);
    if (left_.fetch_sub(1, std::memory_order_acq_rel) == 1) left_.notify_one();
    return true;
}

void Team::run_part(std::size_t part) const {
    const std::size_t grains = (count_ + grain - 1) / grain;
    const std::size_t begin = std::min(count_, grains * part / parts() * grain);
    const std::size_t end = std::min(count_, grains * (part + 1) / parts() * grain);
    call_(context_, Share{begin, end, part});
}

} // namespace demlua
