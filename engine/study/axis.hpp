// A logarithmic axis: its ends, its ticks, and how they are written.
#pragma once

#include <string>
#include <vector>

namespace demlua::study {

struct Tick {
    double value = 0.0;
    std::string label; ///< empty for the small ticks between
};

struct Axis {
    double low = 1.0; ///< positive
    double high = 10.0;
    std::vector<Tick> ticks;
};

/// Covers all `values` (positive) with some room at both ends. Labels stand at powers of ten over three decades or more, at
/// 1, 2, 5 below.
Axis axis_over(const std::vector<double>& values);

/// 0.001, 20, 1e-6: as short as it can be written.
std::string tick_text(double value);

} // namespace demlua::study
