// Several numbers at once, one in each lane, under the names of base/lanes.hpp. Every operation gives in each lane what it
// gives for one number, to the last bit: sums, products, quotients and roots are rounded alike, and none are fused.
//
// Only files compiled for one width include this (step/lanes_*.cpp): code for wide registers must not be found, under the
// same name, where a narrower machine runs it.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/lanes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace demlua {

template <std::size_t W>
struct LaneTypes {
    typedef double Numbers __attribute__((vector_size(W * sizeof(double))));            // NOLINT(modernize-use-using)
    typedef float Singles __attribute__((vector_size(W * sizeof(float))));              // NOLINT(modernize-use-using)
    typedef std::int64_t Truths __attribute__((vector_size(W * sizeof(std::int64_t)))); // NOLINT(modernize-use-using)
    typedef std::uint8_t Bytes __attribute__((vector_size(W)));                         // NOLINT(modernize-use-using)
    typedef Index Rows __attribute__((vector_size(W * sizeof(Index))));                 // NOLINT(modernize-use-using)
};

template <std::size_t W>
struct LaneMask {
    typename LaneTypes<W>::Truths v; ///< all bits set where true
};

template <std::size_t W>
struct Lanes {
    using Vector = typename LaneTypes<W>::Numbers;
    Vector v{};

    Lanes() = default;
    DEMLUA_INLINE Lanes(double same) : v(same - Vector{}) {} // NOLINT(google-explicit-constructor)
    DEMLUA_INLINE explicit Lanes(Vector vector) : v(vector) {}

    friend DEMLUA_INLINE Lanes operator+(Lanes a, Lanes b) { return Lanes(a.v + b.v); }
    friend DEMLUA_INLINE Lanes operator-(Lanes a, Lanes b) { return Lanes(a.v - b.v); }
    friend DEMLUA_INLINE Lanes operator*(Lanes a, Lanes b) { return Lanes(a.v * b.v); }
    friend DEMLUA_INLINE Lanes operator/(Lanes a, Lanes b) { return Lanes(a.v / b.v); }
    friend DEMLUA_INLINE Lanes operator-(Lanes a) { return Lanes(-a.v); }
    DEMLUA_INLINE Lanes& operator+=(Lanes b) { return *this = *this + b; }
    DEMLUA_INLINE Lanes& operator-=(Lanes b) { return *this = *this - b; }
    friend DEMLUA_INLINE LaneMask<W> operator<(Lanes a, Lanes b) { return {a.v < b.v}; }
    friend DEMLUA_INLINE LaneMask<W> operator>(Lanes a, Lanes b) { return {a.v > b.v}; }
    friend DEMLUA_INLINE LaneMask<W> operator<=(Lanes a, Lanes b) { return {a.v <= b.v}; }
    friend DEMLUA_INLINE LaneMask<W> operator>=(Lanes a, Lanes b) { return {a.v >= b.v}; }
};

template <std::size_t W>
DEMLUA_INLINE LaneMask<W> either(LaneMask<W> a, LaneMask<W> b) {
    return {a.v | b.v};
}
template <std::size_t W>
DEMLUA_INLINE LaneMask<W> both(LaneMask<W> a, LaneMask<W> b) {
    return {a.v & b.v};
}
template <std::size_t W>
DEMLUA_INLINE LaneMask<W> operator!(LaneMask<W> a) {
    return {~a.v};
}
template <std::size_t W>
DEMLUA_INLINE bool any(LaneMask<W> mask) {
#if defined(__AVX512F__)
    if constexpr (W == 8)
        return _mm512_test_epi64_mask(reinterpret_cast<__m512i>(mask.v), reinterpret_cast<__m512i>(mask.v)) != 0;
#elif defined(__AVX2__)
    if constexpr (W == 4) return _mm256_movemask_pd(reinterpret_cast<__m256d>(mask.v)) != 0;
#endif
    std::int64_t found = 0;
    for (std::size_t l = 0; l < W; ++l) found |= mask.v[l];
    return found != 0;
}
template <std::size_t W>
DEMLUA_INLINE Lanes<W> select(LaneMask<W> mask, Lanes<W> yes, Lanes<W> no) {
    return Lanes<W>(mask.v ? yes.v : no.v);
}
template <std::size_t W>
DEMLUA_INLINE Lanes<W> smaller(Lanes<W> a, Lanes<W> b) {
    return Lanes<W>(b.v < a.v ? b.v : a.v);
}
template <std::size_t W>
DEMLUA_INLINE Lanes<W> larger(Lanes<W> a, Lanes<W> b) {
    return Lanes<W>(a.v < b.v ? b.v : a.v);
}
template <std::size_t W>
DEMLUA_INLINE Lanes<W> magnitude(Lanes<W> value) {
    constexpr std::int64_t all_but_sign = 0x7fffffffffffffff;
    const auto bits = reinterpret_cast<typename LaneTypes<W>::Truths>(value.v) & all_but_sign;
    return Lanes<W>(reinterpret_cast<typename LaneTypes<W>::Numbers>(bits));
}
template <std::size_t W>
DEMLUA_INLINE Lanes<W> square_root(Lanes<W> value) {
    Lanes<W> root;
    for (std::size_t l = 0; l < W; ++l) root.v[l] = std::sqrt(value.v[l]);
    return root;
}

