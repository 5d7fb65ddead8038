// Columns of numbers, aligned so that a vector of lanes starts on a cache line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace demlua {

/// Allocates on 64-byte boundaries.
template <class T>
struct AlignedAllocator {
    using value_type = T;
    static constexpr std::align_val_t alignment{64};

    AlignedAllocator() = default;
    template <class U>
    constexpr explicit AlignedAllocator(const AlignedAllocator<U>& /*other*/) {}

    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
    void deallocate(T* p, std::size_t /*n*/) { ::operator delete(p, alignment); }

    template <class U>
    friend constexpr bool operator==(const AlignedAllocator& /*a*/, const AlignedAllocator<U>& /*b*/) {
        return true;
    }
};

template <class T>
using Column = std::vector<T, AlignedAllocator<T>>;

using Index = std::uint32_t;

} // namespace demlua
