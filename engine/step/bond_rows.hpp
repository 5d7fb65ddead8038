// Forces in bonds between pairs, row by row: the same arithmetic for one row or for as many as a register holds.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/law/bond_motion.hpp"
#include "engine/law/rate_dependent.hpp"
#include "engine/state/bonds.hpp"
#include "engine/state/elements.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace demlua::step {

/// Where the columns of elements begin.
struct ElementRows {
    const double *ux, *uy, *rotation, *vx, *vy, *spin;
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
    const double *Cn, *Ct;
    double *dashpot_normal, *dashpot_shear, *spent;
    NumberTargets fx, fy, moment_i, moment_j;
    std::uint8_t* broken;
};

inline ElementRows rows_of(const state::Elements& elements) {
    return {elements.ux.data(), elements.uy.data(), elements.rotation.data(),
            elements.vx.data(), elements.vy.data(), elements.spin.data()};
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
                       bonds.dashpots.Cn.data(),
                       bonds.dashpots.Ct.data(),
                       bonds.dashpots.normal.data(),
                       bonds.dashpots.shear.data(),
                       bonds.dashpots.spent.data(),
                       bonds.fx.targets(),
                       bonds.fy.targets(),
                       bonds.moment_i.targets(),
                       bonds.moments_of_j().targets(),
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

/// Fills fx .. moment_j of the rows [begin, end), a whole multiple of the kernel's width, for the present instant. Rows that
/// fail in it are marked state::failing in `broken`.
template <class Law>
using BondKernel = Happened (*)(const BondRows<Law>& bonds, const ElementRows& elements, double dt, std::size_t begin,
                                std::size_t end);

/// Kinematics of bonds in the present configuration; s share of i in their length l. Where a bond no longer holds it is that
/// of a bond at rest, so that none is asked for the large motions of what has parted.
template <class Lane, class T>
DEMLUA_INLINE law::BondMotion<T> motions(const ElementRows& elements, const typename Lane::Picked& i,
                                         const typename Lane::Picked& j, const typename Lane::Held& held, Vector2<T> D,
                                         T l, T inverse_l, T s) {
    const T turn = held(s * i.of(elements.rotation) + (1.0 - s) * j.of(elements.rotation));
    const Vector2<T> du{held(j.of(elements.ux) - i.of(elements.ux)), held(j.of(elements.uy) - i.of(elements.uy))};
    return law::bond_motion(D, l, inverse_l, du, turn);
}

/// Speeds at which bonds stretch and shear, m/s, from the velocities of the last half step.
template <class Lane, class T>
DEMLUA_INLINE law::BondForce<T> rates(const ElementRows& elements, const typename Lane::Picked& i,
                                      const typename Lane::Picked& j, Vector2<T> normal, T inverse_d, T l, T s) {
    const Vector2<T> v{j.of(elements.vx) - i.of(elements.vx), j.of(elements.vy) - i.of(elements.vy)};
    const T spin = s * i.of(elements.spin) + (1.0 - s) * j.of(elements.spin);
    return {dot(v, normal), l * (dot(v, turned_left(normal)) * inverse_d - spin)};
}

/// Adds the dashpots' forces to `force` and books what they spend: the mean of the forces at the two ends of the step
/// times the displacement, as central difference exchanges it.
template <class Lane, class Rows, class T, class Held>
DEMLUA_INLINE void add_dashpots(const Rows& bonds, std::size_t k, const Held& held, law::BondForce<T> rate, double dt,
                                law::BondForce<T>& force) {
    const T normal = Lane::load(bonds.Cn + k) * rate.normal;
    const T shear = Lane::load(bonds.Ct + k) * rate.shear;
    const T doubled = (Lane::load(bonds.dashpot_normal + k) + normal) * rate.normal +
                      (Lane::load(bonds.dashpot_shear + k) + shear) * rate.shear;
    Lane::store(bonds.spent + k, Lane::load(bonds.spent + k) + held(0.5 * dt * doubled));
    Lane::store(bonds.dashpot_normal + k, held(normal));
    Lane::store(bonds.dashpot_shear + k, held(shear));
    force.normal += normal;
    force.shear += shear;
}

/// Writes the forces on the elements of rows: normal force along n, `couple` the shear force times the length at bonding.
template <class Lane, class Rows, class T>
DEMLUA_INLINE void put_force(const Rows& bonds, std::size_t k, Vector2<T> n, T inverse_d, T normal, T couple,
                             T moment_i, T moment_j) {
    const Vector2<T> f = normal * n + (couple * inverse_d) * turned_left(n);
    bonds.fx.template store<Lane>(k, f.x);
    bonds.fy.template store<Lane>(k, f.y);
    bonds.moment_i.template store<Lane>(k, moment_i);
    bonds.moment_j.template store<Lane>(k, moment_j);
}

/// Motions of a few rows, which stay in the nearest memory between the two loops of a kernel.
struct MotionBlock {
    static constexpr std::size_t rows = 64;
    alignas(64) double inverse_length[rows], normal_x[rows], normal_y[rows], stretch[rows], shear[rows];
};

template <class Lane, class Law>
void measure(const BondRows<Law>& bonds, const ElementRows& elements, std::size_t begin, std::size_t end,
             MotionBlock& block) {
    using T = typename Lane::Number;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const typename Lane::Held held(Law::breaks ? bonds.broken + k : nullptr);
        if (held.none()) continue;
        const typename Lane::Picked i(bonds.i + k);
        const typename Lane::Picked j(bonds.j + k);
        const Vector2<T> D{bonds.Dx.template load<Lane>(k), bonds.Dy.template load<Lane>(k)};
        const law::BondMotion<T> motion =
            motions<Lane>(elements, i, j, held, D, bonds.length.template load<Lane>(k),
                          bonds.inverse_length.template load<Lane>(k), bonds.share_i.template load<Lane>(k));
        const std::size_t at = k - begin;
        Lane::store(block.inverse_length + at, motion.inverse_length);
        Lane::store(block.normal_x + at, motion.normal.x);
        Lane::store(block.normal_y + at, motion.normal.y);
        Lane::store(block.stretch + at, motion.stretch);
        Lane::store(block.shear + at, motion.shear);
    }
}

