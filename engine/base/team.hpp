// A team of threads that shares loops in fixed contiguous parts, so that no result depends on how many there are.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace demlua {

/// Half-open range of one share of a loop; `part` counts the shares from zero in rising index order.
struct Share {
    std::size_t begin;
    std::size_t end;
    std::size_t part;
};

/// How many threads, and from how many rows on a loop is shared among them: below, waking them costs more than it saves.
struct Threads {
    int count = 1;
    std::size_t shortest_shared_loop = 4096;

    Threads(int threads) : count(threads) {} // NOLINT(google-explicit-constructor)
    Threads(int threads, std::size_t shortest) : count(threads), shortest_shared_loop(shortest) {}
};

/// Worker threads that live as long as the team. A loop body must write only what belongs to its own indices;
/// anything gathered over indices is kept per part and joined in part order, which is index order. Parts are taken by
/// whoever is free: a worker that the machine keeps busy elsewhere is not waited for, its parts go to the others.
class Team {
public:
    explicit Team(Threads threads);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;
    Team(Team&&) = delete;
    Team& operator=(Team&&) = delete;

    [[nodiscard]] std::size_t size() const { return workers_.size() + 1; }

    /// The most parts a loop is shared in.
    [[nodiscard]] std::size_t parts() const { return workers_.empty() ? 1 : parts_per_thread * size(); }

    /// Calls `work(Share)` once per part of [0, count) and waits for all. Loops too short to be worth waking a
    /// thread run on the caller as one part. A loop body must not throw.
    template <class Work>
    void share(std::size_t count, const Work& work) {
        if (workers_.empty() || count < shortest_shared_loop_) {
            work(Share{0, count, 0});
            return;
        }
        dispatch(count, &work, [](const void* context, Share part) { (*static_cast<const Work*>(context))(part); });
    }

private:
    using Trampoline = void (*)(const void*, Share);
    static constexpr std::size_t parts_per_thread = 2;
    static constexpr std::size_t grain = 64; ///< parts begin at multiples of it

    void dispatch(std::size_t count, const void* context, Trampoline call);
    void work();
    bool take_part();
    void run_part(std::size_t part) const;

    std::size_t shortest_shared_loop_;
    std::size_t count_ = 0;
    const void* context_ = nullptr;
    Trampoline call_ = nullptr;
    std::atomic<std::uint32_t> round_{0}; ///< loops begun so far
    std::atomic<std::uint32_t> taken_{0}; ///< parts of the present loop that somebody has taken
    std::atomic<std::uint32_t> left_{0};  ///< parts of the present loop not done
    std::atomic<bool> stopping_{false};
    std::vector<std::thread> workers_;
};

} // namespace demlua
