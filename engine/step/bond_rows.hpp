// Forces in bonds between pairs, row by row: the same arithmetic for one row or for as many as a register holds.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/law/bond_motion.hpp"
#include "engine/law/rate_dependent.hpp"
#include "engine/state/bonds.hpp"
#include "engine/state/elements.hpp"
#include "engine/step/tile.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace demlua::step {

/// Where the columns of elements begin, and the quads that state::BondTable keeps of some of them, if it does.
struct ElementRows {
    const double *ux, *uy, *rotation, *vx, *vy, *spin;
    const double *moved = nullptr, *speeds = nullptr;
};

/// Where the columns of a bond set begin; those of dashpots and of breaking are null where there are none.
template <class Law>
struct BondRows {
    using History = typename Law::template History<double>;

    typename Law::Params params;
    const Index *i, *j;
    NumberRows Dx, Dy, length, inverse_length, share_i, radius;
    std::array<double*, History::members.size()> history;
    bool remembers; ///< whether `history` may be other than zero
    NumberRows Cn, Ct;
    double *dashpot_normal, *dashpot_shear;
    double* spent; ///< of state::LaneSums
    state::ForceTargets forces;
    std::uint8_t* broken;
};

inline ElementRows rows_of(const state::Elements& elements) {
    return {elements.ux.data(), elements.uy.data(), elements.rotation.data(),
            elements.vx.data(), elements.vy.data(), elements.spin.data()};
}

template <class Law>
ElementRows rows_of(const state::Elements& elements, const state::BondTable<Law>& bonds) {
    ElementRows rows = rows_of(elements);
    const auto of_element_0 = [&](const Column<double>& quads) {
        return quads.empty() ? nullptr : quads.data() - 4 * bonds.slots.first;
    };
    rows.moved = of_element_0(bonds.moved);
    rows.speeds = of_element_0(bonds.speeds);
    return rows;
}

template <class Law>
BondRows<Law> rows_of(state::BondSet<Law>& bonds) {
    BondRows<Law> rows{bonds.params,
                       bonds.i.data(),
                       bonds.j.data(),
                       bonds.Dx.rows(),
                       bonds.Dy.rows(),
                       bonds.length.rows(),
                       bonds.inverse_length.rows(),
                       bonds.share_i.rows(),
                       bonds.radius.rows(),
                       {},
                       bonds.remembers || law::follows_rate<Law>,
                       bonds.dashpots.Cn.rows(),
                       bonds.dashpots.Ct.rows(),
                       bonds.dashpots.normal.data(),
                       bonds.dashpots.shear.data(),
                       bonds.dashpots.spent.sums.data(),
                       bonds.forces.targets(),
                       bonds.broken.data()};
    for (std::size_t m = 0; m < rows.history.size(); ++m) rows.history[m] = bonds.history.columns[m].data();
    return rows;
}

template <class Lane, class Struct, class Column>
DEMLUA_INLINE Struct loaded_members(const std::array<Column*, Struct::members.size()>& columns, std::size_t k) {
    Struct whole;
    for (std::size_t m = 0; m < columns.size(); ++m) whole.*Struct::members[m] = Lane::load(columns[m] + k);
    return whole;
}

/// What happened to any of some rows.
struct Happened {
    bool fails = false;
    bool yields = false;

    Happened& operator|=(const Happened& other) {
        fails = fails || other.fails;
        yields = yields || other.yields;
        return *this;
    }
};

/// Fills the forces of the rows [begin, end), a whole multiple of the kernel's width, for the present instant. Rows that
/// fail in it are marked state::failing in `broken`.
template <class Law>
using BondKernel = Happened (*)(const BondRows<Law>& bonds, const ElementRows& elements, double dt, std::size_t begin,
                                std::size_t end);

/// How far elements have moved, or how fast they do.
template <class T>
struct Moved {
    Vector2<T> along;
    T turn;
};

