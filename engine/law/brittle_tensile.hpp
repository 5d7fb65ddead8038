// Bonds that break at the tensile strength.
//
//   f_ult = s 2R t                     Tavarez & Plesha 2007, eq. 21; on a facet of length A: s A t
//
// s tensile strength, R mean radius of the two elements, t thickness. A strain-rate factor f stands for s -> f s.
// Limits: those of law/brittle.hpp. The stress that makes a crack grow falls with sqrt(R): not objective to element size.
#pragma once

#include "engine/law/brittle.hpp"

namespace demlua::law {

struct TensileCap {
    static constexpr const char* name = "brittle_tensile";

    template <class T>
    static T growth(T radius) {
        return radius;
    }
    template <class T>
    static T stress_growth(T /*radius*/) {
        return T{1.0};
    }
};

struct BrittleTensile : Brittle<TensileCap> {
    /// `strength` in Pa, `thickness` in m.
    static Params derive(ContactStiffness k, double thickness, double strength, double rate_factor) {
        return {k.normal, k.shear, 2.0 * rate_factor * strength * thickness};
    }
    static Tractions derive_tractions(double thickness, double strength, double rate_factor) {
        return {rate_factor * strength * thickness};
    }
};

} // namespace demlua::law
