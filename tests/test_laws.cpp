// The laws against their closed forms, without a simulation around them.
#include "engine/law/coulomb.hpp"
#include "engine/law/elastic.hpp"
#include "engine/law/plateau.hpp"
#include "engine/law/rayleigh.hpp"
#include "engine/law/restitution.hpp"
#include "engine/law/stable_step.hpp"
#include "engine/law/stiffness.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double E = 29.7e9;
constexpr double nu = 0.3;
constexpr double strength = 3.44e6;
constexpr double toughness = 1.0e6;
constexpr double R = 5e-3;

law::Plateau::Params plateau(bool break_in_shear = false) {
    const law::PlaneModuli plane = law::plane_moduli(E, nu, false);
    return law::Plateau::derive(
        law::strength_caps(law::contact_stiffness(plane, 1.0), plane, 1.0, strength, toughness, 1.0), break_in_shear);
}

law::BondMotion<double> pulled(double stretch, double shear = 0.0) {
    return {1.0 / (2.0 * R + stretch), {1.0, 0.0}, stretch, shear};
}

} // namespace

TEST_CASE("stiffness has the figures of Tavarez & Plesha's concrete") {
    const law::ContactStiffness k = law::contact_stiffness(law::plane_moduli(E, nu, false), 1.0);
    CHECK(k.normal == Approx(2.449615e10).epsilon(1e-6));
    CHECK(k.shear == Approx(1.884319e9).epsilon(1e-6));
}

TEST_CASE("stiffness vanishes in shear at the limits of Poisson's ratio") {
    CHECK(std::fabs(law::contact_stiffness(law::plane_moduli(E, 1.0 / 3.0, false), 1.0).shear) < 1e-4);
    CHECK(std::fabs(law::contact_stiffness(law::plane_moduli(E, 0.25, true), 1.0).shear) < 1e-4);
}

TEST_CASE("stiffness of a close-packed lattice gives back E and nu by Voigt's sums") {
    // K2d = sum kn l^2/(4A), G = sum (kn + kt) l^2/(8A) over the six half bonds of a cell of area 2 sqrt(3) R^2.
    const double nu_in = GENERATE(0.0, 0.1, 0.2, 0.3);
    const law::ContactStiffness k = law::contact_stiffness(law::plane_moduli(E, nu_in, false), 1.0);
    const double l2 = 4.0 * R * R;
    const double A = 2.0 * std::numbers::sqrt3 * R * R;
    const double K = 3.0 * k.normal * l2 / (4.0 * A);
    const double G = 3.0 * (k.normal + k.shear) * l2 / (8.0 * A);
    CHECK(4.0 * K * G / (K + G) == Approx(E).epsilon(1e-12));
    CHECK((K - G) / (K + G) == Approx(nu_in).margin(1e-12));
}

TEST_CASE("plateau has the caps and openings of eqs 32 to 36") {
    const law::Plateau::Params p = plateau();
    CHECK(p.Kn * p.stretch_per_radius * R == Approx(19151.5).epsilon(1e-5));
    CHECK(p.Kt * p.shear_per_radius * R == Approx(1228.57).epsilon(1e-5));
    CHECK(p.stretch_per_radius * R == Approx(0.78182e-6).epsilon(1e-5));
    CHECK(p.opening + 0.5 * p.stretch_per_radius * R == Approx(17.9718e-6).epsilon(1e-5));
}

TEST_CASE("plateau spends the fracture energy under its stress-opening curve") {
    const law::Plateau::Params p = plateau();
    law::Plateau::History<double> history;
    const double d_max = p.opening + 0.5 * p.stretch_per_radius * R;
    const double step = d_max / 40000.0;
    double work = 0.0;
    double before = 0.0;
    double e = 0.0;
    while (e < d_max) {
        e += step;
        const double fn = law::Plateau::respond(p, R, pulled(e), history).normal;
        work += 0.5 * (before + fn) * step;
        before = fn;
    }
    CHECK(work / (2.0 * R) == Approx(toughness * toughness / E).epsilon(1e-4));
    // The same energy as the law counts it: plastic work and what is still stored at the end.
    const double counted = history.work + law::Plateau::stored_energy(p, pulled(e), history);
    CHECK(counted / (2.0 * R) == Approx(33.670).epsilon(1e-4));
}

