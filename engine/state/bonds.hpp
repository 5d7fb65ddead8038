// Bonds of one body under one law, in columns.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/number_column.hpp"
#include "engine/law/facet.hpp"
#include "engine/law/laws.hpp"
#include "engine/state/bands.hpp"
#include "engine/state/elements.hpp"
#include "engine/state/history.hpp"
#include "engine/state/lane_sums.hpp"
#include "engine/state/pair_forces.hpp"
#include "engine/state/pair_slots.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <variant>

namespace demlua::state {

/// Dashpots beside the springs; empty columns when the bonds have none.
struct BondDashpots {
    NumberColumn Cn, Ct;          ///< N s/m
    Column<double> normal, shear; ///< dashpot forces at the last instant, N
    LaneSums spent;               ///< by the rows, J

    [[nodiscard]] bool present() const { return !Cn.empty(); }
};

/// In the column `broken`: what holds is 0, what is broken 1, and this what is to break at the present instant.
inline constexpr std::uint8_t failing = 2;

/// What all bonds have, whatever holds them.
template <class Law>
struct BondTable {
    using History = typename Law::template History<double>;
    using law = Law;

    std::size_t body = 0;

    Column<Index> i, j;          ///< rows of elements, i < j
    NumberColumn Dx, Dy;         ///< from i to j at bonding, m
    NumberColumn length;         ///< of D, m
    NumberColumn inverse_length; ///< 1/m
    NumberColumn share_i;        ///< of the length that belongs to i
    NumberColumn radius;         ///< mean of the two, m
    LazyHistoryColumns<History> history;
    bool remembers = false; ///< whether any row of `history` may be other than zero
    BondDashpots dashpots;

    PairForces forces; ///< with a row of zeros after the last, for `slots`

    // Only where neighbouring bonds are not of neighbouring elements: of each element of the body four numbers that stand
    // together, so that one looked up costs one line of memory.
    Column<double> moved;  ///< displacement, m, rotation, and the pressure of its cell, if there is one
    Column<double> speeds; ///< velocity, m/s, and spin; empty without dashpots

    // only for laws that break
    Column<std::uint8_t> broken;
    Column<double>
        contact_length;         ///< reference length of the contact a broken bond leaves, m; empty while none is broken
    Column<double> break_time;  ///< s; infinite for a bond cut before the start; empty while none is broken
    double fracture_work = 0.0; ///< stored in bonds when they broke, J
    std::size_t broken_count = 0;

    PairSlots slots;

    [[nodiscard]] std::size_t size() const { return i.size(); }
    /// Marks `bond` as broken at `when`; the contact it leaves has the reference length `reference`.
    void note_break(std::size_t bond, double when, double reference) {
        contact_length.resize(size());
        break_time.resize(size(), std::numeric_limits<double>::infinity());
        broken[bond] = 1;
        ++broken_count;
        contact_length[bond] = reference;
        break_time[bond] = when;
        forces.set(bond, {});
    }
    /// What a row is read for at every step, in single precision from now on: all but what bonds remember.
    void keep_single() {
        for (NumberColumn* column : {&Dx, &Dy, &length, &inverse_length, &share_i, &radius}) {
            if (!column->even()) column->keep_single();
        }
        forces.keep_single();
    }
    void remember(std::size_t bond, const History& past) {
        history.store(bond, past);
        remembers = true;
    }
    [[nodiscard]] bool is_broken(std::size_t bond) const {
        if constexpr (Law::breaks) return broken[bond] != 0;
        return false;
    }
};

/// From i to j of bond k now, m; across the edge of a plane that repeats too.
template <class Law>
Vec2 span_of(const BondTable<Law>& bonds, const Elements& elements, std::size_t k) {
    const Vec2 moved = elements.displacement(bonds.j[k]) - elements.displacement(bonds.i[k]);
    return Vec2{bonds.Dx[k], bonds.Dy[k]} + moved;
}

/// Bonds between pairs of elements, alike but for their radii.
template <class Law>
struct BondSet : BondTable<Law> {
    typename Law::Params params;
};

/// Motions of bonds (law/bond_motion.hpp), in columns.
struct MotionColumns {
    NumberColumn inverse_length, normal_x, normal_y, stretch, shear;

    [[nodiscard]] std::array<NumberColumn*, 5> all() {
        return {&inverse_length, &normal_x, &normal_y, &stretch, &shear};
    }
    [[nodiscard]] law::BondMotion<double> operator[](std::size_t k) const {
        return {inverse_length[k], {normal_x[k], normal_y[k]}, stretch[k], shear[k]};
    }
};

/// Bonds across the facets of cells, with one pressure per cell (law/facet.hpp).
template <class Law>
struct FacetSet : BondTable<Law> {
    typename Law::Tractions tractions;
    Column<std::uint8_t> walled; ///< 1 where a facet ends on a free wall; where none does, area and centre say it all
    StructColumns<law::FacetSprings<double>> springs;
    StructColumns<law::FacetVector<double>> growth_i, growth_j; ///< of the cells of i and j with q
    NumberColumn area;                                          ///< of the facet, m
    NumberColumn centre;                                        ///< of the facet, from the bond's line along t, m
    double twice_shear = 0.0;                                   ///< 2G b of the body, N/m
    Column<double> pressure_per_growth; ///< b lam/V of each cell, N/m^3; rows from the body's first element on

    Bands bands; ///< in which a step's two passes follow each other

    // as computed in the first of the two passes of a step
    MotionColumns motion;
    NumberColumn grown_i, grown_j; ///< growth_i.q, growth_j.q, m^2; a row of zeros after the last, for `slots`
    Column<double> pressure;       ///< p of each cell, N/m

    // only for laws that break
    Column<double> normal, shear;               ///< forces at this instant, dashpots left out, N
    Column<double> normal_before, shear_before; ///< at the instant before
    Column<std::uint8_t> suspect;               ///< rows that may yield or break at this instant
    Column<law::ContactStiffness> yielding;     ///< what a facet meets that yields with all its neighbours, N/m

    void keep_single() {
        BondTable<Law>::keep_single();
        for (NumberColumn* column : {&area, &centre, &grown_i, &grown_j}) column->keep_single();
        for (NumberColumn* column : motion.all()) column->keep_single();
    }
};

using AnyBondSet = law::ForEachBondLaw<BondSet, FacetSet, std::variant>;

} // namespace demlua::state
