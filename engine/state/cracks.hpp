// Bonds that have broken: where, when, how and at what cost.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/state/bonds.hpp"
#include "engine/state/elements.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace demlua::state {

enum class CrackMode : std::int32_t {
    tension = 0, ///< the bond opened more than it slid
    shear = 1,
    notch = 2, ///< cut, not broken
    wear = 3   ///< of an element that left its cluster
};

/// One broken bond, as it was at that instant.
struct Crack {
    std::size_t body = 0;
    Index bond = 0; ///< row of the body's bonds
    Index i = 0;    ///< rows of elements, i < j
    Index j = 0;
    std::array<Vec2, 2> ends; ///< the crack's piece across the bond, as crack_across gives it, m
    double time = 0.0;        ///< s
    std::uint64_t step = 0;
    CrackMode mode = CrackMode::tension;
    double energy = 0.0; ///< plastic work of the bond and what it still held; zero for a notch, J
};

/// The length of crack that bond k makes, and where its middle lies along t from the bond's line: across a pair the mean
/// diameter, else the facet.
template <class Law>
law::FacetPart crack_part(const BondSet<Law>& bonds, std::size_t k) {
    return {2.0 * bonds.radius[k], 0.0};
}

template <class Law>
law::FacetPart crack_part(const FacetSet<Law>& bonds, std::size_t k) {
    return {bonds.area[k], bonds.centre[k]};
}

/// The ends (m) of the crack that bond k makes, square to the line that leads from `at_i` along `span` to the other element, where
/// the shares of both meet; the second end lies towards t.
template <class Bonds>
std::array<Vec2, 2> crack_across(const Bonds& bonds, std::size_t k, Vec2 at_i, Vec2 span) {
    const law::FacetPart part = crack_part(bonds, k);
    const Vec2 t = turned_left(span) / norm(span);
    const Vec2 foot = at_i + bonds.share_i[k] * span;
    return {foot + (part.centre - 0.5 * part.area) * t, foot + (part.centre + 0.5 * part.area) * t};
}

/// Bond k as a crack of this instant, by `time` (s) and `step`.
template <class Bonds>
Crack crack_of(const Bonds& bonds, const Elements& elements, std::size_t k, double time, std::uint64_t step) {
    const Index i = bonds.i[k];
    const Index j = bonds.j[k];
    Crack crack;
    crack.body = bonds.body;
    crack.bond = static_cast<Index>(k);
    crack.i = i;
    crack.j = j;
    crack.ends = crack_across(bonds, k, elements.position(i), span_of(bonds, elements, k));
    crack.time = time;
    crack.step = step;
    return crack;
}

} // namespace demlua::state
