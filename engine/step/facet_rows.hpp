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
    const double *Dx, *Dy, *length, *inverse_length, *share_i;
    double twice_shear; ///< 2G b, N/m
    const double *area, *centre;
    const std::uint8_t* walled;
    std::array<const double*, 6> springs; ///< these and the next are read for walled rows only
    std::array<const double*, 3> growth_i, growth_j;
    const double *plastic_stretch, *plastic_shear;
    double *inverse_d, *normal_x, *normal_y, *stretch, *shift;
    double *grown_i, *grown_j;
    const double* pressure; ///< of the cell of element 0, were it one of this body's
    double *normal, *shear;
    const double *Cn, *Ct;
    double *dashpot_normal, *dashpot_shear, *spent;
    double *fx, *fy, *moment_i, *moment_j;
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
    const double *grown_i, *grown_j; ///< with a row of zeros after the last
    const Index *start, *row;        ///< of state::PairSlots
    const double* pressure_per_growth;
    double* pressure;
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
    const T area = Lane::load(rows.area + k);
    const T centre = Lane::load(rows.centre + k);
    const T per_length = Lane::load(rows.inverse_length + k);
    const T s = Lane::load(rows.share_i + k);
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
        const typename Lane::Picked i(rows.i + k);
        const typename Lane::Picked j(rows.j + k);
        const Vector2<T> D{Lane::load(rows.Dx + k), Lane::load(rows.Dy + k)};
        const law::BondMotion<T> motion =
            motions<Lane>(elements, i, j, D, Lane::load(rows.length + k), Lane::load(rows.inverse_length + k),
                          Lane::load(rows.share_i + k));
        const Vector q = elastic_part<Lane>(rows, k, motion.stretch, motion.shear,
                                            j.of(elements.rotation) - i.of(elements.rotation));
        Lane::store(rows.inverse_d + k, motion.inverse_length);
        Lane::store(rows.normal_x + k, motion.normal.x);
        Lane::store(rows.normal_y + k, motion.normal.y);
        Lane::store(rows.stretch + k, motion.stretch);
        Lane::store(rows.shift + k, motion.shear);
        const FacetParts<T> parts = parts_of<Lane>(rows, k);
        Lane::store(rows.grown_i + k, held(dot(parts.growth_i, q)));
        Lane::store(rows.grown_j + k, held(dot(parts.growth_j, q)));
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
            grown += typename Lane::Picked(cells.row + block * slot + e % block).of(cells.grown_i);
        }
        for (Index slot = start[1]; slot < start[2]; ++slot) {
            grown += typename Lane::Picked(cells.row + block * slot + e % block).of(cells.grown_j);
        }
        Lane::store(cells.pressure + e, Lane::load(cells.pressure_per_growth + e) * grown);
    }
}

template <class Lane>
void facet_dashpots(const FacetRows& rows, const ElementRows& elements, double dt, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const typename Lane::Held held(rows.broken == nullptr ? nullptr : rows.broken + k);
        if (held.none()) continue;
        const typename Lane::Picked i(rows.i + k);
        const typename Lane::Picked j(rows.j + k);
        const Vector2<T> n{Lane::load(rows.normal_x + k), Lane::load(rows.normal_y + k)};
        const law::BondForce<T> rate = rates<Lane>(elements, i, j, n, Lane::load(rows.inverse_d + k),
                                                   Lane::load(rows.length + k), Lane::load(rows.share_i + k));
        law::BondForce<T> unused{T{}, T{}};
        add_dashpots<Lane>(rows, k, held, rate, dt, unused);
    }
}

template <class Lane, bool damped>
void facet_forces(const FacetRows& rows, const ElementRows& elements, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    using Vector = law::FacetVector<T>;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const typename Lane::Held held(rows.broken == nullptr ? nullptr : rows.broken + k);
        if (held.none()) continue;
        const typename Lane::Picked i(rows.i + k);
        const typename Lane::Picked j(rows.j + k);
        const Vector q = elastic_part<Lane>(rows, k, Lane::load(rows.stretch + k), Lane::load(rows.shift + k),
                                            j.of(elements.rotation) - i.of(elements.rotation));
        const FacetParts<T> parts = parts_of<Lane>(rows, k);
        Vector force = parts.springs * q + i.of(rows.pressure) * parts.growth_i + j.of(rows.pressure) * parts.growth_j;
        if (rows.normal != nullptr) {
            Lane::store(rows.normal + k, held(force.normal));
            Lane::store(rows.shear + k, held(force.shear));
        }
        if constexpr (damped) {
            force.normal += Lane::load(rows.dashpot_normal + k);
            force.shear += Lane::load(rows.dashpot_shear + k);
        }
        const T s = Lane::load(rows.share_i + k);
        const T couple = held(force.shear * Lane::load(rows.length + k));
        const T bending = held(force.turn);
        const Vector2<T> n{Lane::load(rows.normal_x + k), Lane::load(rows.normal_y + k)};
        put_force<Lane>(rows, k, n, Lane::load(rows.inverse_d + k), held(force.normal), couple, couple * s + bending,
                        couple * (1.0 - s) - bending);
    }
}

/// Marks the rows that may yield or break under the forces of this instant, so that they are looked at one by one; returns
/// whether there are any.
template <class Law>
struct SuspectRows {
    using History = typename Law::template History<double>;

    typename Law::Tractions tractions;
    const double *normal, *shear, *area, *radius;
    std::array<const double*, History::members.size()> history;
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
        return Law::may_fail(rows.tractions, Lane::load(rows.area + k), Lane::load(rows.radius + k), force,
                             loaded_members<Lane, History>(rows.history, k));
    });
}

/// The same for the rows that may wake.
template <class Lane, class Law>
bool mark_waking(const SuspectRows<Law>& rows, std::size_t begin, std::size_t end) {
    using T = typename Lane::Number;
    return mark_rows<Lane>(rows, begin, end, [&](std::size_t k, const law::BondForce<T>& force) {
        return Law::may_wake(rows.tractions, Lane::load(rows.area + k), force);
    });
}

} // namespace demlua::step