template <std::size_t W>
DEMLUA_INLINE double largest(Lanes<W> value) {
    double most = value.v[0];
    for (std::size_t l = 1; l < W; ++l) most = most < value.v[l] ? value.v[l] : most;
    return most;
}

/// Numbers that stand next to each other, or that are picked out row by row.
template <std::size_t W>
DEMLUA_INLINE Lanes<W> loaded(const double* from) {
    Lanes<W> lanes;
    std::memcpy(&lanes.v, from, sizeof lanes.v);
    return lanes;
}
template <std::size_t W>
DEMLUA_INLINE void store(double* to, Lanes<W> lanes) {
    std::memcpy(to, &lanes.v, sizeof lanes.v);
}
template <std::size_t W>
DEMLUA_INLINE Lanes<W> loaded(const float* from) {
    typename LaneTypes<W>::Singles singles;
    std::memcpy(&singles, from, sizeof singles);
    return Lanes<W>(__builtin_convertvector(singles, typename LaneTypes<W>::Numbers));
}
template <std::size_t W>
DEMLUA_INLINE void store(float* to, Lanes<W> lanes) {
    const auto singles = __builtin_convertvector(lanes.v, typename LaneTypes<W>::Singles);
    std::memcpy(to, &singles, sizeof singles);
}
template <std::size_t W>
DEMLUA_INLINE Lanes<W> picked(const float* from, const Index* rows) {
    typename LaneTypes<W>::Singles singles;
    for (std::size_t l = 0; l < W; ++l) singles[l] = from[rows[l]];
    return Lanes<W>(__builtin_convertvector(singles, typename LaneTypes<W>::Numbers));
}
template <std::size_t W>
DEMLUA_INLINE Lanes<W> picked(const double* from, const Index* rows) {
#if defined(__AVX512F__)
    if constexpr (W == 8) {
        const __m256i at = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(rows));
        return Lanes<W>(_mm512_mask_i32gather_pd(_mm512_setzero_pd(), 0xff, at, from, 8));
    }
#elif defined(__AVX2__)
    if constexpr (W == 4) {
        const __m128i at = _mm_loadu_si128(reinterpret_cast<const __m128i*>(rows));
        const __m256d wanted = _mm256_castsi256_pd(_mm256_set1_epi64x(-1));
        return Lanes<W>(_mm256_mask_i32gather_pd(_mm256_setzero_pd(), from, at, wanted, 8));
    }
#endif
    Lanes<W> lanes;
    for (std::size_t l = 0; l < W; ++l) lanes.v[l] = from[rows[l]];
    return lanes;
}

/// Eight numbers for each lane.
template <std::size_t W>
using LaneRecord = std::array<Lanes<W>, 8>;

