// Bars: cantilevers, and uniform tension across the axes.
#include "tests/finite_elements.hpp"
#include "tests/reference_cases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace demlua::test {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

// ---- bars held at one end ----

/// A bar between upright ends of height H, its long sides rising by `slope`.
struct Bar {
    double length;
    double height;
    double slope = 0.0;
};

constexpr int columns_per_row = 4;

/// Cells are small at the clamped end and at its corners, where the stress is singular.
fe::Mesh mesh_of(const Bar& bar, int rows) {
    return fe::block(fe::small_at_start(columns_per_row * rows, 2.0), fe::small_at_ends(rows, 2.0),
                     [&](double s, double t) {
                         const double x = bar.length * s;
                         return Vec2{x, bar.height * (t - 0.5) + bar.slope * x};
                     });
}

std::string bar_mesh(int rows) { return fmt::format("{} x {} nine-node cells", columns_per_row * rows, rows); }

/// End deflection under a unit force; with it the response to F0 sin(w t) at w = 0.2 w_1, xi = 10 % at w by mass.
std::vector<Quantity> bent_bar(const Bar& bar, double poisson, bool dynamic, int rows) {
    const fe::Mesh mesh = mesh_of(bar, rows);
    const fe::Solid solid{.modulus = 1.0, .poisson = poisson, .density = 1.0};
    const fe::System system = fe::assemble(mesh, solid, fe::Supports(mesh).clamp(fe::at_x(0.0)));
    const auto end = fe::boundary(mesh, fe::at_x(bar.length));
    const fe::Field load = fe::forces(mesh, end, 1.0, fe::uniform({0.0, 1.0 / bar.height}));

    const fe::Field rest = fe::solve_static(system, load);
    const double deflection = fe::mean_over(mesh, end, rest).y;
    std::vector<Quantity> quantities{{"end_deflection", "mean of u_y over the right end", deflection, {}}};
    if (!dynamic) {
        return quantities;
    }

    const double first = fe::first_frequency(system, rest);
    const double w = 0.2 * first;
    const fe::ComplexField moving = fe::solve_harmonic(system, load, w, 2.0 * 0.1 * w);
    const std::complex<double> amplitude{fe::mean_over(mesh, end, moving.real()).y,
                                         fe::mean_over(mesh, end, moving.imag()).y};
    quantities.push_back({"first_frequency", "first natural frequency w_1, rad/s", first, {}});
    quantities.push_back(
        {"amplitude_ratio", "steady amplitude over static deflection", std::abs(amplitude) / deflection, {}});
    quantities.push_back({"phase_lag", "of the end behind the force, rad", -std::arg(amplitude), {}});
    return quantities;
}

ReferenceCase cantilever(const std::string& name, const std::string& size, const Bar& bar, double poisson) {
    return {name,
            size,
            fmt::format("E = 1, nu = {}, density 1, thickness 1, plane stress", poisson),
            "left end clamped: u_x = u_y = 0",
            "unit force along y as uniform shear traction on the right end; dynamic: times sin(w t), w = 0.2 w_1, mass "
            "damping 2 xi w with xi = 0.1",
            {8, 16},
            bar_mesh,
            [=](int rows) { return bent_bar(bar, poisson, true, rows); }};
}

const double slant = std::tan(20.0 * degree);
constexpr const char* slanted_geometry =
    "parallelogram (0, 0), (6, 6 tan 20), (6, 6 tan 20 + 1), (0, 1): upright ends, long sides at 20 degrees";

ReferenceCase slanted_cantilever() {
    return {"slanted_cantilever",
            slanted_geometry,
            "E = 1, nu = 0.3, thickness 1, plane stress",
            "left end clamped: u_x = u_y = 0",
            "unit force along y as uniform traction on the right end",
            {12, 24},
            bar_mesh,
            [](int rows) {
                return bent_bar({6.0, 1.0, slant}, 0.3, false, rows);
            }};
}

// ---- bars under uniform tension ----

/// Pulled by the tractions of a unit tension along `axis` on both ends, without reactions in its three supports.
double pulled(const fe::Mesh& mesh, Vec2 axis, const fe::Place& left, const fe::Place& right, Vec2 corner, Vec2 other) {
    const fe::Solid solid{.modulus = 1.0, .poisson = 0.3};
    fe::Supports supports(mesh);
    supports.clamp(fe::at_point(corner)).hold_x(fe::at_point(other));
    const fe::Traction tension = [axis](Vec2, Vec2 outward) { return dot(axis, outward) * axis; };
    const auto start = fe::boundary(mesh, left);
    const auto end = fe::boundary(mesh, right);
    const fe::Field load = fe::forces(mesh, start, 1.0, tension) + fe::forces(mesh, end, 1.0, tension);
    const fe::Field u = fe::solve_static(fe::assemble(mesh, solid, supports), load);
    return dot(axis, fe::mean_over(mesh, end, u) - fe::mean_over(mesh, start, u));
}

std::vector<Quantity> elongation(double value, double closed_form) {
    return {{"elongation", "mean displacement of the right end less that of the left end, along the bar", value,
             closed_form}};
}

ReferenceCase turned_bar() {
    return {"turned_bar",
            "rectangle 6 x 1 turned by 20 degrees",
            "E = 1, nu = 0.3, thickness 1, plane stress",
            "rigid motions only",
            "unit tension along the bar on both ends",
            {2, 4},
            bar_mesh,
            [](int rows) {
                const Vec2 axis = turned({1.0, 0.0}, 20.0 * degree);
                const auto at = [axis](Vec2 p) { return p.x * axis + p.y * turned_left(axis); };
                const fe::Mesh mesh =
                    fe::block(fe::even(columns_per_row * rows), fe::even(rows), [&](double s, double t) {
                        return at({6.0 * s, t});
                    });
                const auto along = [axis](double x) {
                    return fe::Place([=](Vec2 p) { return std::fabs(dot(axis, p) - x) < fe::touching; });
                };
                return elongation(pulled(mesh, axis, along(0.0), along(6.0), {}, at({0.0, 1.0})), 6.0);
            }};
}

ReferenceCase slanted_tension() {
    return {
        "slanted_tension",
        slanted_geometry,
        "E = 1, nu = 0.3, thickness 1, plane stress",
        "rigid motions only",
        "uniform tractions of a unit tension along the long sides on both ends: (cos^2 20, sin 20 cos 20) on the right",
        {2, 4},
        bar_mesh,
        [](int rows) {
            const fe::Mesh mesh = mesh_of({6.0, 1.0, slant}, rows);
            const Vec2 axis = turned({1.0, 0.0}, 20.0 * degree);
            return elongation(pulled(mesh, axis, fe::at_x(0.0), fe::at_x(6.0), {0.0, -0.5}, {0.0, 0.5}), 6.0 / axis.x);
        }};
}

} // namespace

std::vector<ReferenceCase> bar_cases() {
    return {cantilever("paper_cantilever", "54 x 3 sqrt(3): R0 = 1", {54.0, 3.0 * std::numbers::sqrt3}, 0.3),
            cantilever("slab_cantilever", "10.4 x 1", {10.4, 1.0}, 0.3),
            cantilever("slab_cantilever_nu_0.2", "10.4 x 1", {10.4, 1.0}, 0.2),
            slanted_cantilever(),
            slanted_tension(),
            turned_bar()};
}

} // namespace demlua::test
