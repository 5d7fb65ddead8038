// Closed forms of fracture against published numbers, limits and conservation laws; and their copy for scenes.
#include "tests/catch.hpp"
#include "tests/handbook.hpp"
#include "tests/scene_language.hpp"
#include "tests/squeezed_ring.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace demlua;
using Catch::Approx;
namespace handbook = test::handbook;

namespace {

constexpr double pi = handbook::pi;
constexpr double degree = pi / 180.0;

} // namespace

TEST_CASE("handbook: shapes against numerical solutions") {
    // Isida 1973 (Murakami, 1.1), shares 0.1 to 0.9.
    const std::array<double, 9> isida{1.0060, 1.0246, 1.0577, 1.1094, 1.1867, 1.3033, 1.4882, 1.8160, 2.5776};
    for (std::size_t k = 0; k < isida.size(); ++k) {
        CHECK(handbook::centre_crack(0.1 * static_cast<double>(k + 1)) == Approx(isida[k]).epsilon(1e-3));
    }
    // Kaya & Erdogan 1987, shares 0.1 to 0.5.
    const std::array<double, 5> kaya{1.1892, 1.3673, 1.6599, 2.1114, 2.8246};
    for (std::size_t k = 0; k < kaya.size(); ++k) {
        CHECK(handbook::edge_crack(0.1 * static_cast<double>(k + 1)) == Approx(kaya[k]).epsilon(6e-3));
        CHECK(handbook::edge_crack_polynomial(0.1 * static_cast<double>(k + 1)) == Approx(kaya[k]).epsilon(1e-2));
    }
    // A half plane has 1.1215 (Koiter 1965); deep notches K_I = P / sqrt(pi b), 2 b the ligament (Tada).
    CHECK(handbook::edge_crack(1e-6) == Approx(1.1215).epsilon(1e-3));
    CHECK(handbook::double_edge_crack(1e-6) == Approx(1.1215).epsilon(1e-3));
    const double share = 0.9999;
    CHECK(handbook::double_edge_crack(share) * std::sqrt(1.0 - share) == Approx(2.0 / pi).epsilon(6e-3));
    // ASTM E399, f(a / W) as tabled.
    for (const auto& [at, f] : std::array<std::array<double, 2>, 3>{{{0.45, 2.29}, {0.50, 2.66}, {0.55, 3.14}}}) {
        CHECK(handbook::three_point_bend(at) * 1.5 * std::sqrt(pi * at) == Approx(f).margin(5e-3));
    }
}

TEST_CASE("handbook: a slanted crack kinks where no shear is left, as Erdogan and Sih have it") {
    CHECK(handbook::slanted_critical_stress(2.0, 3.0, 0.0) == Approx(handbook::critical_stress(2.0, 3.0, 1.0)));
    CHECK(handbook::kink_angle({0.0, 1.0}) / degree == Approx(-70.5288).margin(1e-4));
    CHECK(handbook::hoop_intensity({0.0, 1.0}) == Approx(2.0 / std::sqrt(3.0)));
    for (const double angle : {10.0, 30.0, 45.0, 60.0, 80.0}) {
        const handbook::Intensities k = handbook::slanted_crack(1.0, 1.0, angle * degree);
        const double t = handbook::kink_angle(k);
        CHECK(k.opening * std::sin(t) + k.sliding * (3.0 * std::cos(t) - 1.0) == Approx(0.0).margin(1e-12));
        CHECK(handbook::hoop_intensity(k) > k.opening);
    }
}

TEST_CASE("handbook: Dugdale's plate tends to the strength and to linear fracture mechanics") {
    CHECK(handbook::plateau_wide_plate(1e-2) == Approx(1.0));
    CHECK(handbook::plateau_wide_plate(1e4) == Approx(1e-2).epsilon(1e-3)); // K_Ic / sqrt(pi a) over s = sqrt(a_t / a)
}

