// Facet springs and one pressure per cell: a pack of any shape that is elastically exact.
//
// The plane is shared out in cells. Across the facet of length A between the elements i and j, a bond's length l apart:
//
//   q = (e, ut, w)                      stretch and shear displacement of bond_motion, w = theta_j - theta_i
//   dn = e - c w,   dt = ut             how far the facet's midpoint opens and slides; c its place along t, 0 on the bond
//   D_i = sum A (s_i e + c (ut/l - s_i w)),   D_j = sum A (s_j e - c (ut/l + s_j w))       growth of the cells, m^2
//   U = sum_facets b (2G A/l) (dn^2 + dt^2 + A^2/12 w^2)/2 + sum_cells b lam D^2/(2 V)
//   2G = E*/(1 + nu*),   lam = E* nu*/(1 - nu*^2)
//   p = b lam D/V,   normal force = (2G b A/l) dn + A (s_i p_i + s_j p_j),   shear = (2G b A/l) dt + (A c/l) (p_i - p_j)
//
// b thickness, V area of the cell, s_i, s_j shares of l on either side of the facet. In a uniform field the forces are the
// Cauchy tractions times A b on any pack, for any nu* below 1: neither E nor nu is fitted. So are the moments, for in D each
// cell reads the shear of its facets from the turn of the element beyond, phi - theta_j = ut/l - s_i w: the moment of a
// pressure p at a facet is then -A c p, that of the traction. Read from its own turn it would be +A c p, which a closed cell
// does not see (its A c add up to zero) but a cell at a wall does.
//
// A facet that ends on a free wall is split where the bond's line crosses it. The part beyond, A_out long and c_out from
// the bond's line, is a bar along the wall's tangent T of Young's modulus E*:
//
//   U += (E* b A_out/l) (T_n (e - c_out w) + T_t ut)^2/2 + (E* b A_out^3/(12 l)) (T_n w)^2/2
//
// D is counted over the parts on this side of the bond's line alone, and V is what makes p right under a pull along the wall:
// with M = sum A n (x - x_i)' over these parts, x their middles, and N the wall's normal,
//
//   V = (T'MT - nu* N'MN)/(1 - nu*);      V = tr(M)/2, the cell's area, for a cell without wall or in a corner.
//
// A uniform stress along a straight free wall is then in equilibrium however the elements stand beside it, moments included.
// Where the bond's line misses its facet (a third element stands between the two, nearer to the inside), the part within has
// a negative length and K may be negative across the pull. What is kept of it then is K's answer f = K q to that pull and
// what it has left against turning,
//
//   K := f f'/(q'f) + max(0, K_ww - f_w^2/(q'f)) ww',   q = l (n.s.n, t.s.n, 0) with s = T T' - nu* N N'.
//
// Source: derived from the divergence theorem for cells, as their growth under a uniform strain is V tr(strain).
// Limits: small strains within a cell; springs of one sign only, so U is never negative whatever is broken. V of a wall's cell
// is kept between 1/4 and 4 times tr(M)/2, so that no cell is all but without volume: beyond nu* = 0.5, which plane strain
// alone has, some cells are at this bound and a pull along their wall leaves them out of balance.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/law/stiffness.hpp"

#include <algorithm>
#include <array>

namespace demlua::law {

/// Stretch (m), shear displacement (m) and turn of j against i (rad) of a bond; or what does work on them: normal and
/// shear force (N) and bending moment (N m); or how fast a cell grows with each (m, m, m^2).
template <class T>
struct FacetVector {
    T normal{};
    T shear{};
    T turn{};
    static constexpr std::array<T FacetVector::*, 3> members{&FacetVector::normal, &FacetVector::shear,
                                                             &FacetVector::turn};