template <class Lane>
law::BondMotion<typename Lane::Number> measured(const MotionBlock& block, std::size_t at) {
    return {Lane::load(block.inverse_length + at),
            {Lane::load(block.normal_x + at), Lane::load(block.normal_y + at)},
            Lane::load(block.stretch + at),
            Lane::load(block.shear + at)};
}

template <class Lane, class Law, bool damped>
Happened respond(const BondRows<Law>& bonds, const ElementRows& elements, double dt, std::size_t begin, std::size_t end,
                 const MotionBlock& block) {
    using T = typename Lane::Number;
    using History = typename Law::template History<T>;
    Happened happened;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const typename Lane::Held held(Law::breaks ? bonds.broken + k : nullptr);
        if (held.none()) continue;
        const law::BondMotion<T> motion = measured<Lane>(block, k - begin);
        const T s = bonds.share_i.template load<Lane>(k);
        const T l = bonds.length.template load<Lane>(k);
        const T radius = bonds.radius.template load<Lane>(k);
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
            const typename Lane::Picked i(bonds.i + k);
            const typename Lane::Picked j(bonds.j + k);
            const law::BondForce<T> rate = rates<Lane>(elements, i, j, motion.normal, motion.inverse_length, l, s);
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
    MotionBlock block;
    while (begin < end) {
        const std::size_t stop = begin + MotionBlock::rows < end ? begin + MotionBlock::rows : end;
        measure<Lane>(bonds, elements, begin, stop, block);
        happened |= respond<Lane, Law, damped>(bonds, elements, dt, begin, stop, block);
        begin = stop;
    }
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
