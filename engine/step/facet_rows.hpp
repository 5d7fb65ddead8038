// Bonds across facets, row by row, in loops that know no law: how facets move and cells grow, the cells' pressures, and the
// forces of the springs. The same arithmetic for one row or for several.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/law/bond_motion.hpp"
#include "engine/law/facet.hpp"
#include "engine/state/pair_slots.hpp"
#include "engine/step/bond_rows.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace demlua::step {

/// Where the columns of a facet set begin. Null where there is nothing: plastic displacements while nothing has yielded,
/// forces kept and marks of laws that do not break, dashpots.
struct FacetRows {
    const Index *i, *j;
    NumberRows Dx, Dy, length, inverse_length, share_i;
    double twice_shear; ///< 2G b, N/m
    NumberRows area, centre;
    const std::uint8_t* walled;
    std::array<const double*, 6> springs; ///< these and the next are read for walled rows only
    std::array<const double*, 3> growth_i, growth_j;
    const double *plastic_stretch, *plastic_shear;
    NumberTargets inverse_d, normal_x, normal_y, stretch, shift;
    NumberTargets grown_i, grown_j;
    const double* pressure; ///< of the cell of element 0, were it one of this body's
    double *normal, *shear;
    NumberRows Cn, Ct;
    double *dashpot_normal, *dashpot_shear;
    double* spent; ///< of state::LaneSums
    state::ForceTargets forces;
    const std::uint8_t* broken;
};

/// Fills the motions and the growth of the cells' sides in rows [begin, end).
using MeasureKernel = void (*)(const FacetRows& rows, const ElementRows& elements, std::size_t begin, std::size_t end);
/// Fills the dashpots' forces and books what they spend.
using DashpotKernel = void (*)(const FacetRows& rows, const ElementRows& elements, double dt, std::size_t begin,
                               std::size_t end);
/// Fills the forces from motions, pressures and the dashpots' forces as they stand.
using FacetKernel = void (*)(const FacetRows& rows, const ElementRows& elements, std::size_t begin, std::size_t end);

/// Where each cell finds the growth of its sides.
struct CellRows {
    NumberRows grown_i, grown_j; ///< with a row of zeros after the last
    const Index *start, *row;    ///< of state::PairSlots
    const double* pressure_per_growth;
    double* pressure;
    double* moved; ///< quads of the cells' elements, whose last number is the pressure; null where there are none
};

/// Fills the pressures of cells [begin, end).
using PressureKernel = void (*)(const CellRows& cells, std::size_t begin, std::size_t end);

/// What a facet is made of: most of it follows from four numbers, which take less time to read than what they stand for.
template <class T>
struct FacetParts {
    law::FacetSprings<T> springs;
    law::FacetVector<T> growth_i, growth_j;
};

template <class Lane>
DEMLUA_INLINE FacetParts<typename Lane::Number> parts_of(const FacetRows& rows, std::size_t k) {
    using T = typename Lane::Number;
    if (Lane::any_marked(rows.walled + k)) [[unlikely]] {
        return {loaded_members<Lane, law::FacetSprings<T>>(rows.springs, k),
                loaded_members<Lane, law::FacetVector<T>>(rows.growth_i, k),
                loaded_members<Lane, law::FacetVector<T>>(rows.growth_j, k)};
    }
    const T area = rows.area.template load<Lane>(k);
    const T centre = rows.centre.template load<Lane>(k);
    const T per_length = rows.inverse_length.template load<Lane>(k);
    const T s = rows.share_i.template load<Lane>(k);
    return {law::facet_springs(rows.twice_shear, area, centre, per_length),
            law::growth_of_i(area, centre, per_length, s), law::growth_of_j(area, centre, per_length, s)};
}

/// Elastic part of q.
template <class Lane>
DEMLUA_INLINE law::FacetVector<typename Lane::Number>
elastic_part(const FacetRows& rows, std::size_t k, typename Lane::Number stretch, typename Lane::Number shear,
             typename Lane::Number turn) {
    if (rows.plastic_stretch == nullptr) return {stretch, shear, turn};
    return {stretch - Lane::load(rows.plastic_stretch + k), shear - Lane::load(rows.plastic_shear + k), turn};
}

template <class Lane>
void measure_facets(const FacetRows& rows, const ElementRows& elements, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    using Vector = law::FacetVector<T>;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const typename Lane::Held held(rows.broken == nullptr ? nullptr : rows.broken + k);
        if (held.none()) continue;
        const Moved<T> i = displacements<Lane>(elements, rows.i + k);
        const Moved<T> j = displacements<Lane>(elements, rows.j + k);
        const Vector2<T> D{rows.Dx.template load<Lane>(k), rows.Dy.template load<Lane>(k)};
        const law::BondMotion<T> motion =
            motions(i, j, held, D, rows.length.template load<Lane>(k), rows.inverse_length.template load<Lane>(k),
                    rows.share_i.template load<Lane>(k));
        const Vector q = elastic_part<Lane>(rows, k, motion.stretch, motion.shear, j.turn - i.turn);
        rows.inverse_d.template store<Lane>(k, motion.inverse_length);
        rows.normal_x.template store<Lane>(k, motion.normal.x);
        rows.normal_y.template store<Lane>(k, motion.normal.y);
        rows.stretch.template store<Lane>(k, motion.stretch);
        rows.shift.template store<Lane>(k, motion.shear);
        const FacetParts<T> parts = parts_of<Lane>(rows, k);
        rows.grown_i.template store<Lane>(k, held(dot(parts.growth_i, q)));
        rows.grown_j.template store<Lane>(k, held(dot(parts.growth_j, q)));
    }
}