TEST_CASE("plateau unloads with its first stiffness, and never yields in compression") {
    const law::Plateau::Params p = plateau();
    law::Plateau::History<double> history;
    const double yielded = 5e-6;
    const double cap = law::Plateau::respond(p, R, pulled(yielded), history).normal;
    CHECK(cap == p.Kn * (p.stretch_per_radius * R));
    CHECK(law::Plateau::respond(p, R, pulled(yielded - 0.5e-6), history).normal ==
          Approx(cap - 0.5e-6 * p.Kn).epsilon(1e-10));
    const double work = history.work;
    CHECK(law::Plateau::respond(p, R, pulled(-20e-6), history).normal ==
          Approx(-(20e-6 + history.stretch) * p.Kn).epsilon(1e-10));
    CHECK(history.work == work);
    CHECK_FALSE(law::Plateau::broken(p, R, pulled(-1.0), history));
}

TEST_CASE("plateau caps shear both ways and breaks in shear only when asked to") {
    const law::Plateau::Params printed = plateau(false);
    const law::Plateau::Params breaking = plateau(true);
    law::Plateau::History<double> history;
    const double cap = printed.Kt * (printed.shear_per_radius * R);
    CHECK(law::Plateau::respond(printed, R, pulled(0.0, 1e-3), history).shear == cap);
    CHECK(law::Plateau::respond(printed, R, pulled(0.0, -1e-3), history).shear == -cap);
    CHECK_FALSE(law::Plateau::broken(printed, R, pulled(0.0, 1.0), history));
    // Area under the shear curve: cap times the greatest shear, less the elastic triangle left out at the start.
    const double d_max = breaking.slip + 0.5 * breaking.shear_per_radius * R;
    CHECK(cap * (d_max - 0.5 * cap / breaking.Kt) / (2.0 * R) == Approx(33.670).epsilon(1e-4));
    CHECK(law::Plateau::broken(breaking, R, pulled(0.0, d_max * 1.0001), history));
    CHECK_FALSE(law::Plateau::broken(breaking, R, pulled(0.0, d_max * 0.9999), history));
}

TEST_CASE("a strain-rate factor multiplies strength and fracture energy") {
    const law::PlaneModuli plane = law::plane_moduli(E, nu, false);
    const law::ContactStiffness k = law::contact_stiffness(plane, 1.0);
    const auto fast = law::strength_caps(k, plane, 1.0, strength, toughness, 3.0);
    const auto same = law::strength_caps(k, plane, 1.0, 3.0 * strength, std::sqrt(3.0) * toughness, 1.0);
    CHECK(fast.stretch_per_radius == Approx(same.stretch_per_radius).epsilon(1e-14));
    CHECK(fast.opening == Approx(same.opening).epsilon(1e-14));
}

TEST_CASE("a bond turned as a whole neither stretches nor shears") {
    const Vec2 D{0.6e-2, 0.8e-2};
    const double angle = GENERATE(0.01, 1.0, 3.1, 3.2, 40.0, 628.4, -200.0);
    const Vec2 du = turned(D, angle) - D;
    const auto motion = law::bond_motion(D, norm(D), 1.0 / norm(D), du, angle);
    CHECK(std::fabs(motion.stretch) < 1e-15);
    CHECK(std::fabs(motion.shear) < 1e-2 * 1e-13 * std::max(1.0, std::fabs(angle)));
}

TEST_CASE("the angle between vectors agrees with the library's to the last place but one") {
    const double angle = GENERATE(1e-12, -3e-7, 1e-3, 0.0199, 0.0201, -1.5, 3.0);
    CHECK(angle_of(std::cos(angle), std::sin(angle)) ==
          Approx(std::atan2(std::sin(angle), std::cos(angle))).epsilon(5e-16));
}