    friend FacetVector operator+(FacetVector a, FacetVector b) {
        return {a.normal + b.normal, a.shear + b.shear, a.turn + b.turn};
    }
    friend FacetVector operator*(T s, FacetVector a) { return {s * a.normal, s * a.shear, s * a.turn}; }
};

template <class T>
T dot(FacetVector<T> a, FacetVector<T> b) {
    return a.normal * b.normal + a.shear * b.shear + a.turn * b.turn;
}

/// Symmetric stiffness of a bond against q.
template <class T>
struct FacetSprings {
    T nn{}, nt{}, tt{}; ///< N/m
    T nw{}, tw{};       ///< N
    T ww{};             ///< N m
    static constexpr std::array<T FacetSprings::*, 6> members{&FacetSprings::nn, &FacetSprings::nt, &FacetSprings::tt,
                                                              &FacetSprings::nw, &FacetSprings::tw, &FacetSprings::ww};

    friend FacetVector<T> operator*(const FacetSprings& K, FacetVector<T> q) {
        return {K.nn * q.normal + K.nt * q.shear + K.nw * q.turn, K.nt * q.normal + K.tt * q.shear + K.tw * q.turn,
                K.nw * q.normal + K.tw * q.shear + K.ww * q.turn};
    }
    /// Adds the energy k (g.q)^2/2.
    void add(T k, FacetVector<T> g) {
        nn += k * g.normal * g.normal;
        nt += k * g.normal * g.shear;
        tt += k * g.shear * g.shear;
        nw += k * g.normal * g.turn;
        tw += k * g.shear * g.turn;
        ww += k * g.turn * g.turn;
    }
};

/// A stretch of facet, measured along t.
struct FacetPart {
    double area = 0.0;   ///< its length, m
    double centre = 0.0; ///< of its midpoint, from the bond's line, m
};

/// The moduli facets are made of, Pa.
struct FacetModuli {
    double twice_shear = 0.0; ///< 2G
    double lame = 0.0;        ///< lam
    double youngs = 0.0;      ///< E*, of the bars along free walls
    double ratio = 0.0;       ///< nu*, a pure number
};

/// nu* below 1: any material in plane stress, nu below 1/2 in plane strain.
constexpr FacetModuli facet_moduli(PlaneModuli plane) {
    const double nu = plane.poissons_ratio;
    return {plane.youngs_modulus / (1.0 + nu), plane.youngs_modulus * nu / (1.0 - nu * nu), plane.youngs_modulus, nu};
}

/// Springs of a facet, or of the part of one that lies inside the body; `twice_shear` is 2G b in N/m.
template <class T>
FacetSprings<T> facet_springs(double twice_shear, T area, T centre, T inverse_length) {
    const T k = twice_shear * area * inverse_length;
    return {k, T{}, k, -(k * centre), T{}, k * (centre * centre) + k * (area * area) * (1.0 / 12.0)};
}

/// Adds the bar that stands for the part between the bond's line and a free wall, whose unit tangent has the components
/// `along_n` and `along_t`.
inline void add_wall_bar(FacetSprings<double>& springs, const FacetModuli& moduli, FacetPart part, double along_n,
                         double along_t, double length, double thickness) {
    const double k = moduli.youngs * thickness * part.area / length;
    springs.add(k, {along_n, along_t, -along_n * part.centre});
    springs.add(k * part.area * part.area / 12.0, {0.0, 0.0, along_n});
}

/// Growth of the cell of i with q, through a facet or a part of one; share_i that of i in the length.
template <class T>
FacetVector<T> growth_of_i(T area, T centre, T inverse_length, T share_i) {
    const T couple = area * centre;
    return {area * share_i, couple * inverse_length, -(couple * share_i)};
}

/// The same of the cell of j.
template <class T>
FacetVector<T> growth_of_j(T area, T centre, T inverse_length, T share_i) {
    const T couple = area * centre;
    return {area * (1.0 - share_i), -(couple * inverse_length), -(couple * (1.0 - share_i))};
}

/// Springs that are never negative and answer `pull` (a q without turn) as K does.
inline FacetSprings<double> answering(const FacetSprings<double>& K, FacetVector<double> pull) {
    const FacetVector<double> f = K * pull;
    const double work = dot(pull, f);
    FacetSprings<double> springs;
    if (work <= 0.0) return springs;
    springs.add(1.0 / work, f);
    springs.ww = std::max(springs.ww, K.ww);
    return springs;
}

} // namespace demlua::law
