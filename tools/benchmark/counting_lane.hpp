// A lane for the kernels of a step that counts: operations on numbers, and the lines of memory that are read and written.
// What a step costs is then counted in the kernels themselves, not estimated beside them.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/lanes.hpp"
#include "engine/state/bonds.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_set>

namespace demlua::bench {

/// What has been counted since the program began; single-threaded.
struct Tally {
    static constexpr std::uintptr_t line = 64; ///< bytes

    static inline std::uint64_t operations = 0; ///< sums, products, comparisons, choices
    static inline std::uint64_t divisions = 0;  ///< and square roots
    /// Lines of memory that a step must fetch and those it must give back. What it has written itself it need not fetch.
    static inline std::unordered_set<std::uintptr_t> read, written;

    template <class Value>
    static void note_read(const Value* place) {
        const auto at = reinterpret_cast<std::uintptr_t>(place) / line;
        if (!written.contains(at)) read.insert(at);
    }
    template <class Value>
    static void note_written(const Value* place) {
        written.insert(reinterpret_cast<std::uintptr_t>(place) / line);
    }
};

struct Counted {
    double value = 0.0;

    Counted() = default;
    Counted(double of) : value(of) {} // NOLINT(google-explicit-constructor)

    static Counted counted(double value) {
        ++Tally::operations;
        return {value};
    }
    static bool counted(bool truth) {
        ++Tally::operations;
        return truth;
    }
    static Counted divided(double value) {
        ++Tally::divisions;
        return {value};
    }
    friend Counted operator+(Counted a, Counted b) { return counted(a.value + b.value); }
    friend Counted operator-(Counted a, Counted b) { return counted(a.value - b.value); }
    friend Counted operator*(Counted a, Counted b) { return counted(a.value * b.value); }
    friend Counted operator/(Counted a, Counted b) { return divided(a.value / b.value); }
    friend Counted operator-(Counted a) { return counted(-a.value); }
    Counted& operator+=(Counted b) { return *this = *this + b; }
    Counted& operator-=(Counted b) { return *this = *this - b; }
    friend bool operator<(Counted a, Counted b) { return counted(a.value < b.value); }
    friend bool operator>(Counted a, Counted b) { return counted(a.value > b.value); }
    friend bool operator<=(Counted a, Counted b) { return counted(a.value <= b.value); }
    friend bool operator>=(Counted a, Counted b) { return counted(a.value >= b.value); }
};

inline Counted select(bool condition, Counted yes, Counted no) {
    return Counted::counted((condition ? yes : no).value);
}
inline Counted smaller(Counted a, Counted b) { return Counted::counted(demlua::smaller(a.value, b.value)); }
inline Counted larger(Counted a, Counted b) { return Counted::counted(demlua::larger(a.value, b.value)); }
inline Counted magnitude(Counted a) { return Counted::counted(demlua::magnitude(a.value)); }
inline Counted square_root(Counted a) { return Counted::divided(demlua::square_root(a.value)); }
inline double largest(Counted a) { return a.value; }

/// One row at a time, as step::OneLane.
struct CountingLane {
    using Number = Counted;
    static constexpr std::size_t width = 1;

    static Counted load(const double* from) {
        Tally::note_read(from);
        return {*from};
    }
    static Counted load(const float* from) {
        Tally::note_read(from);
        return {static_cast<double>(*from)};
    }
    static void store(float* to, Counted value) {
        Tally::note_written(to);
        *to = static_cast<float>(value.value);
    }
    static void store(double* to, Counted value) {
        Tally::note_written(to);
        *to = value.value;
    }

    using Record = std::array<Counted, 8>;
    static Record pick_records(const double* records, const Index* rows) {
        Record record;
        for (std::size_t m = 0; m < record.size(); ++m) record[m] = load(records + 8 * std::size_t{*rows} + m);
        return record;
    }
    static void put_records(double* to, const Record& record) {
        for (std::size_t m = 0; m < record.size(); ++m) store(to + m, record[m]);
    }

    using Quad = std::array<Counted, 4>;
    struct QuadSum {
        Quad sum{};
        template <class Value>
        void add(const Value* quads, const Index* rows) {
            for (std::size_t m = 0; m < 4; ++m) sum[m] += load(quads + 4 * std::size_t{*rows} + m);
        }
        [[nodiscard]] Quad columns() const { return sum; }
    };
    static Quad pick_quads(const double* quads, const Index* rows) {
        Quad quad;
        for (std::size_t m = 0; m < 4; ++m) quad[m] = load(quads + 4 * std::size_t{*rows} + m);
        return quad;
    }
    template <class Value>
    static void put_quads(Value* to, const Quad& quad) {
        for (std::size_t m = 0; m < 4; ++m) store(to + m, quad[m]);
    }
    static void put_last(double* to, Counted last) { store(to + 3, last); }

    static bool any_marked(const std::uint8_t* marks) {
        Tally::note_read(marks);
        return *marks != 0;
    }

    struct Picked {
        Index row;
        explicit Picked(const Index* rows) : row(*rows) { Tally::note_read(rows); }
        template <class Value>
        [[nodiscard]] Counted of(const Value* column) const {
            return load(column + row);
        }
    };

    struct Held {
        bool here;
        explicit Held(const std::uint8_t* broken) : here(broken == nullptr || *broken == 0) {
            if (broken != nullptr) Tally::note_read(broken);
        }
        [[nodiscard]] bool none() const { return !here; }
        Counted operator()(Counted value, Counted /*other*/ = {}) const { return value; }
        static bool mark_failing(std::uint8_t* broken, bool fails) {
            if (fails) *broken = state::failing;
            return fails;
        }
        [[nodiscard]] bool mark(std::uint8_t* to, bool fails) const {
            Tally::note_written(to);
            *to = here && fails ? 1 : 0;
            return *to != 0;
        }
    };
};

} // namespace demlua::bench