TEST_CASE("restitution and damping fraction are inverse to each other") {
    const double e = GENERATE(1.0, 0.9, 0.5, 0.2, 0.135335, 0.05);
    CHECK(law::restitution_of(law::damping_fraction(e)) == Approx(e).epsilon(1e-9));
}

TEST_CASE("restitution is that of a spring and dashpot released at zero force") {
    // Independent of the closed form: the linear contact stepped with a fine explicit scheme.
    const double xi = GENERATE(0.05, 0.2, 0.7, 1.5);
    double x = 0.0;
    double v = 1.0;
    const double dt = 1e-6;
    while (x + 2.0 * xi * v > 0.0 || x <= 0.0) {
        const double a = -x - 2.0 * xi * v;
        const double middle = v + 0.5 * dt * a;
        x += dt * middle;
        v = middle + 0.5 * dt * (-x - 2.0 * xi * middle);
        if (x > 0.0 && x + 2.0 * xi * v <= 0.0) break;
    }
    CHECK(law::restitution_of(xi) == Approx(-v).epsilon(1e-4));
}

TEST_CASE("Rayleigh damping meets both fractions") {
    const law::Rayleigh damping = law::rayleigh(0.02, 10.0, 0.05, 200.0);
    const auto fraction = [&](double f) {
        const double w = 2.0 * std::numbers::pi * f;
        return damping.alpha / (2.0 * w) + damping.beta * w / 2.0;
    };
    CHECK(fraction(10.0) == Approx(0.02).epsilon(1e-12));
    CHECK(fraction(200.0) == Approx(0.05).epsilon(1e-12));
}

TEST_CASE("the damped step limit is where the difference equation loses stability") {
    // Roots of z^2 - (2 - dt^2 k - dt c) z + 1 - dt c, the mode stepped with lagged damping.
    const double xi = GENERATE(0.0, 0.1, 0.707, 1.0, 2.0);
    const double k = 4.0e6;
    const double c = 2.0 * xi * std::sqrt(k);
    const auto largest_root = [&](double dt) {
        const std::complex<double> b = 2.0 - dt * dt * k - dt * c;
        const std::complex<double> root = std::sqrt(b * b - 4.0 * (1.0 - dt * c));
        return std::max(std::abs(0.5 * (b + root)), std::abs(0.5 * (b - root)));
    };
    const double dt = law::stable_step(k, c);
    CHECK(largest_root(0.999 * dt) < 1.0 + 1e-9);
    CHECK(largest_root(1.001 * dt) > 1.0 + 1e-9);
    CHECK(dt == Approx(2.0 / std::sqrt(k) * (std::sqrt(1.0 + xi * xi) - xi)).epsilon(1e-12));
}

TEST_CASE("friction spends exactly what the motion gives it") {
    // Slip at constant pressure: the work of the shear force over a long slide is mu N times the slip.
    const law::Coulomb::Params p{1e9, 1e8, 0.5};
    law::Coulomb::History<double> history;
    law::Spent<double> spent;
    const double dt = 1e-6;
    const double v = 0.3;
    double force = 0.0;
    for (int n = 0; n < 2000; ++n) {
        force = law::Coulomb::respond(p, law::Coulomb::Input<double>{1e-5, 0.0, v, 0.0, 0.0}, dt, history, spent).shear;
    }
    const double cap = 0.5 * 1e9 * 1e-5;
    CHECK(force == cap);
    const double stored = 0.5 * 1e8 * history.shear * history.shear;
    // Slid in all: v n dt, of which cap/Kt stretched the spring first.
    CHECK(spent.friction == Approx(cap * (v * 2000 * dt - cap / 1e8)).epsilon(1e-3));
    CHECK(stored == Approx(0.5 * cap * cap / 1e8).epsilon(1e-12));
    CHECK(std::fabs(spent.damped) < 1e-12 * spent.friction); // the spring alone spends nothing
}