/// Of the elements that `rows` names, from their quads where there are any.
template <class Lane>
DEMLUA_INLINE Moved<typename Lane::Number> looked_up(const double* quads, const double* x, const double* y,
                                                     const double* turn, const Index* rows) {
    if (quads != nullptr) {
        const typename Lane::Quad quad = Lane::pick_quads(quads, rows);
        return {{quad[0], quad[1]}, quad[2]};
    }
    const typename Lane::Picked at(rows);
    return {{at.of(x), at.of(y)}, at.of(turn)};
}

template <class Lane>
DEMLUA_INLINE Moved<typename Lane::Number> displacements(const ElementRows& elements, const Index* rows) {
    return looked_up<Lane>(elements.moved, elements.ux, elements.uy, elements.rotation, rows);
}

template <class Lane>
DEMLUA_INLINE Moved<typename Lane::Number> velocities(const ElementRows& elements, const Index* rows) {
    return looked_up<Lane>(elements.speeds, elements.vx, elements.vy, elements.spin, rows);
}

/// How the ends of bonds have moved, s share of i in their length. Where a bond no longer holds they have not, so that none is
/// asked for the large motions of what has parted.
template <class T>
struct EndMotions {
    Vector2<T> du; ///< of j less that of i, m
    T turn;        ///< mean, rad
};
template <class Held, class T>
DEMLUA_INLINE EndMotions<T> end_motions(const Moved<T>& i, const Moved<T>& j, const Held& held, T s) {
    return {{held(j.along.x - i.along.x), held(j.along.y - i.along.y)}, held(s * i.turn + (1.0 - s) * j.turn)};
}

/// Speeds at which bonds stretch and shear, m/s, from the velocities of the last half step.
template <class T>
DEMLUA_INLINE law::BondForce<T> rates(const Moved<T>& i, const Moved<T>& j, Vector2<T> normal, T inverse_d, T l, T s) {
    const Vector2<T> v = j.along - i.along;
    const T spin = s * i.turn + (1.0 - s) * j.turn;
    return {dot(v, normal), l * (dot(v, turned_left(normal)) * inverse_d - spin)};
}

/// Adds the dashpots' forces to `force` and books what they spend: the mean of the forces at the two ends of the step
/// times the displacement, as central difference exchanges it.
template <class Lane, class Rows, class T, class Held>
DEMLUA_INLINE void add_dashpots(const Rows& bonds, std::size_t k, const Held& held, law::BondForce<T> rate, double dt,
                                law::BondForce<T>& force) {
    const T normal = bonds.Cn.template load<Lane>(k) * rate.normal;
    const T shear = bonds.Ct.template load<Lane>(k) * rate.shear;
    const T doubled = (Lane::load(bonds.dashpot_normal + k) + normal) * rate.normal +
                      (Lane::load(bonds.dashpot_shear + k) + shear) * rate.shear;
    double* spent = bonds.spent + state::LaneSums::place(k);
    Lane::store(spent, Lane::load(spent) + held(0.5 * dt * doubled));
    Lane::store(bonds.dashpot_normal + k, held(normal));
    Lane::store(bonds.dashpot_shear + k, held(shear));
    force.normal += normal;
    force.shear += shear;
}

/// Writes the forces on the elements of rows: normal force along n, `couple` the shear force times the length at bonding.
template <class Lane, class Rows, class T>
DEMLUA_INLINE void put_force(const Rows& bonds, std::size_t k, Vector2<T> n, T inverse_d, T normal, T couple,
                             T moment_i, T moment_j) {
    bonds.forces.template store<Lane>(k, normal * n + (couple * inverse_d) * turned_left(n), moment_i, moment_j);
}

/// What the two loops of a kernel read and hand on for a few rows; it stays in the nearest memory.
struct BondBlock {
    template <class Law>
    explicit BondBlock(const BondRows<Law>& bonds)
        : Dx(bonds.Dx), Dy(bonds.Dy), length(bonds.length), inverse_length(bonds.inverse_length),
          share_i(bonds.share_i), radius(bonds.radius) {}

