// A quantity that varies with time: piecewise linear between samples, constant before the first and after the last.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace demlua {

/// Samples at strictly rising `times` (s); at least one. The unit of `values` is that of the load it stands for.
struct Signal {
    std::vector<double> times{0.0};
    std::vector<double> values{0.0};

    static Signal constant(double value) { return {{0.0}, {value}}; }

    [[nodiscard]] double at(double time) const {
        const auto above = std::upper_bound(times.begin(), times.end(), time);
        if (above == times.begin()) return values.front();
        if (above == times.end()) return values.back();
        const auto k = static_cast<std::size_t>(std::distance(times.begin(), above));
        const double share = (time - times[k - 1]) / (times[k] - times[k - 1]);
        return values[k - 1] + share * (values[k] - values[k - 1]);
    }
};

} // namespace demlua
