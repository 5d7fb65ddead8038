// The cohesive crack against closed forms: before it judges fracture, it is judged.
#include "tests/catch.hpp"
#include "tests/cohesive_crack.hpp"
#include "tests/handbook.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

using namespace demlua;
using Catch::Approx;
using test::Growth;
using test::Ligament;
using test::NotchedBody;
using test::Softening;
namespace handbook = test::handbook;

namespace {

constexpr test::LigamentMesh coarse{.cell = 0.2, .reach = 5.0, .growth = 1.4};
constexpr double pi = handbook::pi;

Growth peak_of(const Ligament& ligament, Softening shape) { return test::peak(test::grow(ligament, shape), shape); }

/// Half of a wide plate with a crack of length 2 a in its middle.
NotchedBody wide_plate(double a, double half_width) {
    return {.notch = a, .width = half_width, .half_height = 2.0 * half_width, .mirror_at_start = true};
}

/// How much longer a crack without a zone would have to be to grow at the load `peak`.
double effective_growth(const Ligament& ligament, double peak) {
    const double wanted = pi / (peak * peak); // K_I^2 under a unit load
    for (int corner = 4; static_cast<std::size_t>(corner) + 2 < ligament.x.size(); corner += 2) {
        const double before = std::pow(test::stress_intensity(ligament, corner - 2), 2);
        const double after = std::pow(test::stress_intensity(ligament, corner), 2);
        if (after > wanted) {
            const auto at = static_cast<std::size_t>(corner);
            const double share = (wanted - before) / (after - before);
            return ligament.x[at - 2] + share * (ligament.x[at] - ligament.x[at - 2]) - ligament.x.front();
        }
    }
    FAIL("the peak lies beyond the fine part of the ligament");
    return 0.0;
}

} // namespace

TEST_CASE("cohesive crack: a bar without a notch yields at its strength") {
    const NotchedBody bar{.width = 4.0, .half_height = 8.0};
    const double at_first_yield = 2.0;
    const std::vector<Growth> states = test::grow(test::condense(bar, coarse), Softening::linear, at_first_yield);
    CHECK(states.front().load == Approx(1.0).epsilon(1e-9));
}

TEST_CASE("cohesive crack: handbook stress intensities by energy release") {
    struct Shape {
        const char* name;
        NotchedBody body;
        double (*shape)(double share);
        double tolerance; // what the formula is good to, and 0.3 % for cells of 1/40 of the crack
    };
    const NotchedBody edge{.notch = 1.2, .width = 4.0, .half_height = 8.0};
    const NotchedBody centre{.notch = 0.6, .width = 2.0, .half_height = 8.0, .mirror_at_start = true};
    const NotchedBody double_edge{.notch = 0.6, .width = 2.0, .half_height = 8.0, .mirror_at_end = true};
    const NotchedBody bent{.notch = 1.2, .width = 4.0, .half_height = 9.0, .load = NotchedBody::Load::bending};
    const std::vector<Shape> shapes{{"edge", edge, handbook::edge_crack, 8e-3},
                                    {"edge, polynomial", edge, handbook::edge_crack_polynomial, 8e-3},
                                    {"centre", centre, handbook::centre_crack, 4e-3},
                                    {"double edge", double_edge, handbook::double_edge_crack, 11e-3},
                                    {"bend", bent, handbook::three_point_bend, 11e-3}};
    for (const Shape& one : shapes) {
        INFO(one.name);
        const Ligament ligament = test::condense(one.body, {.cell = 0.03, .reach = 0.6, .growth = 1.4});
        const std::size_t corner = 10;
        const double a = ligament.x[corner];
        const double shape = test::stress_intensity(ligament, static_cast<int>(corner)) / std::sqrt(pi * a);
        CHECK(shape == Approx(one.shape(a / one.body.width)).epsilon(one.tolerance));
    }
}

TEST_CASE("cohesive crack: constant traction in a wide plate against Dugdale's closed form") {
    // As wide as 40 cracks, which with its zone is a share of 0.05: pi^2 / 16 of its square, 1.5e-3, is the secant's excess.
    const Ligament ligament = test::condense(wide_plate(2.0, 80.0), {.cell = 0.1, .reach = 4.0, .growth = 1.4});
    CHECK(peak_of(ligament, Softening::plateau).load == Approx(handbook::plateau_wide_plate(2.0)).epsilon(2.5e-3));
}

TEST_CASE("cohesive crack: long cracks grow where one longer by a share of E G / s^2 would") {
    // As the zone becomes small against everything else: pi / 24 for the constant traction, as Dugdale's zone of pi / 8 counts
    // by a third; 0.419 for the linear one (Bazant & Planas, Fracture and Size Effect, 1998, chapter 7).
    const double length = pi; // E G / s^2 in a_t
    const Ligament ligament = test::condense(wide_plate(50.0, 400.0), {.cell = 0.1, .reach = 4.0, .growth = 1.4});
    // A load off by 5e-4 shifts the length by 2 x 50 x 5e-4.
    CHECK(effective_growth(ligament, peak_of(ligament, Softening::linear).load) == Approx(0.419 * length).margin(0.05));
    CHECK(effective_growth(ligament, peak_of(ligament, Softening::plateau).load) ==
          Approx(pi / 24.0 * length).margin(0.05));
}

TEST_CASE("cohesive crack: the notch opens as the zone grows, and the load has one peak") {
    const NotchedBody plate{.notch = 2.0, .width = 8.0, .half_height = 16.0};
    const std::vector<Growth> states = test::grow(test::condense(plate, coarse), Softening::linear, 0.9);
    int turns = 0;
    for (std::size_t k = 1; k < states.size(); ++k) {
        CHECK(states[k].opening > states[k - 1].opening);
        if (k > 1 && (states[k].load > states[k - 1].load) != (states[k - 1].load > states[k - 2].load)) {
            ++turns;
        }
    }
    CHECK(turns == 1);
}