    Tile Dx, Dy, length, inverse_length, share_i, radius;
    struct Motions {
        alignas(64) double inverse_length[Tile::size], normal_x[Tile::size], normal_y[Tile::size], stretch[Tile::size],
            shear[Tile::size];

        template <class Lane>
        DEMLUA_INLINE void put(std::size_t at, const law::BondMotion<typename Lane::Number>& motion) {
            Lane::store(inverse_length + at, motion.inverse_length);
            Lane::store(normal_x + at, motion.normal.x);
            Lane::store(normal_y + at, motion.normal.y);
            Lane::store(stretch + at, motion.stretch);
            Lane::store(shear + at, motion.shear);
        }
        template <class Lane>
        [[nodiscard]] DEMLUA_INLINE law::BondMotion<typename Lane::Number> at(std::size_t at) const {
            return {Lane::load(inverse_length + at),
                    {Lane::load(normal_x + at), Lane::load(normal_y + at)},
                    Lane::load(stretch + at),
                    Lane::load(shear + at)};
        }
    } motions;
};

template <class Lane, class Law>
void measure(const BondRows<Law>& bonds, const ElementRows& elements, std::size_t begin, std::size_t end,
             BondBlock& block) {
    using T = typename Lane::Number;
    const double* Dx = block.Dx.rows<Lane>(begin, end);
    const double* Dy = block.Dy.rows<Lane>(begin, end);
    const double* length = block.length.rows<Lane>(begin, end);
    const double* inverse_length = block.inverse_length.rows<Lane>(begin, end);
    const double* share_i = block.share_i.rows<Lane>(begin, end);
    for (std::size_t at = 0; at < end - begin; at += Lane::width) {
        const std::size_t k = begin + at;
        const typename Lane::Held held(Law::breaks ? bonds.broken + k : nullptr);
        if (held.none()) continue;
        const EndMotions<T> ends =
            end_motions(displacements<Lane>(elements, bonds.i + k), displacements<Lane>(elements, bonds.j + k), held,
                        Lane::load(share_i + at));
        const Vector2<T> D{Lane::load(Dx + at), Lane::load(Dy + at)};
        const T l = Lane::load(length + at);
        const T inverse_l = Lane::load(inverse_length + at);
        decltype(l > l) large;
        block.motions.put<Lane>(at, law::motion_by_series(D, l, inverse_l, ends.du, ends.turn, large));
        if (any(large)) [[unlikely]] {
            const law::BondMotion<T> turned = law::turned_motion(D, l, inverse_l, ends.du, ends.turn);
            block.motions.put<Lane>(at, law::select_motion(large, turned, block.motions.at<Lane>(at)));
        }
    }
}

template <class Lane, class Law, bool damped>
Happened respond(const BondRows<Law>& bonds, const ElementRows& elements, double dt, std::size_t begin, std::size_t end,
                 BondBlock& block) {
    using T = typename Lane::Number;
    using History = typename Law::template History<T>;
    const double* lengths = block.length.rows<Lane>(begin, end);
    const double* shares = block.share_i.rows<Lane>(begin, end);
    const double* radii = block.radius.rows<Lane>(begin, end);
    Happened happened;
    for (std::size_t at = 0; at < end - begin; at += Lane::width) {
        const std::size_t k = begin + at;
        const typename Lane::Held held(Law::breaks ? bonds.broken + k : nullptr);
        if (held.none()) continue;
        const law::BondMotion<T> motion = block.motions.at<Lane>(at);
        const T s = Lane::load(shares + at);
        const T l = Lane::load(lengths + at);
        const T radius = Lane::load(radii + at);
        const History before = bonds.remembers ? loaded_members<Lane, History>(bonds.history, k) : History{};
        History history = before;
        law::BondForce<T> force = Law::respond(bonds.params, radius, motion, history);
        // Most bonds never yield: their lines of memory need not be written back.
        if (any(Law::has_yielded(before, history))) [[unlikely]] {
            happened.yields = true;
            for (std::size_t m = 0; m < bonds.history.size(); ++m) {
                Lane::store(bonds.history[m] + k, held(history.*History::members[m], before.*History::members[m]));
            }
        }
        if constexpr (Law::breaks) {
            happened.fails |= held.mark_failing(bonds.broken + k, Law::broken(bonds.params, radius, motion, history));
        }
        if constexpr (damped) {
            const law::BondForce<T> rate =
                rates(velocities<Lane>(elements, bonds.i + k), velocities<Lane>(elements, bonds.j + k), motion.normal,
                      motion.inverse_length, l, s);
            add_dashpots<Lane>(bonds, k, held, rate, dt, force);
        }
        const T couple = held(force.shear * l);
        put_force<Lane>(bonds, k, motion.normal, motion.inverse_length, held(force.normal), couple, couple * s,
                        couple * (1.0 - s));
    }
    return happened;
}