/// Rows become columns: lane l of entry m changes places with lane m of entry l.
DEMLUA_INLINE void transpose(LaneRecord<8>& square) {
    for (const std::size_t at : {0UL, 2UL, 4UL, 6UL}) {
        const auto a = square[at].v;
        const auto b = square[at + 1].v;
        square[at].v = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
        square[at + 1].v = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (const std::size_t at : {0UL, 1UL, 4UL, 5UL}) {
        const auto a = square[at].v;
        const auto b = square[at + 2].v;
        square[at].v = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
        square[at + 2].v = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    }
    for (const std::size_t at : {0UL, 1UL, 2UL, 3UL}) {
        const auto a = square[at].v;
        const auto b = square[at + 4].v;
        square[at].v = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
        square[at + 4].v = __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
    }
}

/// Records of eight numbers that stand together in memory, picked out row by row: whole lines of memory, turned in
/// registers, where there are enough of these.
template <std::size_t W>
DEMLUA_INLINE LaneRecord<W> picked_records(const double* records, const Index* rows) {
    LaneRecord<W> record;
    if constexpr (W == 8) {
        for (std::size_t l = 0; l < W; ++l) record[l] = loaded<W>(records + 8 * std::size_t{rows[l]});
        transpose(record);
    } else {
        for (std::size_t m = 0; m < record.size(); ++m) {
            for (std::size_t l = 0; l < W; ++l) record[m].v[l] = records[8 * std::size_t{rows[l]} + m];
        }
    }
    return record;
}

/// W records that follow each other.
template <std::size_t W>
DEMLUA_INLINE void store_records(double* to, LaneRecord<W> record) {
    if constexpr (W == 8) {
        transpose(record);
        for (std::size_t l = 0; l < W; ++l) store(to + 8 * l, record[l]);
    } else {
        for (std::size_t m = 0; m < record.size(); ++m) {
            for (std::size_t l = 0; l < W; ++l) to[8 * l + m] = record[m].v[l];
        }
    }
}

/// Two times four numbers beside each other; the second are put in as they are read, which asks less of a processor than to
/// shuffle them.
DEMLUA_INLINE Lanes<8> joined(const double* low, const double* high) {
#if defined(__AVX512F__)
    const __m512d twice = _mm512_maskz_broadcast_f64x4(0xff, _mm256_loadu_pd(low));
    return Lanes<8>(_mm512_maskz_insertf64x4(0xff, twice, _mm256_loadu_pd(high), 1));
#else
    return Lanes<8>(__builtin_shufflevector(loaded<4>(low).v, loaded<4>(high).v, 0, 1, 2, 3, 4, 5, 6, 7));
#endif
}

/// Four numbers for each lane.
template <std::size_t W>
using LaneQuad = std::array<Lanes<W>, 4>;

/// Four entries of two quads each, in the order of lanes, become columns: entry m holds the numbers m of all quads.
DEMLUA_INLINE LaneQuad<8> columns_of(const LaneQuad<8>& pairs) {
    std::array<LaneTypes<8>::Numbers, 4> half;
    for (const std::size_t at : {0UL, 1UL}) {
        const auto a = pairs[2 * at].v;
        const auto b = pairs[2 * at + 1].v;
        half[at] = __builtin_shufflevector(a, b, 0, 4, 8, 12, 1, 5, 9, 13);
        half[at + 2] = __builtin_shufflevector(a, b, 2, 6, 10, 14, 3, 7, 11, 15);
    }
    LaneQuad<8> columns;
    for (const std::size_t at : {0UL, 2UL}) {
        columns[at].v = __builtin_shufflevector(half[at], half[at + 1], 0, 1, 2, 3, 8, 9, 10, 11);
        columns[at + 1].v = __builtin_shufflevector(half[at], half[at + 1], 4, 5, 6, 7, 12, 13, 14, 15);
    }
    return columns;
}
/// The way back.
DEMLUA_INLINE LaneQuad<8> pairs_of(const LaneQuad<8>& columns) {
    std::array<LaneTypes<8>::Numbers, 4> half;
    for (const std::size_t at : {0UL, 2UL}) {
        const auto a = columns[at].v;
        const auto b = columns[at + 1].v;
        half[at] = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
        half[at + 1] = __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
    }
    LaneQuad<8> pairs;
    for (const std::size_t at : {0UL, 1UL}) {
        pairs[2 * at].v = __builtin_shufflevector(half[at], half[at + 2], 0, 4, 8, 12, 1, 5, 9, 13);
        pairs[2 * at + 1].v = __builtin_shufflevector(half[at], half[at + 2], 2, 6, 10, 14, 3, 7, 11, 15);
    }
    return pairs;
}
/// Four quads become columns, or columns quads.
DEMLUA_INLINE LaneQuad<4> columns_of(const LaneQuad<4>& quads) {
    std::array<LaneTypes<4>::Numbers, 4> half;
    for (const std::size_t at : {0UL, 1UL}) {
        const auto a = quads[2 * at].v;
        const auto b = quads[2 * at + 1].v;
        half[at] = __builtin_shufflevector(a, b, 0, 4, 2, 6);
        half[at + 2] = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    }
    LaneQuad<4> columns;
    for (const std::size_t at : {0UL, 2UL}) {
        columns[at / 2].v = __builtin_shufflevector(half[at], half[at + 1], 0, 1, 4, 5);
        columns[at / 2 + 2].v = __builtin_shufflevector(half[at], half[at + 1], 2, 3, 6, 7);
    }
    return columns;
}

/// Quads of numbers that stand together in memory, picked out row by row.
template <std::size_t W>
DEMLUA_INLINE LaneQuad<W> picked_quads(const double* quads, const Index* rows) {
    LaneQuad<W> found;
    if constexpr (W == 8) {
        for (std::size_t m = 0; m < 4; ++m) {
            found[m] = joined(quads + 4 * std::size_t{rows[2 * m]}, quads + 4 * std::size_t{rows[2 * m + 1]});
        }
        return columns_of(found);
    } else if constexpr (W == 4) {
        for (std::size_t l = 0; l < W; ++l) found[l] = loaded<4>(quads + 4 * std::size_t{rows[l]});
        return columns_of(found);
    } else {
        for (std::size_t l = 0; l < W; ++l) {
            for (std::size_t m = 0; m < 4; ++m) found[m].v[l] = quads[4 * std::size_t{rows[l]} + m];
        }
        return found;
    }
}

/// W quads that follow each other, in double or single precision.
template <std::size_t W, class Value>
DEMLUA_INLINE void store_quads(Value* to, const LaneQuad<W>& columns) {
    if constexpr (W == 8) {
        const LaneQuad<8> pairs = pairs_of(columns);
        for (std::size_t m = 0; m < 4; ++m) store(to + 8 * m, pairs[m]);
    } else if constexpr (W == 4) {
        const LaneQuad<4> quads = columns_of(columns);
        for (std::size_t l = 0; l < 4; ++l) store(to + 4 * l, quads[l]);
    } else {
        for (std::size_t l = 0; l < W; ++l) {
            for (std::size_t m = 0; m < 4; ++m) to[4 * l + m] = static_cast<Value>(columns[m].v[l]);
        }
    }
}

/// Sums of quads, one for each lane.
template <std::size_t W>
struct QuadSums {
    std::array<Lanes<4>, W> lane{};

    template <class Value>
    DEMLUA_INLINE void add(const Value* quads, const Index* rows) {
        for (std::size_t l = 0; l < W; ++l) lane[l] += loaded<4>(quads + 4 * std::size_t{rows[l]});
    }
    [[nodiscard]] DEMLUA_INLINE LaneQuad<W> columns() const {
        LaneQuad<W> found;
        if constexpr (W == 8) {
            for (std::size_t m = 0; m < 4; ++m) {
                found[m].v = __builtin_shufflevector(lane[2 * m].v, lane[2 * m + 1].v, 0, 1, 2, 3, 4, 5, 6, 7);
            }
            return columns_of(found);
        } else if constexpr (W == 4) {
            return columns_of(lane);
        } else {
            for (std::size_t l = 0; l < W; ++l) {
                for (std::size_t m = 0; m < 4; ++m) found[m].v[l] = lane[l].v[m];
            }
            return found;
        }
    }
};

/// Whether any of W bytes is not zero.
template <std::size_t W>
DEMLUA_INLINE bool any_set(const std::uint8_t* bytes) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, W);
    return word != 0;
}
template <std::size_t W>
DEMLUA_INLINE bool all_set(const std::uint8_t* bytes) {
    bool all = true;
    for (std::size_t l = 0; l < W; ++l) all &= bytes[l] != 0;
    return all;
}

