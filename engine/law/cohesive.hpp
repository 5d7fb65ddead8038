// Facets that wake where the material has reached its tensile strength and then let go while the fracture energy of the
// crack they open is spent. For facets alone (law/facet.hpp), whose forces are true tractions.
//
//   dormant (cap = 0)   elastic
//   wakes               at a settled instant with fn > 0, when
//                         |f+| >= 0.4 s A t  and  s1 >= s,  s1 the larger principal stress of the mean of its two cells, or
//                         fn >= 1.5 s A t;
//                       then cap = |f+| of that instant
//   awake               |f+| <= q cap                     fn >= 0
//                       |ft| <= q cap + mu |fn|           fn < 0; the pressure itself has no limit
//                       q = sqrt(1 - D),  D = W/(G A t c) and never falling,  c = max(w_n/|w|, 0.3)
//   broken              D = 1
//
// f+ = (max(fn, 0), ft), s tensile strength, G fracture energy, A length of the facet, t thickness, w = (w_n, w_t) plastic
// displacements, which grow along f+, W their work. A strain-rate factor f stands for s -> f s, G -> f G.
// With c = w_n/|w| a facet opened along w owes G A t cos(angle of w and n), and the facets that a crack cuts owe together
// G t times the crack's length, whatever their directions. Source and limits: docs/theory/cohesive.md.
#pragma once

#include "engine/law/bond_motion.hpp"
#include "engine/law/stiffness.hpp"

#include <array>

namespace demlua::law {

struct Cohesive {
    static constexpr const char* name = "cohesive";
    static constexpr bool breaks = true;
    static constexpr bool yields = true;
    static constexpr bool wakes = true;

    static constexpr double least_share = 0.4; ///< of s A t: below it a facet does not wake
    static constexpr double lone_share =
        1.5; ///< of s A t: a tension from which on a facet wakes whatever its cells bear
    static constexpr double least_cosine = 0.3; ///< least c

    struct Params {
        double Kn = 0.0;       ///< N/m
        double Kt = 0.0;       ///< N/m
        double strength = 0.0; ///< s A t, N
        double energy = 0.0;   ///< G A t, J
        double mu = 0.0;       ///< friction coefficient
    };

    struct Tractions {
        double strength = 0.0; ///< s t, N/m
        double energy = 0.0;   ///< G t, J/m
        double mu = 0.0;
    };

    template <class T>
    struct History {
        T stretch{}; ///< plastic stretch w_n, m
        T shear{};   ///< plastic shear displacement w_t, m
        T work{};    ///< plastic work W, J
        T damage{};  ///< D
        T cap{};     ///< |f+| when it woke, N; 0 while dormant
        static constexpr std::array<T History::*, 5> members{&History::stretch, &History::shear, &History::work,
                                                             &History::damage, &History::cap};
    };

    /// `strength` in Pa, `toughness` in Pa m^0.5, `thickness` in m.
    static constexpr Tractions derive_tractions(PlaneModuli plane, double thickness, double strength, double toughness,
                                                double rate_factor, double friction) {
        return {rate_factor * strength * thickness, rate_factor * fracture_energy(toughness, plane) * thickness,
                friction};
    }

    /// To be used with a radius of 1.
    static constexpr Params on_facet(const Tractions& p, ContactStiffness k, double A, double /*radius*/) {
        return {k.normal, k.shear, p.strength * A, p.energy * A, p.mu};
    }

    /// The length of a bond at which the steepest descent of a facet that its cells wake, (s A t)^2/(2 * 0.3 G A t), has come
    /// up to the least stiffness against it; `p` of a facet of a body's own stiffness (Kt: 2G t), 1 m long. In m.
    static constexpr double largest_radius(const Params& p) {
        return 2.0 * least_cosine * p.energy * p.Kt / (p.strength * p.strength);
    }

    /// |f+|, N.
    template <class T>
    static T pull(const BondForce<T>& force) {
        const T opening = larger(T{}, force.normal);
        return square_root(opening * opening + force.shear * force.shear);
    }

    /// Whether a dormant facet of length A may wake, by its own force.
    template <class T>
    static auto may_wake(const Tractions& p, T A, const BondForce<T>& force) {
        return both(force.normal > 0.0, pull(force) >= least_share * p.strength * A);
    }

    /// How far one that may has come to it: 1 when it wakes. `tension`: larger principal stress of the mean of its cells,
    /// times t, N/m.
    static double waking(const Tractions& p, double A, BondForce<double> force, double tension) {
        return larger(tension / p.strength, force.normal / (lone_share * p.strength * A));
    }