/// A kernel. `Lane` says how rows are read and written: OneLane below or SeveralLanes (step/several_lanes.hpp). Two short
/// loops instead of a long one: a processor overlaps more rows where fewer operations wait for each other.
template <class Lane, class Law, bool damped>
Happened bond_forces(const BondRows<Law>& bonds, const ElementRows& elements, double dt, std::size_t begin,
                     std::size_t end) {
    Happened happened;
    BondBlock block(bonds);
    tile_by_tile(begin, end, [&](std::size_t first, std::size_t last) {
        measure<Lane>(bonds, elements, first, last, block);
        happened |= respond<Lane, Law, damped>(bonds, elements, dt, first, last, block);
    });
    return happened;
}

/// One row at a time.
struct OneLane {
    using Number = double;
    static constexpr std::size_t width = 1;

    static double load(const double* from) { return *from; }
    static double load(const float* from) { return static_cast<double>(*from); }
    static void store(double* to, double value) { *to = value; }
    static void store(float* to, double value) { *to = static_cast<float>(value); }
    using Record = std::array<double, 8>;
    static Record pick_records(const double* records, const Index* rows) {
        Record record;
        std::copy_n(records + 8 * std::size_t{*rows}, 8, record.begin());
        return record;
    }
    static void put_records(double* to, const Record& record) { std::copy(record.begin(), record.end(), to); }
    using Quad = std::array<double, 4>;
    struct QuadSum {
        Quad sum{};
        template <class Value>
        void add(const Value* quads, const Index* rows) {
            for (std::size_t m = 0; m < 4; ++m) sum[m] += static_cast<double>(quads[4 * std::size_t{*rows} + m]);
        }
        [[nodiscard]] Quad columns() const { return sum; }
    };
    static Quad pick_quads(const double* quads, const Index* rows) {
        Quad quad;
        std::copy_n(quads + 4 * std::size_t{*rows}, 4, quad.begin());
        return quad;
    }
    template <class Value>
    static void put_quads(Value* to, const Quad& quad) {
        for (std::size_t m = 0; m < 4; ++m) to[m] = static_cast<Value>(quad[m]);
    }
    static void put_last(double* to, double last) { to[3] = last; }
    static bool any_marked(const std::uint8_t* marks) { return *marks != 0; }

    struct Picked {
        Index row;
        explicit Picked(const Index* rows) : row(*rows) {}
        [[nodiscard]] double of(const double* column) const { return column[row]; }
        [[nodiscard]] double of(const float* column) const { return static_cast<double>(column[row]); }
    };

    /// Which rows hold; all of them where there is no mark.
    struct Held {
        bool here;
        explicit Held(const std::uint8_t* broken) : here(broken == nullptr || *broken == 0) {}
        [[nodiscard]] bool none() const { return !here; }
        /// The value where the row holds, `other` where it does not.
        double operator()(double value, double /*other*/ = 0.0) const { return value; }
        static bool mark_failing(std::uint8_t* broken, bool fails) {
            if (fails) *broken = state::failing;
            return fails;
        }
        /// Sets `to` to whether the row holds and `fails`.
        bool mark(std::uint8_t* to, bool fails) const {
            *to = here && fails ? 1 : 0;
            return *to != 0;
        }
    };
};

} // namespace demlua::step
