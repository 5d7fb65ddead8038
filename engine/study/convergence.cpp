#include "engine/study/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace demlua::study {

namespace {

constexpr double greatest_order = 30.0;
/// Differences below this share of the values are round-off.
constexpr double round_off = 1e-12;

/// (h1^p - h2^p) / (h2^p - h3^p), which rises with p from 0 to infinity.
double difference_ratio(double p, double log_coarse, double log_fine) {
    if (p == 0.0) return log_coarse / log_fine;
    return std::expm1(p * log_coarse) / -std::expm1(-p * log_fine);
}

} // namespace

std::optional<double> observed_order(const Levels& levels) {
    const auto& [coarse, middle, fine] = levels;
    const double largest = std::max({std::abs(coarse.value), std::abs(middle.value), std::abs(fine.value)});
    const double first = coarse.value - middle.value;
    const double second = middle.value - fine.value;
    if (std::min(std::abs(first), std::abs(second)) <= round_off * largest) return std::nullopt;
    const double wanted = first / second;
    if (!(wanted > 0.0) || !std::isfinite(wanted)) return std::nullopt;
    const double log_coarse = std::log(coarse.size / middle.size);
    const double log_fine = std::log(middle.size / fine.size);
    double low = -greatest_order;
    double high = greatest_order;
    if (difference_ratio(low, log_coarse, log_fine) > wanted || difference_ratio(high, log_coarse, log_fine) < wanted) {
        return std::nullopt;
    }
    for (int halving = 0; halving < 60; ++halving) {
        const double p = 0.5 * (low + high);
        (difference_ratio(p, log_coarse, log_fine) < wanted ? low : high) = p;
    }
    return 0.5 * (low + high);
}

std::optional<double> extrapolated(const Levels& levels) {
    const std::optional<double> p = observed_order(levels);
    if (!p || *p <= 0.0) return std::nullopt;
    const auto& [coarse, middle, fine] = levels;
    return fine.value + (fine.value - middle.value) / std::expm1(*p * std::log(middle.size / fine.size));
}

std::optional<double> order_between(const Sample& coarse, const Sample& fine) {
    if (coarse.value == 0.0 || fine.value == 0.0 || coarse.size == fine.size) return std::nullopt;
    return std::log(std::abs(coarse.value / fine.value)) / std::log(coarse.size / fine.size);
}

std::optional<PowerLaw> fitted_power(const std::vector<Sample>& samples) {
    std::vector<double> x;
    std::vector<double> y;
    for (const Sample& sample : samples) {
        if (sample.value == 0.0) continue;
        x.push_back(std::log(sample.size));
        y.push_back(std::log(std::abs(sample.value)));
    }
    if (x.size() < 2) return std::nullopt;
    const double x_mean = mean(x);
    const double y_mean = mean(y);
    double square = 0.0;
    double product = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        square += (x[k] - x_mean) * (x[k] - x_mean);
        product += (x[k] - x_mean) * (y[k] - y_mean);
    }
    if (square == 0.0) return std::nullopt;
    const double exponent = product / square;
    return PowerLaw{std::exp(y_mean - exponent * x_mean), exponent};
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<double> standard_deviation(const std::vector<double>& values) {
    if (values.size() < 2) return std::nullopt;
    const double middle = mean(values);
    double square = 0.0;
    for (const double value : values) square += (value - middle) * (value - middle);
    return std::sqrt(square / static_cast<double>(values.size() - 1));
}

double relative_error(double value, double reference) {
    return reference == 0.0 ? value : (value - reference) / std::abs(reference);
}

} // namespace demlua::study
