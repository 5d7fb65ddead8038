// Loops that find what this machine can do at most, for registers of one width. Included only in rates_*.cpp.
#pragma once

#include "engine/base/lane_vectors.hpp"
#include "tools/benchmark/machine.hpp"

#include <array>
#include <cstddef>

namespace demlua::bench {

/// As many chains as a processor needs to be busy with multiply-adds, each waiting only for itself.
inline constexpr std::size_t chains = 16;

template <std::size_t W>
double multiply_add(std::size_t rounds) {
    std::array<Lanes<W>, chains> x;
    for (std::size_t c = 0; c < chains; ++c) x[c] = Lanes<W>(1.0 + static_cast<double>(c));
    const Lanes<W> factor(0.999);
    const Lanes<W> term(1e-3);
    for (std::size_t round = 0; round < rounds; ++round) {
        for (std::size_t c = 0; c < chains; ++c) x[c] = x[c] * factor + term;
    }
    Lanes<W> sum;
    for (const Lanes<W>& each : x) sum += each;
    return largest(sum);
}

template <std::size_t W>
double divide(std::size_t rounds) {
    std::array<Lanes<W>, chains> x;
    for (std::size_t c = 0; c < chains; ++c) x[c] = Lanes<W>(1.0 + static_cast<double>(c));
    const Lanes<W> over(2.5);
    for (std::size_t round = 0; round < rounds; ++round) {
        for (std::size_t c = 0; c < chains; ++c) x[c] = over / x[c];
    }
    Lanes<W> sum;
    for (const Lanes<W>& each : x) sum += each;
    return largest(sum);
}

template <std::size_t W>
void triad(double* to, const double* a, const double* b, std::size_t begin, std::size_t end) {
    const Lanes<W> factor(0.5);
    for (std::size_t k = begin; k < end; k += W) store(to + k, loaded<W>(a + k) + factor * loaded<W>(b + k));
}

template <std::size_t W>
constexpr RateLoops rate_loops() {
    return {W * chains, multiply_add<W>, divide<W>, triad<W>};
}

} // namespace demlua::bench
