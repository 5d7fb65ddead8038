// The laws that break against their closed curves, without a simulation around them.
#include "engine/law/brittle_tensile.hpp"
#include "engine/law/brittle_toughness.hpp"
#include "engine/law/plateau.hpp"
#include "engine/law/softening.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace demlua;
using Catch::Approx;

namespace {

// Concrete of Tavarez & Plesha 2007, section 8, plane stress, t = 1 m.
constexpr law::PlaneModuli plane{29.7e9, 0.3};
constexpr double strength = 3.44e6;
constexpr double toughness = 1.0e6;
constexpr double R = 5e-3;
constexpr double fracture_energy = toughness * toughness / 29.7e9;

law::StrengthCaps caps() {
    return law::strength_caps(law::contact_stiffness(plane, 1.0), plane, 1.0, strength, toughness, 1.0);
}

law::BondMotion<double> pulled(double stretch, double shear = 0.0) {
    return {1.0 / (2.0 * R + stretch), {1.0, 0.0}, stretch, shear};
}

/// One bond taken from place to place, with the work done on it by the mean of the forces at both ends of every way: exact
/// where the curve is straight between the places.
template <class Law>
struct Pulled {
    typename Law::Params params;
    double radius = R;
    typename Law::template History<double> history{};
    law::BondMotion<double> at = pulled(0.0);
    law::BondForce<double> force{0.0, 0.0};
    double work = 0.0;

    law::BondForce<double> to(double stretch, double shear = 0.0) {
        const law::BondMotion<double> next = pulled(stretch, shear);
        const law::BondForce<double> before = force;
        force = Law::respond(params, radius, next, history);
        work += 0.5 * (before.normal + force.normal) * (next.stretch - at.stretch) +
                0.5 * (before.shear + force.shear) * (next.shear - at.shear);
        at = next;
        return force;
    }
    [[nodiscard]] bool broken() const { return Law::broken(params, radius, at, history); }
    [[nodiscard]] double stored() const { return Law::stored_energy(params, at, history); }
};

template <class Law>
void breaks_at(const typename Law::Params& params, double pull) {
    Pulled<Law> bond{params};
    bond.to(pull * (1.0 - 1e-12) / params.Kn);
    CHECK_FALSE(bond.broken());
    bond.to(pull * (1.0 + 1e-12) / params.Kn);
    CHECK(bond.broken());
    bond.to(-1.0, 1.0);
    CHECK_FALSE(bond.broken());
}

const double delta_crit = caps().stretch_per_radius * R;
const double force_crit = caps().Kn * delta_crit;
const double shear_crit = caps().shear_per_radius * R;

} // namespace

TEST_CASE("plateau: the area under the whole curve, unloaded and loaded again on the way, is G_f 2Rt") {
    Pulled<law::Plateau> bond{law::Plateau::derive(caps(), false)};
    const double d_max = bond.params.opening + 0.5 * delta_crit;
    bond.to(delta_crit);
    CHECK(bond.force.normal == Approx(force_crit).epsilon(1e-14));
    CHECK(bond.to(0.5 * d_max).normal == Approx(force_crit).epsilon(1e-14));
    CHECK(bond.to(0.5 * d_max - 3.0 * delta_crit).normal == Approx(-2.0 * force_crit).epsilon(1e-12));
    CHECK(bond.to(0.5 * d_max).normal == Approx(force_crit).epsilon(1e-12));
    bond.to(d_max * (1.0 - 1e-13));
    CHECK_FALSE(bond.broken());
    CHECK(bond.work == Approx(fracture_energy * 2.0 * R).epsilon(1e-10));
    CHECK(bond.history.work + bond.stored() == Approx(fracture_energy * 2.0 * R).epsilon(1e-10));
    bond.to(d_max * (1.0 + 1e-13));
    CHECK(bond.broken());
}

