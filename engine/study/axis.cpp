#include "engine/study/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace demlua::study {

namespace {

/// Room beyond the outermost values, as a share of the axis in decades and at least so many decades.
constexpr double room_share = 0.06;
constexpr double least_room = 0.08;
/// An axis with fewer labels than two would tell nothing.
constexpr double least_decades = 0.7;

} // namespace

std::string tick_text(double value) {
    const double power = std::log10(value);
    if (power > -4.5 && power < 4.5) return fmt::format("{:.6g}", value);
    const double whole = std::floor(power + 1e-9);
    return fmt::format("{:.0f}e{:.0f}", value / std::pow(10.0, whole), whole);
}

Axis axis_over(const std::vector<double>& values) {
    if (values.empty()) return {};
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    double low = std::log10(*least);
    double high = std::log10(*greatest);
    const double missing = std::max(0.0, least_decades - (high - low));
    const double room = std::max(least_room, room_share * (high - low)) + missing / 2.0;
    low -= room;
    high += room;
    Axis axis{std::pow(10.0, low), std::pow(10.0, high), {}};
    const bool wide = high - low >= 3.0;
    const int last = static_cast<int>(std::floor(high));
    for (int decade = static_cast<int>(std::floor(low)); decade <= last; ++decade) {
        for (int digit = 1; digit <= 9; ++digit) {
            const double value = digit * std::pow(10.0, decade);
            if (value < axis.low || value > axis.high) continue;
            const bool labelled = digit == 1 || (!wide && (digit == 2 || digit == 5));
            axis.ticks.push_back({value, labelled ? tick_text(value) : ""});
        }
    }
    return axis;
}

} // namespace demlua::study
