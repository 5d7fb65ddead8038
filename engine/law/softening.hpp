// Elastic to the caps that a strength sets; these then fall to nothing while the fracture energy is spent.
//
//   fn <= q fn_crit in tension, |ft| <= q ft_crit both ways (law/strength_caps.hpp); unloading with Kn and Kt
//   q = 1 - ep/(2 opening) - sp/(2 slip)            ep plastic stretch, sp length of the path of plastic shear; broken at q = 0
//
// Under a growing stretch alone that is the triangle of Tavarez & Plesha 2007, figure 16: up to fn_crit at fn_crit/Kn, then
// straight down to zero at d_max = 2 G 2Rt/fn_crit, with the area G 2Rt. The figure shows the normal direction only. Here
// the shear curve is of the same kind, with the same area, since the paper takes the fracture energy to be independent of
// the mode (before its eq. 31), and both caps fall together: while a bond yields its plastic work grows by
//
//   dW = q fn_crit d(ep) + q ft_crit d(sp) = -2 G 2Rt q dq,   so that W = G 2Rt (1 - q^2) on any path
//
// and a bond broken by any mixture of stretch and shear has spent G 2Rt. On facets G A t.
//
// Limits: the energy stored when both caps are reached must not exceed G 2Rt (beyond, the curve would fall back);
// compression never yields in the normal direction; bonds cut per crack area as for the plateau.
#pragma once

#include "engine/law/bond_motion.hpp"
#include "engine/law/strength_caps.hpp"

#include <array>

namespace demlua::law {

struct Softening {
    static constexpr const char* name = "softening";
    static constexpr bool breaks = true;
    static constexpr bool yields = true;
    static constexpr bool wakes = false;

    using Params = StrengthCaps;
    using Tractions = FacetCaps;

    template <class T>
    struct History {
        T stretch{}; ///< plastic stretch, m
        T shear{};   ///< plastic shear displacement, m
        T work{};    ///< plastic work, J
        T lost{};    ///< share of the strength that is gone, 1 - q
        static constexpr std::array<T History::*, 4> members{&History::stretch, &History::shear, &History::work,
                                                             &History::lost};
    };

    static constexpr Params on_facet(const Tractions& p, ContactStiffness k, double A, double /*radius*/) {
        return law::on_facet(p, k, A);
    }

    /// The radius at which the energy stored at both caps has come up to G 2Rt, m.
    static constexpr double largest_radius(const Params& p) {
        return 1.0 / (0.5 * p.stretch_per_radius / p.opening + 0.5 * p.shear_per_radius / p.slip);
    }

    /// With x and y the elastic displacements before yielding, over 2 opening and 2 slip, and a and b those at the first
    /// caps, q is the root of q - q0 + max(0, x - q a) + max(0, |y| - q b) = 0. The left side is the largest of four
    /// straight lines that all rise, so its root is the smallest of theirs.
    template <class T>
    static BondForce<T> respond(const Params& p, T radius, const BondMotion<T>& motion, History<T>& history) {
        const T per_opening = T{0.5 / p.opening};
        const T per_slip = T{0.5 / p.slip};
        const T first_stretch = p.stretch_per_radius * radius;
        const T first_shear = p.shear_per_radius * radius;
        const T stretch = motion.stretch - history.stretch;
        const T shear = motion.shear - history.shear;
        const T x = stretch * per_opening;
        const T y = magnitude(shear) * per_slip;
        const T a = first_stretch * per_opening;
        const T b = first_shear * per_slip;
        const T left = 1.0 - history.lost;
        const T one_way = smaller((left - x) / (1.0 - a), (left - y) / (1.0 - b));
        const T both_ways = (left - x - y) / (1.0 - a - b);
        const T q = larger(T{}, smaller(left, smaller(one_way, both_ways)));

        const T held_stretch = smaller(stretch, q * first_stretch);
        const T held_shear = clamped(shear, q * first_shear);
        history.stretch += stretch - held_stretch;
        history.shear += shear - held_shear;
        history.work += p.Kn * first_stretch * p.opening * (left * left - q * q);
        history.lost = select(q < left, 1.0 - q, history.lost);
        return {p.Kn * held_stretch, p.Kt * held_shear};
    }

    template <class T>
    static auto has_yielded(const History<T>& before, const History<T>& now) {
        return now.lost > before.lost;
    }

    template <class T>
    static auto broken(const Params& /*p*/, T /*radius*/, const BondMotion<T>& /*motion*/, const History<T>& history) {
        return history.lost >= 1.0;
    }

    /// Whether a facet of length A (m) may yield or break under `force` (N): said too often rather than too seldom.
    template <class T>
    static auto may_fail(const Tractions& p, T A, T /*radius*/, const BondForce<T>& force, const History<T>& history) {
        return may_pass(p, (1.0 - history.lost) * A, force);
    }

    /// Greatest tension and greatest shear force that the bond bears now, N.
    template <class T>
    static BondForce<T> caps(const Params& p, T radius, const History<T>& history) {
        const T left = 1.0 - history.lost;
        return {left * (p.Kn * p.stretch_per_radius * radius), left * (p.Kt * p.shear_per_radius * radius)};
    }

    /// Share of the strength that is gone, 0 to 1.
    template <class T>
    static T damage(const Params& /*p*/, T /*radius*/, const History<T>& history) {
        return history.lost;
    }

    template <class T>
    static T stored_energy(const Params& p, const BondMotion<T>& motion, const History<T>& history) {
        const T e = motion.stretch - history.stretch;
        const T ut = motion.shear - history.shear;
        return 0.5 * (p.Kn * e * e + p.Kt * ut * ut);
    }
};

} // namespace demlua::law
