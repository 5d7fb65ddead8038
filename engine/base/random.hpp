// Counter-based random numbers: a value depends on (seed, stream, counter) alone, never on who asked first.
#pragma once

#include <cstdint>

namespace demlua {

/// 64 well-mixed bits from a counter (the finaliser of SplitMix64, Steele, Lea & Flood 2014).
constexpr std::uint64_t mixed_bits(std::uint64_t value) {
    value += 0x9e3779b97f4a7c15ULL;
    value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    value = (value ^ (value >> 27U)) * 0x94d049bb133111ebULL;
    return value ^ (value >> 31U);
}

/// Uniform in [0, 1).
constexpr double uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
    const std::uint64_t bits = mixed_bits(mixed_bits(mixed_bits(seed) ^ stream) ^ counter);
    return static_cast<double>(bits >> 11U) * 0x1.0p-53;
}

} // namespace demlua