TEST_CASE("softening: figure 16 with unloading by Kn, and the area G_f 2Rt under the whole curve") {
    Pulled<law::Softening> bond{caps()};
    const double d_max = 2.0 * fracture_energy * 2.0 * R / force_crit;
    CHECK(bond.to(0.5 * delta_crit).normal == Approx(0.5 * force_crit).epsilon(1e-14));
    CHECK(bond.history.lost == 0.0);
    CHECK(bond.to(delta_crit).normal == Approx(force_crit).epsilon(1e-13));
    const auto on_line = [&](double e) { return force_crit * (d_max - e) / (d_max - delta_crit); };
    const double turn = 0.4 * d_max;
    CHECK(bond.to(turn).normal == Approx(on_line(turn)).epsilon(1e-12));
    const double spent = bond.history.work;
    CHECK(bond.to(turn - 2.0 * delta_crit).normal == Approx(on_line(turn) - 2.0 * force_crit).epsilon(1e-12));
    CHECK(bond.to(-5.0 * delta_crit).normal ==
          Approx(bond.params.Kn * (-5.0 * delta_crit - bond.history.stretch)).epsilon(1e-12));
    CHECK(bond.history.work == spent);
    CHECK(bond.to(turn).normal == Approx(on_line(turn)).epsilon(1e-12));
    CHECK(bond.to(0.8 * d_max).normal == Approx(on_line(0.8 * d_max)).epsilon(1e-12));
    CHECK_FALSE(bond.broken());
    bond.to(d_max * (1.0 + 1e-13));
    CHECK(bond.broken());
    CHECK(std::fabs(bond.force.normal) < 1e-10 * force_crit);
    CHECK(bond.work == Approx(fracture_energy * 2.0 * R).epsilon(1e-10));
    CHECK(bond.history.work == Approx(fracture_energy * 2.0 * R).epsilon(1e-12));
    CHECK(law::Softening::damage(bond.params, R, bond.history) == 1.0);
}

TEST_CASE("softening: the same curve in shear, both ways, whatever presses the bond") {
    const double sign = GENERATE(1.0, -1.0);
    const double pressed = GENERATE(0.0, -20e-6);
    Pulled<law::Softening> bond{caps()};
    bond.to(pressed);
    const double before = bond.work;
    const double cap = bond.params.Kt * shear_crit;
    const double d_max = 2.0 * fracture_energy * 2.0 * R / cap;
    const auto on_line = [&](double u) { return cap * (d_max - u) / (d_max - shear_crit); };
    CHECK(sign * bond.to(pressed, sign * shear_crit).shear == Approx(cap).epsilon(1e-12));
    CHECK(sign * bond.to(pressed, sign * 0.3 * d_max).shear == Approx(on_line(0.3 * d_max)).epsilon(1e-12));
    CHECK(sign * bond.to(pressed, sign * (0.3 * d_max - shear_crit)).shear ==
          Approx(on_line(0.3 * d_max) - cap).epsilon(1e-9));
    // Through zero to the cap of the other way, which has fallen by as much.
    const double left = 1.0 - bond.history.lost;
    bond.to(pressed, bond.history.shear - sign * left * shear_crit);
    CHECK(sign * bond.force.shear == Approx(-left * cap).epsilon(1e-9));
    bond.to(pressed, sign * 0.3 * d_max);
    bond.to(pressed, sign * d_max * (1.0 + 1e-13));
    CHECK(bond.broken());
    CHECK(bond.force.normal == Approx(bond.params.Kn * pressed).epsilon(1e-14));
    CHECK(bond.work - before == Approx(fracture_energy * 2.0 * R).epsilon(1e-10));
}

TEST_CASE("softening: stretched and sheared in any mixture, a bond spends G_f 2Rt and both caps fall together") {
    const double angle = GENERATE(0.02, 0.1, 0.3, 0.8, 1.4);
    Pulled<law::Softening> bond{caps()};
    const double far = 8.0 * fracture_energy * 2.0 * R / force_crit;
    const int count = 100000;
    double over = 0.0; // of what is left of each cap
    for (int n = 1; n <= count && !bond.broken(); ++n) {
        const double s = far * n / count;
        bond.to(s * std::cos(angle), 40.0 * s * std::sin(angle));
        const double left = 1.0 - bond.history.lost;
        over = std::max(over, bond.force.normal / force_crit - left);
        over = std::max(over, bond.force.shear / (bond.params.Kt * shear_crit) - left);
    }
    CHECK(over < 1e-12);
    CHECK(bond.broken());
    CHECK(bond.history.work == Approx(fracture_energy * 2.0 * R).epsilon(1e-12));
    // A way across a corner of the curve is out by K h^2/2 at most; there are three: two caps reached, and the end.
    const double dx = far / count * std::cos(angle);
    const double dy = 40.0 * far / count * std::sin(angle);
    const double corner = 0.5 * (bond.params.Kn * dx * dx + bond.params.Kt * dy * dy);
    CHECK(std::fabs(bond.work - fracture_energy * 2.0 * R) <= 3.0 * corner + 1e-12);
}

