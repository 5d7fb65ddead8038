// A ring or a disc squeezed across a diameter: the exact plane-stress solution as a Fourier series.
//
// The pressure on two opposite arcs is a cosine series in the angle from the loaded axis; each of its harmonics n meets a
// stress function (A r^n + B r^-n + C r^(n+2) + D r^(2-n)) cos n psi (Michell 1899; Barber, Elasticity, tables 8.1 and
// 9.1). The disc's stress at its centre sums up to Hondros (1959).
#pragma once

#include "engine/base/vec2.hpp"

namespace demlua::test {

struct SqueezedRing {
    double outer = 1.0;      // radius, m
    double inner = 0.0;      // radius, m; 0 for a disc without a hole
    double half_angle = 0.0; // of each loaded arc, rad
    double pressure = 1.0;   // on the arcs, Pa
    double modulus = 1.0;    // Young's, Pa
    double poisson = 0.3;
};

struct RadialStress {
    double radial;
    double hoop;
    double shear;
};

/// Pressure (Pa) on an arc whose resultant is `force` (N per metre of thickness).
double arc_pressure(double force, double outer, double half_angle);

/// Displacement (radial, tangential; m) at radius r and angle psi (rad) from the loaded axis.
Vec2 displacement(const SqueezedRing& ring, double r, double psi);

/// Stress (Pa) at a place inside. The series falls as (r / outer)^n: r must stay below 0.99 outer.
RadialStress stress(const SqueezedRing& ring, double r, double psi);

/// Mean over a loaded arc of the displacement along the loaded axis, outwards positive, m.
double mean_arc_displacement(const SqueezedRing& ring);

/// Stress at the centre of a disc (Pa): `radial` along the loaded axis, `hoop` across it. Hondros 1959.
RadialStress centre_stress(double pressure, double half_angle);

} // namespace demlua::test
