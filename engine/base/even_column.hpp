// A column of numbers that are often all the same.
#pragma once

#include "engine/base/column.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace demlua {

/// Where the rows of such a column begin; null where all hold `same`.
struct EvenRows {
    const double* column;
    double same;

    template <class Lane>
    [[nodiscard]] typename Lane::Number load(std::size_t row) const {
        if (column == nullptr) return same;
        return Lane::load(column + row);
    }
};

class EvenColumn {
public:
    void push_back(double value) { values_.push_back(value); }
    void set(std::size_t row, double value) { values_[row] = value; }
    [[nodiscard]] double operator[](std::size_t row) const { return even_ ? same_ : values_[row]; }
    [[nodiscard]] bool even() const { return even_; }
    [[nodiscard]] EvenRows rows() const { return {even_ ? nullptr : values_.data(), same_}; }
    /// `count` rows in a column of their own.
    [[nodiscard]] Column<double> spread(std::size_t count) const {
        return even_ ? Column<double>(count, same_) : values_;
    }

    /// Keeps one number for all rows if none is farther from their mean than `apart` of it. No row may be set after that.
    void even_out(double apart) {
        if (values_.empty()) return;
        const auto [least, most] = std::minmax_element(values_.begin(), values_.end());
        const double middle = 0.5 * (*least + *most);
        if (*most - *least > 2.0 * apart * std::fabs(middle)) return;
        same_ = middle;
        even_ = true;
        values_ = {};
    }

private:
    Column<double> values_;
    double same_ = 0.0;
    bool even_ = false;
};

} // namespace demlua