TEST_CASE("yielding laws spend G_f A t on a facet, and yield at s A t and sqrt(3/7) s A t") {
    const double A = 3e-3;
    const double t = 0.4;
    const law::FacetCaps on = law::facet_caps(plane, t, strength, toughness, 1.0);
    const law::ContactStiffness k{2e9, 1e9};
    Pulled<law::Softening> soft{law::Softening::on_facet(on, k, A, R), 1.0};
    const double d_max = 2.0 * fracture_energy / strength;
    soft.to(strength * A * t / k.normal);
    CHECK(soft.force.normal == Approx(strength * A * t).epsilon(1e-13));
    soft.to(d_max * (1.0 + 1e-13));
    CHECK(soft.broken());
    CHECK(soft.work == Approx(fracture_energy * A * t).epsilon(1e-10));

    Pulled<law::Plateau> flat{law::Plateau::on_facet(law::Plateau::derive(on, true), k, A, R), 1.0};
    const double cap = std::sqrt(3.0 / 7.0) * strength * A * t;
    flat.to(0.0, cap / k.shear);
    const double u_max = fracture_energy * A * t / cap + 0.5 * cap / k.shear;
    CHECK(flat.to(0.0, u_max * (1.0 - 1e-13)).shear == Approx(cap).epsilon(1e-13));
    CHECK(flat.work == Approx(fracture_energy * A * t).epsilon(1e-10));
    CHECK_FALSE(flat.broken());
    flat.to(0.0, u_max * (1.0 + 1e-13));
    CHECK(flat.broken());
}

TEST_CASE("brittle bonds break at the pulls of eqs 21 and 26, and at nothing else") {
    const double t = 2.0;
    const law::ContactStiffness k = law::contact_stiffness(plane, t);
    breaks_at<law::BrittleTensile>(law::BrittleTensile::derive(k, t, strength, 1.0), strength * 2.0 * R * t);
    breaks_at<law::BrittleToughness>(law::BrittleToughness::derive(k, t, toughness, 1.0),
                                     2.0 * toughness * t * std::sqrt(R / std::numbers::pi));
}

TEST_CASE("brittle bonds on facets bear the same stress, f_ult/(2Rt)") {
    const law::ContactStiffness k{2e9, 1e9};
    const double A = 3e-3;
    const double t = 0.4;
    const auto cap = [](const auto& params) { return params.cap; };
    CHECK(cap(law::BrittleTensile::on_facet(law::BrittleTensile::derive_tractions(t, strength, 1.0), k, A, R)) ==
          Approx(strength * A * t).epsilon(1e-14));
    CHECK(cap(law::BrittleToughness::on_facet(law::BrittleToughness::derive_tractions(t, toughness, 1.0), k, A, R)) ==
          Approx(2.0 * toughness * t * std::sqrt(R / std::numbers::pi) / (2.0 * R * t) * A * t).epsilon(1e-14));
}

TEST_CASE("a strain-rate factor on the fracture energy is its root on the toughness") {
    const law::ContactStiffness k{2e9, 1e9};
    CHECK(law::BrittleToughness::derive(k, 1.0, toughness, 4.0).cap ==
          Approx(law::BrittleToughness::derive(k, 1.0, 2.0 * toughness, 1.0).cap).epsilon(1e-14));
    CHECK(law::BrittleTensile::derive(k, 1.0, strength, 4.0).cap ==
          Approx(law::BrittleTensile::derive(k, 1.0, 4.0 * strength, 1.0).cap).epsilon(1e-14));
}

TEST_CASE("the largest radius is the one at which a bond has nothing left to spend after it yields") {
    // Plateau: d_max = G 2Rt/fn + fn/(2 Kn) = fn/Kn. Softening: the energy stored at both caps is G 2Rt.
    const law::StrengthCaps p = caps();
    const double flat = law::Plateau::largest_radius(p);
    CHECK(p.opening + 0.5 * p.stretch_per_radius * flat == Approx(p.stretch_per_radius * flat).epsilon(1e-14));
    const double soft = law::Softening::largest_radius(p);
    const double fn = p.Kn * p.stretch_per_radius * soft;
    const double ft = p.Kt * p.shear_per_radius * soft;
    CHECK(0.5 * fn * fn / p.Kn + 0.5 * ft * ft / p.Kt == Approx(fracture_energy * 2.0 * soft).epsilon(1e-12));
    // From the formulas of section 8: fn/Kn = R s (3 - nu*)/(2 E*), G 2Rt = fn^2/(2 Kn).
    const double stress = strength / (4.0 * (1.0 - 0.3)) * (std::sqrt(3.0) - 0.3 / std::sqrt(3.0));
    CHECK(flat == Approx(2.0 * (fracture_energy / stress) / (strength * (3.0 - 0.3) / (2.0 * 29.7e9))).epsilon(1e-12));
}

TEST_CASE("fracture energy and toughness say the same in the plane's own modulus") {
    const law::PlaneModuli strain = law::plane_moduli(29.7e9, 0.2, true);
    CHECK(law::fracture_energy(toughness, strain) == Approx(1e12 * (1.0 - 0.04) / 29.7e9).epsilon(1e-14));
    CHECK(law::fracture_toughness(law::fracture_energy(toughness, strain), strain) == Approx(toughness).epsilon(1e-14));
}
