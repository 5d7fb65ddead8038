// Orders, extrapolation and statistics against sequences whose law is known.
#include "engine/study/convergence.hpp"
#include "tests/catch.hpp"

#include <cmath>

using namespace demlua;
using Catch::Approx;
using study::Levels;

namespace {

/// f(h) = limit + factor h^order at three sizes.
Levels levels_of(double limit, double factor, double order, std::array<double, 3> sizes) {
    Levels levels;
    for (std::size_t k = 0; k < 3; ++k) levels[k] = {sizes[k], limit + factor * std::pow(sizes[k], order)};
    return levels;
}

} // namespace

TEST_CASE("the order and the limit of a power law are found again, whatever the sizes", "[study]") {
    for (const double order : {0.5, 1.0, 1.52, 2.0, 3.0}) {
        for (const auto& sizes : {std::array{0.8, 0.4, 0.2}, std::array{0.9, 0.3, 0.2}, std::array{1.0, 0.9, 0.1}}) {
            for (const double factor : {-2.0, 0.7}) {
                const Levels levels = levels_of(3.0, factor, order, sizes);
                // Round-off of 1e-16 in values near 3 against differences of at least 1e-2.
                CHECK(study::observed_order(levels).value() == Approx(order).epsilon(1e-8));
                CHECK(study::extrapolated(levels).value() == Approx(3.0).epsilon(1e-10));
            }
        }
    }
}

TEST_CASE("with a constant ratio it is eqs 20 and 38 of the paper", "[study]") {
    // Static tip compliances of a close-packed cantilever at sizes 9, 3, 1.
    const double f1 = 5364.13;
    const double f2 = 4640.19;
    const double f3 = 4541.75;
    const Levels levels{{{9.0, f1}, {3.0, f2}, {1.0, f3}}};
    CHECK(study::observed_order(levels).value() == Approx(std::log((f1 - f2) / (f2 - f3)) / std::log(3.0)));
    CHECK(study::extrapolated(levels).value() == Approx((f1 * f3 - f2 * f2) / (f1 - 2.0 * f2 + f3)));
}

TEST_CASE("there is no order where values swing, stand still or run away", "[study]") {
    CHECK_FALSE(study::observed_order({{{4.0, 1.0}, {2.0, 3.0}, {1.0, 2.0}}}).has_value());
    CHECK_FALSE(study::observed_order({{{4.0, 1.0}, {2.0, 1.0}, {1.0, 1.0 + 1e-15}}}).has_value());
    const Levels growing{{{4.0, 1.0}, {2.0, 2.0}, {1.0, 4.0}}};
    CHECK(study::observed_order(growing).value() == Approx(-1.0));
    CHECK_FALSE(study::extrapolated(growing).has_value());
    const Levels even{{{4.0, 1.0}, {2.0, 2.0}, {1.0, 3.0}}}; // f = a - log2 h, the limit p = 0
    CHECK(std::abs(study::observed_order(even).value()) < 1e-12);
}

TEST_CASE("errors give an order of their own and a slope", "[study]") {
    CHECK(study::order_between({0.3, -0.09}, {0.1, 0.01}).value() == Approx(2.0));
    CHECK_FALSE(study::order_between({0.3, 0.1}, {0.1, 0.0}).has_value());
    const auto law = study::fitted_power({{0.4, 0.48}, {0.2, -0.12}, {0.1, 0.03}, {0.05, 0.0}});
    REQUIRE(law.has_value());
    CHECK(law->exponent == Approx(2.0));
    CHECK(law->factor == Approx(3.0));
    CHECK_FALSE(study::fitted_power({{0.1, 1.0}, {0.1, 2.0}}).has_value());
}

TEST_CASE("mean, sample standard deviation and relative error", "[study]") {
    CHECK(study::mean({1.0, 2.0, 6.0}) == 3.0);
    CHECK(study::standard_deviation({1.0, 2.0, 6.0}).value() == Approx(std::sqrt(7.0)));
    CHECK_FALSE(study::standard_deviation({1.0}).has_value());
    CHECK(study::relative_error(3.0, -2.0) == 2.5);
    CHECK(study::relative_error(3.0, 0.0) == 3.0);
}