template <class Lane>
void press_cells(const CellRows& cells, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    constexpr std::size_t block = state::PairSlots::block;
    for (std::size_t e = begin; e < end; e += Lane::width) {
        T grown{};
        const Index* start = cells.start + 2 * (e / block);
        for (Index slot = start[0]; slot < start[1]; ++slot) {
            grown += cells.grown_i.pick(typename Lane::Picked(cells.row + block * slot + e % block));
        }
        for (Index slot = start[1]; slot < start[2]; ++slot) {
            grown += cells.grown_j.pick(typename Lane::Picked(cells.row + block * slot + e % block));
        }
        const T pressure = Lane::load(cells.pressure_per_growth + e) * grown;
        Lane::store(cells.pressure + e, pressure);
        if (cells.moved != nullptr) Lane::put_last(cells.moved + 4 * e, pressure);
    }
}

template <class Lane>
void facet_dashpots(const FacetRows& rows, const ElementRows& elements, double dt, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const typename Lane::Held held(rows.broken == nullptr ? nullptr : rows.broken + k);
        if (held.none()) continue;
        const Vector2<T> n{rows.normal_x.template load<Lane>(k), rows.normal_y.template load<Lane>(k)};
        const law::BondForce<T> rate =
            rates(velocities<Lane>(elements, rows.i + k), velocities<Lane>(elements, rows.j + k), n,
                  rows.inverse_d.template load<Lane>(k), rows.length.template load<Lane>(k),
                  rows.share_i.template load<Lane>(k));
        law::BondForce<T> unused{T{}, T{}};
        add_dashpots<Lane>(rows, k, held, rate, dt, unused);
    }
}

/// Of elements: rotation, and pressure of the cell.
template <class T>
struct Pressed {
    T turn, pressure;
};

template <class Lane>
DEMLUA_INLINE Pressed<typename Lane::Number> pressures(const FacetRows& facets, const ElementRows& elements,
                                                       const Index* rows) {
    if (elements.moved != nullptr) {
        const typename Lane::Quad quad = Lane::pick_quads(elements.moved, rows);
        return {quad[2], quad[3]};
    }
    const typename Lane::Picked at(rows);
    return {at.of(elements.rotation), at.of(facets.pressure)};
}

template <class Lane, bool damped>
void facet_forces(const FacetRows& rows, const ElementRows& elements, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    using Vector = law::FacetVector<T>;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const typename Lane::Held held(rows.broken == nullptr ? nullptr : rows.broken + k);
        if (held.none()) continue;
        const Pressed<T> i = pressures<Lane>(rows, elements, rows.i + k);
        const Pressed<T> j = pressures<Lane>(rows, elements, rows.j + k);
        const Vector q = elastic_part<Lane>(rows, k, rows.stretch.template load<Lane>(k),
                                            rows.shift.template load<Lane>(k), j.turn - i.turn);
        const FacetParts<T> parts = parts_of<Lane>(rows, k);
        Vector force = parts.springs * q + i.pressure * parts.growth_i + j.pressure * parts.growth_j;
        if (rows.normal != nullptr) {
            Lane::store(rows.normal + k, held(force.normal));
            Lane::store(rows.shear + k, held(force.shear));
        }
        if constexpr (damped) {
            force.normal += Lane::load(rows.dashpot_normal + k);
            force.shear += Lane::load(rows.dashpot_shear + k);
        }
        const T s = rows.share_i.template load<Lane>(k);
        const T couple = held(force.shear * rows.length.template load<Lane>(k));
        const T bending = held(force.turn);
        const Vector2<T> n{rows.normal_x.template load<Lane>(k), rows.normal_y.template load<Lane>(k)};
        put_force<Lane>(rows, k, n, rows.inverse_d.template load<Lane>(k), held(force.normal), couple,
                        couple * s + bending, couple * (1.0 - s) - bending);
    }
}

/// Marks the rows that may yield or break under the forces of this instant, so that they are looked at one by one; returns
/// whether there are any.
template <class Law>
struct SuspectRows {
    using History = typename Law::template History<double>;

    typename Law::Tractions tractions;
    const double *normal, *shear;
    NumberRows area, radius;
    std::array<const double*, History::members.size()> history;
    bool remembers; ///< whether `history` may be other than zero
    const std::uint8_t* broken;
    std::uint8_t* suspect;
};
template <class Law>
using SuspectKernel = bool (*)(const SuspectRows<Law>& rows, std::size_t begin, std::size_t end);

/// Marks the rows that hold and of which `may(k, force)` says so.
template <class Lane, class Law, class May>
bool mark_rows(const SuspectRows<Law>& rows, std::size_t begin, std::size_t end, const May& may) {
    using T = typename Lane::Number;
    bool some = false;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const law::BondForce<T> force{Lane::load(rows.normal + k), Lane::load(rows.shear + k)};
        const typename Lane::Held held(rows.broken + k);
        some |= held.mark(rows.suspect + k, may(k, force));
    }
    return some;
}

template <class Lane, class Law>
bool mark_suspects(const SuspectRows<Law>& rows, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    using History = typename Law::template History<T>;
    return mark_rows<Lane>(rows, begin, end, [&](std::size_t k, const law::BondForce<T>& force) {
        return Law::may_fail(rows.tractions, rows.area.template load<Lane>(k), rows.radius.template load<Lane>(k),
                             force, rows.remembers ? loaded_members<Lane, History>(rows.history, k) : History{});
    });
}

/// The same for the rows that may wake.
template <class Lane, class Law>
bool mark_waking(const SuspectRows<Law>& rows, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    return mark_rows<Lane>(rows, begin, end, [&](std::size_t k, const law::BondForce<T>& force) {
        return Law::may_wake(rows.tractions, rows.area.template load<Lane>(k), force);
    });
}

} // namespace demlua::step
