// Bonds that break when the stress before a crack's tip, averaged over one element, is that of the fracture toughness.
//
//   f_ult = 2 K t sqrt(R/pi)           Tavarez & Plesha 2007, eq. 26; on a facet of length A: f_ult/(2Rt) A t = K A t/sqrt(pi R)
//
// K fracture toughness, R mean radius of the two elements, t thickness. A strain-rate factor f on the fracture energy stands
// for K -> sqrt(f) K.
// Limits: those of law/brittle.hpp. Without a crack the strength grows without bound as elements become smaller: no
// strength of the material enters. Derived for a square lattice whose tip bond bears no shear.
#pragma once

#include "engine/law/brittle.hpp"

#include <cmath>
#include <numbers>

namespace demlua::law {

struct ToughnessCap {
    static constexpr const char* name = "brittle_toughness";

    template <class T>
    static T growth(T radius) {
        return square_root(radius);
    }
    template <class T>
    static T stress_growth(T radius) {
        return 1.0 / square_root(radius);
    }
};

struct BrittleToughness : Brittle<ToughnessCap> {
    /// `toughness` in Pa m^0.5, `thickness` in m.
    static Params derive(ContactStiffness k, double thickness, double toughness, double rate_factor) {
        return {k.normal, k.shear, 2.0 * std::sqrt(rate_factor * std::numbers::inv_pi) * toughness * thickness};
    }
    static Tractions derive_tractions(double thickness, double toughness, double rate_factor) {
        return {std::sqrt(rate_factor * std::numbers::inv_pi) * toughness * thickness};
    }
};

} // namespace demlua::law
