// Round bodies squeezed across a diameter along y.
#include "tests/finite_elements.hpp"
#include "tests/reference_cases.hpp"
#include "tests/squeezed_ring.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace demlua::test {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double half_angle = 10.0 * degree;
constexpr const char* squeeze = "uniform pressure on the arcs within 10 degrees of the y axis, resultant 1 on each";

SqueezedRing squeezed(double inner) { return {1.0, inner, half_angle, arc_pressure(1.0, 1.0, half_angle), 1.0, 0.3}; }

/// A quarter of a body that is symmetric about both axes.
struct Quarter {
    fe::Mesh mesh;
    fe::Field displacement;
    fe::Solid solid;

    [[nodiscard]] Vec2 displacement_at(Vec2 place) const {
        const int node = fe::nearest_node(mesh, place);
        return {displacement[2 * node], displacement[2 * node + 1]};
    }
    [[nodiscard]] Eigen::Vector3d stress_at(Vec2 place) const {
        return fe::stress_at(mesh, solid, displacement, fe::nearest_node(mesh, place));
    }
};

std::vector<fe::Edge> loaded_arc(const fe::Mesh& mesh) {
    return fe::boundary(mesh, [](Vec2 at) {
        return norm(at) > 1.0 - fe::touching && at.x < std::sin(half_angle) + fe::touching && at.y > 0.0;
    });
}

Quarter squeeze_quarter(fe::Mesh mesh) {
    Quarter quarter{std::move(mesh), {}, {.modulus = 1.0, .poisson = 0.3}};
    fe::Supports supports(quarter.mesh);
    supports.hold_x(fe::at_x(0.0)).hold_y(fe::at_y(0.0));
    const double pressure = arc_pressure(1.0, 1.0, half_angle);
    const fe::Field load = fe::forces(quarter.mesh, loaded_arc(quarter.mesh), 1.0,
                                      [=](Vec2, Vec2 outward) { return -pressure * outward; });
    quarter.displacement = fe::solve_static(fe::assemble(quarter.mesh, quarter.solid, supports), load);
    return quarter;
}

Vec2 round(double r, double angle) { return turned({r, 0.0}, angle); }

double between(double a, double b, double s) { return a + (b - a) * s; }

/// Diameters of the outer wall, with the series' values.
std::vector<Quantity> outer_diameters(const Quarter& quarter, const SqueezedRing& ring) {
    const double quarter_turn = 0.5 * std::numbers::pi;
    return {{"outer_vertical_arc", "change of the outer diameter along y: mean of u_y over the loaded arcs",
             2.0 * fe::mean_over(quarter.mesh, loaded_arc(quarter.mesh), quarter.displacement).y,
             2.0 * mean_arc_displacement(ring)},
            {"outer_vertical", "change of the outer diameter on the y axis",
             2.0 * quarter.displacement_at({0.0, 1.0}).y, 2.0 * displacement(ring, 1.0, 0.0).x},
            {"outer_horizontal", "change of the outer diameter on the x axis",
             2.0 * quarter.displacement_at({1.0, 0.0}).x, 2.0 * displacement(ring, 1.0, quarter_turn).x}};
}

fe::Mesh ring_mesh(double inner, int rows) {
    const auto sector = [&](double from, double to, int steps) {
        return fe::block(fe::small_at_ends(rows, 2.0), fe::even(steps), [=](double s, double t) {
            return round(between(inner, 1.0, s), between(from, to, t) * degree);
        });
    };
    return fe::joined({sector(0.0, 80.0, 4 * rows), sector(80.0, 90.0, rows)});
}