    /// Whether a facet may yield or break: only one that is awake.
    template <class T>
    static auto may_fail(const Tractions& /*p*/, T /*A*/, T /*radius*/, const BondForce<T>& /*force*/,
                         const History<T>& history) {
        return history.cap > 0.0;
    }

    /// c of a plastic displacement, or of the direction of one.
    template <class T>
    static T cosine(T stretch, T shear) {
        const T length = square_root(stretch * stretch + shear * shear);
        return length > 0.0 ? larger(T{least_cosine}, stretch / length) : T{1.0};
    }

    /// Brings D up to the work done.
    template <class T>
    static void wear(const Params& p, History<T>& history) {
        const T owed = p.energy * cosine(history.stretch, history.shear);
        history.damage = larger(history.damage, smaller(T{1.0}, history.work / owed));
    }

    /// Returns along f+ with the stiffness k = f+.K.f+/|f+|^2: with F = |f+| before yielding, N = mu |fn| under pressure,
    /// else 0, and x = q after it, the plastic displacement eta and its work by the mean of the forces at both ends are
    ///
    ///   eta = (F - N - x cap)/k,   G A t c (q^2 - x^2) = ((q + x) cap/2 + N) eta
    ///
    /// a quadratic in x. Where it has no root between 0 and q the facet falls back faster than it is held: x = 0. Left out:
    /// what f+ turns while it returns, as Kn and Kt differ, and what c changes meanwhile.
    template <class T>
    static BondForce<T> respond(const Params& p, T /*radius*/, const BondMotion<T>& motion, History<T>& history) {
        const BondForce<T> trial{p.Kn * (motion.stretch - history.stretch), p.Kt * (motion.shear - history.shear)};
        if (history.cap == 0.0) return trial;
        const T opening = larger(T{}, trial.normal);
        const T friction = p.mu * larger(T{}, -trial.normal);
        const T F = square_root(opening * opening + trial.shear * trial.shear);
        const T q = square_root(1.0 - history.damage);
        const T beyond = F - friction;
        if (!(beyond > q * history.cap)) return trial;

        const BondForce<T> along{opening / F, trial.shear / F};
        const T k = p.Kn * along.normal * along.normal + p.Kt * along.shear * along.shear;
        const bool fresh = history.stretch == 0.0 && history.shear == 0.0;
        const T c = fresh ? cosine(along.normal, along.shear) : cosine(history.stretch, history.shear);
        const T x = strength_after(q, history.cap, beyond, friction, k * p.energy * c);
        const T eta = (beyond - x * history.cap) / k;
        history.stretch += eta * along.normal;
        history.shear += eta * along.shear;
        history.work += (0.5 * (q + x) * history.cap + friction) * eta;
        wear(p, history);
        return {p.Kn * (motion.stretch - history.stretch), p.Kt * (motion.shear - history.shear)};
    }

    template <class T>
    static bool has_yielded(const History<T>& before, const History<T>& now) {
        return now.stretch != before.stretch || now.shear != before.shear;
    }

    template <class T>
    static bool broken(const Params& /*p*/, T /*radius*/, const BondMotion<T>& /*motion*/, const History<T>& history) {
        return history.damage >= 1.0;
    }

    /// Greatest tension and greatest shear force without the other, N; of a dormant facet, for both, the tension that wakes it
    /// whatever its cells bear.
    template <class T>
    static BondForce<T> caps(const Params& p, T /*radius*/, const History<T>& history) {
        const T bears = history.cap > 0.0 ? square_root(1.0 - history.damage) * history.cap : lone_share * p.strength;
        return {bears, bears};
    }

    /// Share of the fracture energy that is spent, 0 to 1.
    template <class T>
    static T damage(const Params& /*p*/, T /*radius*/, const History<T>& history) {
        return history.damage;
    }

    template <class T>
    static T stored_energy(const Params& p, const BondMotion<T>& motion, const History<T>& history) {
        const T e = motion.stretch - history.stretch;
        const T ut = motion.shear - history.shear;
        return 0.5 * (p.Kn * e * e + p.Kt * ut * ut);
    }

private:
    /// The root x of `respond`; `stiff` is k G A t c.
    template <class T>
    static T strength_after(T q, T cap, T beyond, T friction, T stiff) {
        const T begun = 0.5 * q * cap + friction;
        const T square = 0.5 * cap * cap - stiff;
        const T linear = cap * begun - 0.5 * cap * beyond;
        const T constant = stiff * q * q - begun * beyond;
        if (square >= 0.0 || constant <= 0.0) return T{};
        const T root = square_root(linear * linear - 4.0 * square * constant);
        return smaller(q, (linear + root) / (-2.0 * square));
    }
};

} // namespace demlua::law
