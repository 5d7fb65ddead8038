// Elements, row by row: sums of the forces on them, and their motion. The same arithmetic for one row or for several.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/state/pair_forces.hpp"
#include "engine/state/pair_slots.hpp"

#include <array>
#include <cstddef>

namespace demlua::step {

/// Fills the first three numbers of the quads of elements [begin, end) from columns; the fourth becomes zero.
using QuadKernel = void (*)(const std::array<const double*, 3>& columns, double* quads, std::size_t begin,
                            std::size_t end);

template <class Lane>
void fill_quads(const std::array<const double*, 3>& columns, double* quads, std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; e += Lane::width) {
        Lane::put_quads(quads + 4 * e, typename Lane::Quad{Lane::load(columns[0] + e), Lane::load(columns[1] + e),
                                                           Lane::load(columns[2] + e), typename Lane::Number{}});
    }
}

/// Forces in pairs, and where each element finds its own.
struct PairSums {
    state::ForceRows forces;            ///< with a row of zeros where no pair is
    const Index *start, *row;           ///< of state::PairSlots
    double *sum_x, *sum_y, *sum_moment; ///< of the slots' first element
};

/// Adds the forces of pairs to elements [begin, end), counted from the slots' first.
using SumKernel = void (*)(const PairSums& sums, std::size_t begin, std::size_t end);

/// Forces of the pairs in which elements are i, or of those in which they are j.
template <class T>
struct EndSum {
    T fx{}, fy{}, moment{};
};

/// Over the slots [begin, end); `rows` are those of the first elements' slot 0.
template <class Lane>
DEMLUA_INLINE EndSum<typename Lane::Number> sum_columns(const state::ForceRows& forces, const NumberRows& moments,
                                                        const Index* rows, Index begin, Index end) {
    EndSum<typename Lane::Number> sum;
    for (Index slot = begin; slot < end; ++slot) {
        const typename Lane::Picked pair(rows + state::PairSlots::block * slot);
        sum.fx += forces.fx.pick(pair);
        sum.fy += forces.fy.pick(pair);
        sum.moment += moments.pick(pair);
    }
    return sum;
}

/// The same from quads, `moment` being the place of the moment in them.
template <class Lane, class Value>
DEMLUA_INLINE EndSum<typename Lane::Number> sum_quads(const Value* quads, std::size_t moment, const Index* rows,
                                                      Index begin, Index end) {
    typename Lane::QuadSum sum;
    for (Index slot = begin; slot < end; ++slot) sum.add(quads, rows + state::PairSlots::block * slot);
    const typename Lane::Quad columns = sum.columns();
    return {columns[0], columns[1], columns[moment]};
}

template <class Lane>
void sum_pairs(const PairSums& sums, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    constexpr std::size_t block = state::PairSlots::block;
    const state::ForceRows& forces = sums.forces;
    for (std::size_t e = begin; e < end; e += Lane::width) {
        const Index* start = sums.start + 2 * (e / block);
        if (start[0] == start[2]) continue;
        const Index* rows = sums.row + e % block;
        EndSum<T> as_i;
        EndSum<T> as_j;
        if (forces.quads.wide != nullptr) {
            as_i = sum_quads<Lane>(forces.quads.wide, 2, rows, start[0], start[1]);
            as_j = sum_quads<Lane>(forces.quads.wide, 3, rows, start[1], start[2]);
        } else if (forces.quads.narrow != nullptr) {
            as_i = sum_quads<Lane>(forces.quads.narrow, 2, rows, start[0], start[1]);
            as_j = sum_quads<Lane>(forces.quads.narrow, 3, rows, start[1], start[2]);
        } else {
            as_i = sum_columns<Lane>(forces, forces.moment_i, rows, start[0], start[1]);
            as_j = sum_columns<Lane>(forces, forces.moment_j, rows, start[1], start[2]);
        }
        Lane::store(sums.sum_x + e, Lane::load(sums.sum_x + e) + (as_i.fx - as_j.fx));
        Lane::store(sums.sum_y + e, Lane::load(sums.sum_y + e) + (as_i.fy - as_j.fy));
        Lane::store(sums.sum_moment + e, Lane::load(sums.sum_moment + e) + (as_i.moment + as_j.moment));
    }
}

/// Where the columns of elements begin that move; `spent` is null where mass damping takes nothing.
struct MotionRows {
    double *ux, *uy, *rotation, *vx, *vy, *spin, *fx, *fy, *moment;
    const double *inverse_mass, *inverse_inertia;
    double* spent;
};

/// A step of motion; see step/motion.hpp for keep and gain.
struct MotionTerms {
    double keep = 1.0;
    double gain = 0.0;  ///< s
    double dt = 0.0;    ///< s
    double alpha = 0.0; ///< 1/s
    double gx = 0.0;    ///< m/s^2
    double gy = 0.0;
    double speed_limit = 0.0; ///< m/s
};

struct Fastest {
    double speed_squared = 0.0;
    bool beyond_limit = false; ///< or no number
};

/// Kicks and moves elements [begin, end) and leaves gravity as the force on them.
using MotionKernel = Fastest (*)(const MotionRows& rows, const MotionTerms& terms, std::size_t begin, std::size_t end);

template <class Lane, bool damped, bool heavy>
Fastest move_rows(const MotionRows& rows, const MotionTerms& terms, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    const T limit = terms.speed_limit * terms.speed_limit;
    T fastest{};
    auto fine = fastest <= limit;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const T inverse_mass = Lane::load(rows.inverse_mass + k);
        const T inverse_inertia = Lane::load(rows.inverse_inertia + k);
        const Vector2<T> v{Lane::load(rows.vx + k), Lane::load(rows.vy + k)};
        const T spin = Lane::load(rows.spin + k);
        const Vector2<T> next{terms.keep * v.x + terms.gain * (Lane::load(rows.fx + k) * inverse_mass),
                              terms.keep * v.y + terms.gain * (Lane::load(rows.fy + k) * inverse_mass)};
        const T next_spin = terms.keep * spin + terms.gain * (Lane::load(rows.moment + k) * inverse_inertia);
        if constexpr (damped) {
            const Vector2<T> mean = T{0.5} * (v + next);
            const T mean_spin = 0.5 * (spin + next_spin);
            Lane::store(rows.spent + k, terms.alpha * terms.dt *
                                            (dot(mean, mean) / inverse_mass + mean_spin * mean_spin / inverse_inertia));
        }
        const T speed_squared = dot(next, next);
        fastest = larger(fastest, speed_squared);
        fine = both(fine, speed_squared <= limit);
        Lane::store(rows.vx + k, next.x);
        Lane::store(rows.vy + k, next.y);
        Lane::store(rows.spin + k, next_spin);
        Lane::store(rows.ux + k, Lane::load(rows.ux + k) + terms.dt * next.x);
        Lane::store(rows.uy + k, Lane::load(rows.uy + k) + terms.dt * next.y);
        Lane::store(rows.rotation + k, Lane::load(rows.rotation + k) + terms.dt * next_spin);
        const T mass = heavy ? 1.0 / inverse_mass : T{};
        Lane::store(rows.fx + k, heavy ? mass * terms.gx : T{});
        Lane::store(rows.fy + k, heavy ? mass * terms.gy : T{});
        Lane::store(rows.moment + k, T{});
    }
    return {largest(fastest), any(!fine)};
}

} // namespace demlua::step
