// Stress of a cell from the forces on its facets.
//
//   sigma = (1/V) sum over facets of  f (x) r,   the symmetric part; tension positive
//
// f force on the element, r from its centre to the facet's middle, V the cell's volume. Source: mean stress of a body loaded at
// points (e.g. Christoffersen, Mehrabadi & Nemat-Nasser 1981).
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/state/bonds.hpp"

#include <cmath>
#include <cstddef>

namespace demlua::step {

/// V sigma, N m; or, divided by a volume, Pa.
struct PlaneStress {
    double xx = 0.0, yy = 0.0, xy = 0.0;

    void add(Vec2 force, Vec2 arm) {
        xx += force.x * arm.x;
        yy += force.y * arm.y;
        xy += 0.5 * (force.x * arm.y + force.y * arm.x);
    }
    friend PlaneStress operator+(PlaneStress a, PlaneStress b) { return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy}; }
    friend PlaneStress operator*(double s, PlaneStress a) { return {s * a.xx, s * a.yy, s * a.xy}; }
    /// The larger principal stress.
    [[nodiscard]] double tension() const { return 0.5 * (xx + yy) + std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy); }
};

/// From the elements of a bond to the middle of its facet, m.
struct FacetArms {
    Vec2 of_i, of_j;
};

template <class Law>
FacetArms facet_arms(const state::FacetSet<Law>& bonds, std::size_t k, Vec2 normal, double length) {
    const Vec2 span = length * normal;
    const Vec2 aside = bonds.centre[k] * turned_left(normal);
    return {bonds.share_i[k] * span + aside, (bonds.share_i[k] - 1.0) * span + aside};
}

} // namespace demlua::step
