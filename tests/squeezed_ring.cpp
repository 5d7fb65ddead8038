#include "tests/squeezed_ring.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace demlua::test {

namespace {

// Displacements on the boundary fall as 1/n^2, their means over the arc as 1/n^3: the rest is below 1e-7 of the whole.
constexpr int last_harmonic = 4000;

/// Amplitudes of one harmonic at one radius: cosines, but sines for the shear and the tangential displacement.
struct Amplitudes {
    double radial_stress;
    double hoop_stress;
    double shear_stress;
    double radial; // displacement
    double tangential;
};

double shear_modulus(const SqueezedRing& ring) { return 0.5 * ring.modulus / (1.0 + ring.poisson); }

/// One term of the stress function, scaled so that its stress is of the order one at its own wall.
Amplitudes term(const SqueezedRing& ring, int harmonic, int which, double r) {
    const double n = harmonic;
    const double kappa = (3.0 - ring.poisson) / (1.0 + ring.poisson);
    const bool growing = which < 2;
    const double wall = growing ? ring.outer : ring.inner;
    const double x = r / wall;
    const double u = 0.5 * wall / shear_modulus(ring);
    switch (which) {
    case 0: { // r^n
        const double s = n * (n - 1.0) * std::pow(x, n - 2.0);
        const double d = u * n * std::pow(x, n - 1.0);
        return {-s, s, s, -d, d};
    }
    case 1: { // r^(n+2)
        const double s = (n + 1.0) * std::pow(x, n);
        const double d = u * std::pow(x, n + 1.0);
        return {-(n - 2.0) * s, (n + 2.0) * s, n * s, (kappa - n - 1.0) * d, (kappa + n + 1.0) * d};
    }
    case 2: { // r^-n
        const double s = n * (n + 1.0) * std::pow(x, -n - 2.0);
        const double d = u * n * std::pow(x, -n - 1.0);
        return {-s, s, -s, d, d};
    }
    default: { // r^(2-n)
        const double s = (n - 1.0) * std::pow(x, -n);
        const double d = u * std::pow(x, 1.0 - n);
        return {-(n + 2.0) * s, (n - 2.0) * s, -n * s, (kappa + n - 1.0) * d, -(kappa - n + 1.0) * d};
    }
    }
}

/// Weights of the terms that give the radial stress `load` at the outer wall and free walls otherwise.
Eigen::VectorXd weights(const SqueezedRing& ring, int harmonic, double load) {
    const int terms = ring.inner > 0.0 ? 4 : 2;
    Eigen::MatrixXd walls(terms, terms);
    for (int k = 0; k < terms; ++k) {
        const Amplitudes outside = term(ring, harmonic, k, ring.outer);
        walls(0, k) = outside.radial_stress;
        walls(1, k) = outside.shear_stress;
        if (terms == 4) {
            const Amplitudes inside = term(ring, harmonic, k, ring.inner);
            walls(2, k) = inside.radial_stress;
            walls(3, k) = inside.shear_stress;
        }
    }
    Eigen::VectorXd loads = Eigen::VectorXd::Zero(terms);
    loads[0] = load;
    return walls.partialPivLu().solve(loads);
}

/// The mean of the load: a ring under outer pressure (Lame).
Amplitudes mean_part(const SqueezedRing& ring, double r) {
    const double load = -2.0 * ring.pressure * ring.half_angle / std::numbers::pi;
    const double hole = std::pow(ring.inner / ring.outer, 2.0);
    const double A = load / (1.0 - hole);
    const double B = r > 0.0 ? -A * std::pow(ring.inner / r, 2.0) : 0.0;
    const double radial = r * ((1.0 - ring.poisson) * A - (1.0 + ring.poisson) * B) / ring.modulus;
    return {A + B, A - B, 0.0, radial, 0.0};
}

Amplitudes harmonic_part(const SqueezedRing& ring, int harmonic, double r) {
    const double load = -4.0 * ring.pressure * std::sin(harmonic * ring.half_angle) / (std::numbers::pi * harmonic);
    const Eigen::VectorXd weight = weights(ring, harmonic, load);
    Amplitudes sum{};
    for (int k = 0; k < static_cast<int>(weight.size()); ++k) {
        const Amplitudes one = term(ring, harmonic, k, r);
        sum.radial_stress += weight[k] * one.radial_stress;
        sum.hoop_stress += weight[k] * one.hoop_stress;
        sum.shear_stress += weight[k] * one.shear_stress;
        sum.radial += weight[k] * one.radial;
        sum.tangential += weight[k] * one.tangential;
    }
    return sum;
}

/// sin(x) / x
double cardinal_sine(double x) { return x == 0.0 ? 1.0 : std::sin(x) / x; }

} // namespace

double arc_pressure(double force, double outer, double half_angle) {
    return force / (2.0 * outer * std::sin(half_angle));
}

Vec2 displacement(const SqueezedRing& ring, double r, double psi) {
    Vec2 sum{mean_part(ring, r).radial, 0.0};
    for (int n = 2; n <= last_harmonic; n += 2) {
        const Amplitudes part = harmonic_part(ring, n, r);
        sum += Vec2{part.radial * std::cos(n * psi), part.tangential * std::sin(n * psi)};
    }
    return sum;
}

RadialStress stress(const SqueezedRing& ring, double r, double psi) {
    const Amplitudes mean = mean_part(ring, r);
    RadialStress sum{mean.radial_stress, mean.hoop_stress, 0.0};
    for (int n = 2; n <= last_harmonic; n += 2) {
        const Amplitudes part = harmonic_part(ring, n, r);
        sum.radial += part.radial_stress * std::cos(n * psi);
        sum.hoop += part.hoop_stress * std::cos(n * psi);
        sum.shear += part.shear_stress * std::sin(n * psi);
    }
    return sum;
}

double mean_arc_displacement(const SqueezedRing& ring) {
    const double a = ring.half_angle;
    double sum = mean_part(ring, ring.outer).radial * cardinal_sine(a);
    for (int n = 2; n <= last_harmonic; n += 2) {
        const Amplitudes part = harmonic_part(ring, n, ring.outer);
        const double below = cardinal_sine((n - 1.0) * a);
        const double above = cardinal_sine((n + 1.0) * a);
        sum += 0.5 * (part.radial * (below + above) - part.tangential * (below - above));
    }
    return sum;
}

RadialStress centre_stress(double pressure, double half_angle) {
    const double share = 2.0 * pressure / std::numbers::pi;
    return {-share * (std::sin(2.0 * half_angle) + half_angle), share * (std::sin(2.0 * half_angle) - half_angle), 0.0};
}

} // namespace demlua::test