ReferenceCase squeezed_ring() {
    return {"squeezed_ring",
            "ring, outer radius 1, inner radius 0.5",
            "E = 1, nu = 0.3, thickness 1, plane stress",
            "rigid motions only (a quarter is solved)",
            squeeze,
            {16, 32},
            [](int rows) { return fmt::format("quarter: {} along the radius x {} along the angle", rows, 5 * rows); },
            [](int rows) {
                const double inner = 0.5;
                const double quarter_turn = 0.5 * std::numbers::pi;
                const Quarter quarter = squeeze_quarter(ring_mesh(inner, rows));
                const SqueezedRing ring = squeezed(inner);
                std::vector<Quantity> quantities = outer_diameters(quarter, ring);
                quantities.push_back({"inner_horizontal", "change of the inner diameter on the x axis",
                                      2.0 * quarter.displacement_at({inner, 0.0}).x,
                                      2.0 * displacement(ring, inner, quarter_turn).x});
                quantities.push_back({"inner_vertical", "change of the inner diameter on the y axis",
                                      2.0 * quarter.displacement_at({0.0, inner}).y,
                                      2.0 * displacement(ring, inner, 0.0).x});
                quantities.push_back({"hoop_inner_0", "hoop stress at the inner wall on the x axis",
                                      quarter.stress_at({inner, 0.0})[1], stress(ring, inner, quarter_turn).hoop});
                quantities.push_back({"hoop_inner_90", "hoop stress at the inner wall on the y axis, under the load",
                                      quarter.stress_at({0.0, inner})[0], stress(ring, inner, 0.0).hoop});
                return quantities;
            }};
}

/// A square core and rings of cells round it; the core is divided where the loaded arc ends.
fe::Mesh disc_mesh(int rows) {
    const double core = 0.5;
    const double split = core * 10.0 / 45.0; // the loaded arc's share of the core's upper side
    const auto right = [&](double s, double t) {
        const Vec2 inside{core, core * t};
        return (1.0 - s) * inside + s * round(1.0, 45.0 * degree * t);
    };
    const auto above = [&](double x_from, double x_to, double from, double to) {
        return [=](double s, double t) {
            const Vec2 inside{between(x_from, x_to, s), core};
            return (1.0 - t) * inside + t * round(1.0, between(from, to, s) * degree);
        };
    };
    const auto middle = [&](double x_from, double x_to) {
        return [=](double s, double t) { return Vec2{between(x_from, x_to, s), core * t}; };
    };
    const fe::Stations out = fe::small_at_end(rows, 2.0);
    const fe::Stations up = fe::small_at_start(rows, 2.0);
    const fe::Stations narrow = fe::small_at_ends(rows / 2, 2.0);
    const fe::Stations wide = fe::small_at_start(rows, 2.0);
    return fe::joined({fe::block(narrow, up, middle(0.0, split)), fe::block(wide, up, middle(split, core)),
                       fe::block(out, up, right), fe::block(narrow, out, above(0.0, split, 90.0, 80.0)),
                       fe::block(wide, out, above(split, core, 80.0, 45.0))});
}

ReferenceCase squeezed_disc() {
    return {"squeezed_disc",
            "disc of radius 1",
            "E = 1, nu = 0.3, thickness 1, plane stress",
            "rigid motions only (a quarter is solved)",
            squeeze,
            {12, 24},
            [](int rows) { return fmt::format("quarter: {} cells, {} along the radius", 4 * rows * rows, 2 * rows); },
            [](int rows) {
                const Quarter quarter = squeeze_quarter(disc_mesh(rows));
                const SqueezedRing disc = squeezed(0.0);
                std::vector<Quantity> quantities = outer_diameters(quarter, disc);
                const Eigen::Vector3d centre = quarter.stress_at({0.0, 0.0});
                const RadialStress hondros = centre_stress(disc.pressure, half_angle);
                quantities.push_back({"centre_xx", "stress xx at the centre", centre[0], hondros.hoop});
                quantities.push_back({"centre_yy", "stress yy at the centre", centre[1], hondros.radial});
                return quantities;
            }};
}

} // namespace

std::vector<ReferenceCase> round_cases() { return {squeezed_ring(), squeezed_disc()}; }

} // namespace demlua::test
