// Columns of numbers, aligned so that a vector of lanes starts on a cache line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <sys/mman.h>
#include <utility>
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

/// Hands out pages of memory that the system has filled with zeros, and does not write zeros again: a column of them takes
/// no room before something is stored in it. Only for columns that are sized once: rows that are taken away and added again
/// keep what they held.
template <class T>
struct ZeroAllocator {
    using value_type = T;

    ZeroAllocator() = default;
    template <class U>
    constexpr explicit ZeroAllocator(const ZeroAllocator<U>& /*other*/) {}

    T* allocate(std::size_t n) {
        void* pages = mmap(nullptr, n * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (pages == MAP_FAILED) throw std::bad_alloc();
        return static_cast<T*>(pages);
    }
    void deallocate(T* p, std::size_t n) { munmap(p, n * sizeof(T)); }

    template <class U>
    void construct(U* /*place*/) {}
    template <class U, class... From>
    void construct(U* place, From&&... from) {
        ::new (static_cast<void*>(place)) U(std::forward<From>(from)...);
    }

    template <class U>
    friend constexpr bool operator==(const ZeroAllocator& /*a*/, const ZeroAllocator<U>& /*b*/) {
        return true;
    }
};

template <class T>
using ZeroColumn = std::vector<T, ZeroAllocator<T>>;

using Index = std::uint32_t;

} // namespace demlua
