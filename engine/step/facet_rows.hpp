// Bonds across facets, row by row, in loops that know no law: how facets move and cells grow, the cells' pressures, and the
// forces of the springs. The same arithmetic for one row or for several.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/law/bond_motion.hpp"
#include "engine/law/facet.hpp"
#include "engine/state/pair_slots.hpp"
#include "engine/step/bond_rows.hpp"
#include "engine/step/tile.hpp"

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

/// A few rows of what does not change.
struct FacetTiles {
    explicit FacetTiles(const FacetRows& rows)
        : length(rows.length), inverse_length(rows.inverse_length), share_i(rows.share_i), area(rows.area),
          centre(rows.centre) {}

    Tile length, inverse_length, share_i, area, centre;
};

/// Where some of these rows begin, the first of them row `begin`.
struct FacetTilePlaces {
    std::size_t begin;
    const double *length, *inverse_length, *share_i, *area, *centre;
};

template <class Lane>
FacetTilePlaces places_of(FacetTiles& tiles, std::size_t begin, std::size_t end) {
    return {begin,
            tiles.length.rows<Lane>(begin, end),
            tiles.inverse_length.rows<Lane>(begin, end),
            tiles.share_i.rows<Lane>(begin, end),
            tiles.area.rows<Lane>(begin, end),
            tiles.centre.rows<Lane>(begin, end)};
}

template <class Lane>
DEMLUA_INLINE FacetParts<typename Lane::Number> parts_of(const FacetRows& rows, const FacetTilePlaces& tiles,
                                                         std::size_t at) {
    using T = typename Lane::Number;
    const std::size_t k = tiles.begin + at;
    if (Lane::any_marked(rows.walled + k)) [[unlikely]] {
        return {loaded_members<Lane, law::FacetSprings<T>>(rows.springs, k),
                loaded_members<Lane, law::FacetVector<T>>(rows.growth_i, k),
                loaded_members<Lane, law::FacetVector<T>>(rows.growth_j, k)};
    }
    const T area = Lane::load(tiles.area + at);
    const T centre = Lane::load(tiles.centre + at);
    const T per_length = Lane::load(tiles.inverse_length + at);
    const T s = Lane::load(tiles.share_i + at);
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
    FacetTiles tiles(rows);
    Tile Dxs(rows.Dx);
    Tile Dys(rows.Dy);
    std::array<TargetTile, 7> targets{TargetTile(rows.inverse_d), TargetTile(rows.normal_x), TargetTile(rows.normal_y),
                                      TargetTile(rows.stretch),   TargetTile(rows.shift),    TargetTile(rows.grown_i),
                                      TargetTile(rows.grown_j)};
    tile_by_tile(begin, end, [&](std::size_t first, std::size_t last) {
        const FacetTilePlaces read = places_of<Lane>(tiles, first, last);
        const double* Dx = Dxs.rows<Lane>(first, last);
        const double* Dy = Dys.rows<Lane>(first, last);
        std::array<double*, 7> to;
        for (std::size_t m = 0; m < to.size(); ++m) to[m] = targets[m].template rows<Lane>(first, last);
        for (std::size_t at = 0; at < last - first; at += Lane::width) {
            const std::size_t k = first + at;
            const typename Lane::Held held(rows.broken == nullptr ? nullptr : rows.broken + k);
            if (held.none()) continue;
            const Moved<T> i = displacements<Lane>(elements, rows.i + k);
            const Moved<T> j = displacements<Lane>(elements, rows.j + k);
            const EndMotions<T> ends = end_motions(i, j, held, Lane::load(read.share_i + at));
            const law::BondMotion<T> motion =
                law::bond_motion({Lane::load(Dx + at), Lane::load(Dy + at)}, Lane::load(read.length + at),
                                 Lane::load(read.inverse_length + at), ends.du, ends.turn);
            const Vector q = elastic_part<Lane>(rows, k, motion.stretch, motion.shear, j.turn - i.turn);
            const FacetParts<T> parts = parts_of<Lane>(rows, read, at);
            const std::array<T, 7> found{motion.inverse_length,
                                         motion.normal.x,
                                         motion.normal.y,
                                         motion.stretch,
                                         motion.shear,
                                         held(dot(parts.growth_i, q)),
                                         held(dot(parts.growth_j, q))};
            for (std::size_t m = 0; m < to.size(); ++m) Lane::store(to[m] + at, found[m]);
        }
        for (TargetTile& target : targets) target.template keep<Lane>(first, last);
    });
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
    FacetTiles tiles(rows);
    TargetTile inverse_ds(rows.inverse_d);
    TargetTile normals_x(rows.normal_x);
    TargetTile normals_y(rows.normal_y);
    TargetTile stretches(rows.stretch);
    TargetTile shifts(rows.shift);
    tile_by_tile(begin, end, [&](std::size_t first, std::size_t last) {
        const FacetTilePlaces read = places_of<Lane>(tiles, first, last);
        const double* inverse_d = inverse_ds.rows<Lane>(first, last);
        const double* normal_x = normals_x.rows<Lane>(first, last);
        const double* normal_y = normals_y.rows<Lane>(first, last);
        const double* stretch = stretches.rows<Lane>(first, last);
        const double* shift = shifts.rows<Lane>(first, last);
        for (std::size_t at = 0; at < last - first; at += Lane::width) {
            const std::size_t k = first + at;
            const typename Lane::Held held(rows.broken == nullptr ? nullptr : rows.broken + k);
            if (held.none()) continue;
            const Pressed<T> i = pressures<Lane>(rows, elements, rows.i + k);
            const Pressed<T> j = pressures<Lane>(rows, elements, rows.j + k);
            const Vector q =
                elastic_part<Lane>(rows, k, Lane::load(stretch + at), Lane::load(shift + at), j.turn - i.turn);
            const FacetParts<T> parts = parts_of<Lane>(rows, read, at);
            Vector force = parts.springs * q + i.pressure * parts.growth_i + j.pressure * parts.growth_j;
            if (rows.normal != nullptr) {
                Lane::store(rows.normal + k, held(force.normal));
                Lane::store(rows.shear + k, held(force.shear));
            }
            if constexpr (damped) {
                force.normal += Lane::load(rows.dashpot_normal + k);
                force.shear += Lane::load(rows.dashpot_shear + k);
            }
            const T s = Lane::load(read.share_i + at);
            const T couple = held(force.shear * Lane::load(read.length + at));
            const T bending = held(force.turn);
            const Vector2<T> n{Lane::load(normal_x + at), Lane::load(normal_y + at)};
            put_force<Lane>(rows, k, n, Lane::load(inverse_d + at), held(force.normal), couple, couple * s + bending,
                            couple * (1.0 - s) - bending);
        }
    });
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
