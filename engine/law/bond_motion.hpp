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

/// Any motion, where series do not reach.
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

/// Below this, and b below small_slope, (d/l)^2 - 1 is below small_growth.
inline constexpr double small_stretch = 1.5e-3;

/// By series in a and b, du over l along D and across it, in a frame in which the elements have turned by `turn`:
/// (d/l)^2 = (1 + a)^2 + b^2 and tan phi = b/(1 + a). `large` says where these do not reach.
template <class T, class Mask>
DEMLUA_INLINE BondMotion<T> motion_by_series(Vector2<T> D, T l, T inverse_l, Vector2<T> du, T turn, Mask& large) {
    const T per_square = inverse_l * inverse_l;
    const T a = dot(D, du) * per_square;
    const T b = cross(D, du) * per_square;
    const T strain = root_growth((a + a) + (a * a + b * b));
    const T shear_angle = angle_of_small(b * inverse_growth(a)) - turn;
    const T inverse_d = inverse_l * inverse_growth(strain);
    large = either(either(magnitude(a) > small_stretch, magnitude(b) > small_slope), magnitude(shear_angle) > 1.0);
    return {inverse_d, inverse_d * (D + du), l * strain, l * shear_angle};
}

template <class T, class Mask>
DEMLUA_INLINE BondMotion<T> select_motion(Mask mask, const BondMotion<T>& yes, const BondMotion<T>& no) {
    return {select(mask, yes.inverse_length, no.inverse_length),
            {select(mask, yes.normal.x, no.normal.x), select(mask, yes.normal.y, no.normal.y)},
            select(mask, yes.stretch, no.stretch),
            select(mask, yes.shear, no.shear)};
}

/// What has turned far, as fragments do, by series in a frame that turns with it; what is left exactly.
template <class T>
BondMotion<T> turned_motion(Vector2<T> D, T l, T inverse_l, Vector2<T> du, T turn) {
    const Rotation<T> by = rotation_by(turn);
    const Vector2<T> turned{by.cosine * D.x - by.sine * D.y, by.sine * D.x + by.cosine * D.y};
    decltype(l > l) large;
    BondMotion<T> motion = motion_by_series(turned, l, inverse_l, (D + du) - turned, T{}, large);
    if (any(large)) motion = select_motion(large, large_motion(D, l, du, turn), motion);
    return motion;
}

/// `D` the bond's vector at bonding (i to j, length l, inverse_l = 1/l), `du` how much farther j has moved than i: the
/// difference of displacements, so that a small stretch is not lost in large coordinates. `turn` = s_i theta_i + s_j theta_j.
template <class T>
DEMLUA_INLINE BondMotion<T> bond_motion(Vector2<T> D, T l, T inverse_l, Vector2<T> du, T turn) {
    decltype(l > l) large;
    BondMotion<T> motion = motion_by_series(D, l, inverse_l, du, turn, large);
    if (any(large)) [[unlikely]]
        motion = select_motion(large, turned_motion(D, l, inverse_l, du, turn), motion);
    return motion;
}

/// Forces in a bond: tension and positive shear stretch are positive, N.
template <class T>
struct BondForce {
    T normal;
    T shear;
};

} // namespace demlua::law
