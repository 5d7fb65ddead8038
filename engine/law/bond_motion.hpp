// How far a bonded pair has stretched and slipped since bonding, in total form.
//
//   e  = d - l                                      stretch
//   ut = l (phi - s_i theta_i - s_j theta_j)        shear displacement
//
// l length at bonding, d length now, phi angle the bond has turned since, theta rotation of the elements,
// s_i = R_i/(R_i+R_j), s_i + s_j = 1. A rigid turn of the pair by any number of revolutions gives e = ut = 0, and the
// forces derived from an energy U(e, ut) keep linear and angular momentum exactly:
//
//   on i: fn n + (ft l/d) t,  moment ft l s_i;   on j: the opposite force, moment ft l s_j;   fn = U_e, ft = U_ut.
//
// n from i to j, t = n turned +90 degrees. Source: derived from the energy; compare Tavarez & Plesha 2007, figure 1.
// Limit: the shear angle phi - s_i theta_i - s_j theta_j stays within half a turn.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/base/vec2.hpp"

#include <numbers>

namespace demlua::law {

template <class T>
struct BondMotion {
    T inverse_length;  ///< 1/d, 1/m
    Vector2<T> normal; ///< n
    T stretch;         ///< e, m
    T shear;           ///< ut, m
};

/// Any motion: what bond_motion takes for large ones.
template <class T>
BondMotion<T> large_motion(Vector2<T> D, T l, Vector2<T> du, T turn) {
    const Vector2<T> span = D + du;
    const T d = square_root(dot(span, span));
    const T along = dot(D, du);
    const T inverse_d = 1.0 / d;
    const T shear_angle = angle_of(l * l + along, cross(D, du)) - turn;
    const T revolutions = nearest_whole(shear_angle * (0.5 / std::numbers::pi));
    return {inverse_d, inverse_d * span, (along + along + dot(du, du)) / (d + l),
            l * (shear_angle - revolutions * (2.0 * std::numbers::pi))};
}

/// `D` the bond's vector at bonding (i to j, length l, inverse_l = 1/l), `du` how much farther j has moved than i: the
/// difference of displacements, so that a small stretch is not lost in large coordinates. `turn` = s_i theta_i + s_j theta_j.
template <class T>
DEMLUA_INLINE BondMotion<T> bond_motion(Vector2<T> D, T l, T inverse_l, Vector2<T> du, T turn) {
    const T per_square = inverse_l * inverse_l;
    const T along = dot(D, du);
    const T growth = (along + along + dot(du, du)) * per_square;
    const T strain = root_growth(growth);
    const T inverse_d = inverse_l * inverse_growth(strain);
    const T sine = cross(D, du) * (inverse_l * inverse_d);
    const T shear_angle = angle_of_small(sine) - turn;
    BondMotion<T> motion{inverse_d, inverse_d * (D + du), l * strain, l * shear_angle};

    const auto large = either(either(magnitude(growth) > small_growth, magnitude(sine) > small_sine),
                              either(along * per_square<-0.5, magnitude(shear_angle)> 1.0));
    if (any(large)) [[unlikely]] {
        const BondMotion<T> exact = large_motion(D, l, du, turn);
        motion = {select(large, exact.inverse_length, motion.inverse_length),
                  {select(large, exact.normal.x, motion.normal.x), select(large, exact.normal.y, motion.normal.y)},
                  select(large, exact.stretch, motion.stretch),
                  select(large, exact.shear, motion.shear)};
    }
    return motion;
}

/// Forces in a bond: tension and positive shear stretch are positive, N.
template <class T>
struct BondForce {
    T normal;
    T shear;
};

} // namespace demlua::law
