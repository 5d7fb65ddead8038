// Rows of bonds read and written several at a time. Included only where base/lane_vectors.hpp may be.
#pragma once

#include "engine/base/lane_vectors.hpp"
#include "engine/state/bonds.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace demlua::step {

template <std::size_t W>
struct SeveralLanes {
    using Number = Lanes<W>;
    static constexpr std::size_t width = W;

    DEMLUA_INLINE static Number load(const double* from) { return loaded<W>(from); }
    DEMLUA_INLINE static Number load(const float* from) { return loaded<W>(from); }
    DEMLUA_INLINE static void store(double* to, Number value) { demlua::store(to, value); }
    DEMLUA_INLINE static void store(float* to, Number value) { demlua::store(to, value); }
    using Record = LaneRecord<W>;
    DEMLUA_INLINE static Record pick_records(const double* records, const Index* rows) {
        return picked_records<W>(records, rows);
    }
    DEMLUA_INLINE static void put_records(double* to, const Record& record) { store_records<W>(to, record); }
    using Quad = LaneQuad<W>;
    using QuadSum = QuadSums<W>;
    DEMLUA_INLINE static Quad pick_quads(const double* quads, const Index* rows) {
        return picked_quads<W>(quads, rows);
    }
    template <class Value>
    DEMLUA_INLINE static void put_quads(Value* to, const Quad& quads) {
        store_quads<W>(to, quads);
    }
    /// The last number of each of some quads that follow each other.
    DEMLUA_INLINE static void put_last(double* to, Number last) {
        for (std::size_t l = 0; l < W; ++l) to[4 * l + 3] = last.v[l];
    }
    DEMLUA_INLINE static bool any_marked(const std::uint8_t* marks) { return any_set<W>(marks); }

    /// Rows that follow each other, as most do where elements stand in rows, are loaded whole.
    struct Picked {
        const Index* rows;
        bool follow;
        DEMLUA_INLINE explicit Picked(const Index* from) : rows(from), follow(in_a_row<W>(from)) {}
        template <class Value>
        [[nodiscard]] DEMLUA_INLINE Number of(const Value* column) const {
            return follow ? loaded<W>(column + *rows) : picked<W>(column, rows);
        }
    };

    struct Held {
        const std::uint8_t* marks; ///< null where nothing breaks
        bool all = true;
        DEMLUA_INLINE explicit Held(const std::uint8_t* from) : marks(from) {
            if (from != nullptr) all = !any_set<W>(from);
        }
        [[nodiscard]] DEMLUA_INLINE bool none() const { return !all && all_set<W>(marks); }
        DEMLUA_INLINE Number operator()(Number value, Number other = {}) const {
            if (all) [[likely]]
                return value;
            return select(where_zero<W>(marks), value, other);
        }
        DEMLUA_INLINE bool mark(std::uint8_t* to, LaneMask<W> fails) const {
            std::memset(to, 0, W);
            if (!any(fails)) [[likely]]
                return false;
            bool some = false;
            for (std::size_t l = 0; l < W; ++l) {
                to[l] = fails.v[l] != 0 && marks[l] == 0 ? 1 : 0;
                some |= to[l] != 0;
            }
            return some;
        }
        DEMLUA_INLINE bool mark_failing(std::uint8_t* to, LaneMask<W> fails) const {
            if (!any(fails)) [[likely]]
                return false;
            bool some = false;
            for (std::size_t l = 0; l < W; ++l) {
                if (fails.v[l] == 0 || to[l] != 0) continue;
                to[l] = state::failing;
                some = true;
            }
            return some;
        }
    };
};

} // namespace demlua::step
