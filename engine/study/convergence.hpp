// How fast a quantity settles as elements get smaller, and where it is going: the order of convergence and Richardson's
// extrapolation (Tavarez & Plesha 2007, eqs 20 and 38), and the statistics of repeated runs.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace demlua::study {

/// A value (a quantity or its error) found at an element size. Sizes are positive, in m or whatever the study varies.
struct Sample {
    double size = 0.0;
    double value = 0.0;
};

/// Three levels, coarse to fine: sizes strictly fall.
using Levels = std::array<Sample, 3>;

/// The order p of f(h) = f0 + C h^p through three levels, the one solution of
///   (f1 - f2) / (f2 - f3) = (h1^p - h2^p) / (h2^p - h3^p).
/// For a constant ratio r = h1/h2 = h2/h3 that is eq 20, p = log((f1 - f2) / (f2 - f3)) / log r. Negative where
/// differences grow. Nothing when values swing to and fro, do not change beyond round-off, or |p| would pass 30.
std::optional<double> observed_order(const Levels& levels);

/// f0 of the same, f3 + (f3 - f2) / ((h2/h3)^p - 1); for a constant ratio that is eq 38,
/// (f1 f3 - f2^2) / (f1 - 2 f2 + f3). Nothing where there is no positive order.
std::optional<double> extrapolated(const Levels& levels);

/// The order from the errors of two levels, log(e1/e2) / log(h1/h2). Nothing when an error is zero or the sizes are the same.
std::optional<double> order_between(const Sample& coarse, const Sample& fine);

/// e(h) = factor h^exponent.
struct PowerLaw {
    double factor = 0.0;
    double exponent = 0.0;
};

/// The least-squares straight line through log |value| over log size; zero values are left out. Nothing with fewer than
/// two sizes.
std::optional<PowerLaw> fitted_power(const std::vector<Sample>& samples);

/// Of at least one value.
double mean(const std::vector<double>& values);
/// The sample standard deviation (n - 1 in the denominator); nothing for fewer than two values.
std::optional<double> standard_deviation(const std::vector<double>& values);

/// (value - reference) / |reference|, or the plain difference where the reference is zero.
double relative_error(double value, double reference);

} // namespace demlua::study