TEST_CASE("handbook: the disc's tension is that of the series, the spall keeps the pulse's momentum") {
    const double half_angle = 12.0 * degree;
    const double pressure = test::arc_pressure(1.0, 0.5, half_angle); // of a unit force on a disc of diameter 1
    CHECK(handbook::disc_tension(1.0, 1.0, half_angle) == Approx(test::centre_stress(pressure, half_angle).hoop));
    CHECK(handbook::disc_tension(1.0, 1.0, 0.0) == Approx(handbook::disc_tension(1.0, 1.0, 1e-4)));

    const double stress = 3.0;
    const double length = 0.2;
    const double impedance = 7.0;
    const double strength = 1.25;
    const handbook::Spall block = handbook::spall_of_block(stress, length, impedance);
    CHECK(block.thickness * block.speed * impedance == Approx(stress * length));
    // Twice its thickness of the pulse's front are trapped; their mean stress is that half way.
    const handbook::Spall ramp = handbook::spall_of_ramp(stress, length, impedance, strength);
    const double mean = stress * (1.0 - ramp.thickness / length);
    CHECK(ramp.thickness * ramp.speed * impedance == Approx(2.0 * ramp.thickness * mean));
}

TEST_CASE("handbook: scenarios/shared/handbook.lua says the same", "[scene]") {
    struct Row {
        const char* lua;
        double value;
    };
    const handbook::Intensities k = handbook::slanted_crack(2.0, 3.0, 0.4);
    const handbook::Spall block = handbook::spall_of_block(3.0, 0.2, 7.0);
    const handbook::Spall ramp = handbook::spall_of_ramp(3.0, 0.2, 7.0, 1.25);
    const std::vector<Row> rows{
        {"edge_crack_polynomial(0.3)", handbook::edge_crack_polynomial(0.3)},
        {"edge_crack(0.3)", handbook::edge_crack(0.3)},
        {"centre_crack(0.3)", handbook::centre_crack(0.3)},
        {"double_edge_crack(0.3)", handbook::double_edge_crack(0.3)},
        {"three_point_bend(0.3)", handbook::three_point_bend(0.3)},
        {"critical_stress(2, 3, 1.5)", handbook::critical_stress(2.0, 3.0, 1.5)},
        {"three_point_bend_force(2, 3, 7)", handbook::three_point_bend_force(2.0, 3.0, 7.0)},
        {"transition_length(2, 3)", handbook::transition_length(2.0, 3.0)},
        {"slanted_crack(2, 3, 0.4)", k.opening},
        {"kink_angle(handbook.slanted_crack(2, 3, 0.4))", handbook::kink_angle(k)},
        {"hoop_intensity(handbook.slanted_crack(2, 3, 0.4))", handbook::hoop_intensity(k)},
        {"slanted_critical_stress(2, 3, 0.4)", handbook::slanted_critical_stress(2.0, 3.0, 0.4)},
        {"plateau_wide_plate(2)", handbook::plateau_wide_plate(2.0)},
        {"disc_tension(2, 3, 0.2)", handbook::disc_tension(2.0, 3.0, 0.2)},
        {"disc_tension(2, 3, 0)", handbook::disc_tension(2.0, 3.0, 0.0)},
        {"spall_of_block(3, 0.2, 7)", block.thickness},
        {"spall_of_ramp(3, 0.2, 7, 1.25)", ramp.thickness},
        {"transition_length(select(2, handbook.spall_of_block(3, 0.2, 7)), 1)",
         handbook::transition_length(block.speed, 1.0)},
        {"transition_length(select(2, handbook.spall_of_ramp(3, 0.2, 7, 1.25)), 1)",
         handbook::transition_length(ramp.speed, 1.0)}};
    std::string text = "local handbook = dem.include \"" +
                       (test::source_folder / "scenarios/shared/handbook.lua").string() + "\" {}\n";
    for (std::size_t n = 0; n < rows.size(); ++n) {
        text += fmt::format("dem.param {{ p{} = (handbook.{}) }}\n", n, rows[n].lua);
    }
    const scripting::SceneSummary summary = test::checked(text + "local sim = dem.simulation {}\n");
    REQUIRE(summary.parameters.size() == rows.size());
    for (std::size_t n = 0; n < rows.size(); ++n) {
        INFO(rows[n].lua);
        CHECK(std::get<double>(summary.parameters[n].fallback) == Approx(rows[n].value).epsilon(1e-12));
    }
}