/// True where a byte is zero, of bytes that are 0 or 1.
template <std::size_t W>
DEMLUA_INLINE LaneMask<W> where_zero(const std::uint8_t* bytes) {
    typename LaneTypes<W>::Bytes found;
    std::memcpy(&found, bytes, sizeof found);
    return {__builtin_convertvector(found, typename LaneTypes<W>::Truths) - 1};
}

/// Whether `rows` are W that follow each other.
template <std::size_t W>
DEMLUA_INLINE bool in_a_row(const Index* rows) {
    typename LaneTypes<W>::Rows found;
    std::memcpy(&found, rows, sizeof found);
    typename LaneTypes<W>::Rows wanted{};
    for (std::size_t l = 0; l < W; ++l) wanted[l] = static_cast<Index>(l);
    wanted += found[0];
#if defined(__AVX512VL__)
    if constexpr (W == 8)
        return _mm256_cmpneq_epi32_mask(reinterpret_cast<__m256i>(found), reinterpret_cast<__m256i>(wanted)) == 0;
#elif defined(__AVX2__)
    if constexpr (W == 4) return _mm_movemask_epi8(reinterpret_cast<__m128i>(found == wanted)) == 0xffff;
#endif
    const auto off = found - wanted;
    std::uint64_t parts[sizeof off / sizeof(std::uint64_t)];
    std::memcpy(parts, &off, sizeof off);
    std::uint64_t differs = 0;
    for (const std::uint64_t part : parts) differs |= part;
    return differs == 0;
}

} // namespace demlua
