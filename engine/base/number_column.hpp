// A column of numbers that takes no more room than they need: one number where all are the same, single precision where
// that is asked for.
#pragma once

#include "engine/base/column.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace demlua {

/// Where the rows of such a column begin, for loops that only read. One pointer is set, or none where all hold `same`.
struct NumberRows {
    const double* wide = nullptr;
    const float* narrow = nullptr;
    double same = 0.0;

    template <class Lane>
    [[nodiscard]] typename Lane::Number load(std::size_t row) const {
        if (wide != nullptr) return Lane::load(wide + row);
        if (narrow != nullptr) return Lane::load(narrow + row);
        return same;
    }
    /// Of the rows that `picked` names.
    template <class Picked>
    [[nodiscard]] auto pick(const Picked& picked) const {
        return narrow != nullptr ? picked.of(narrow) : picked.of(wide);
    }
};

/// The same for loops that write.
struct NumberTargets {
    double* wide = nullptr;
    float* narrow = nullptr;

    template <class Lane>
    [[nodiscard]] typename Lane::Number load(std::size_t row) const {
        return wide != nullptr ? Lane::load(wide + row) : Lane::load(narrow + row);
    }
    template <class Lane>
    void store(std::size_t row, typename Lane::Number value) const {
        wide != nullptr ? Lane::store(wide + row, value) : Lane::store(narrow + row, value);
    }
};

/// Filled in double precision; then it may be evened out, or kept in single precision, but not grown any more.
class NumberColumn {
public:
    void push_back(double value) { wide_.push_back(value); }
    void reserve(std::size_t rows) { wide_.reserve(rows); }
    void resize(std::size_t rows) { wide_.resize(rows); }
    void clear() { *this = {}; }

    [[nodiscard]] bool empty() const { return wide_.empty() && narrow_.empty() && !even_; }
    [[nodiscard]] bool even() const { return even_; }
    [[nodiscard]] double operator[](std::size_t row) const {
        if (even_) return same_;
        return narrow_.empty() ? wide_[row] : static_cast<double>(narrow_[row]);
    }
    void set(std::size_t row, double value) {
        if (narrow_.empty())
            wide_[row] = value;
        else
            narrow_[row] = static_cast<float>(value);
    }
    [[nodiscard]] NumberRows rows() const {
        if (even_) return {nullptr, nullptr, same_};
        return {narrow_.empty() ? wide_.data() : nullptr, narrow_.empty() ? nullptr : narrow_.data(), 0.0};
    }
    [[nodiscard]] NumberTargets targets() {
        return {narrow_.empty() ? wide_.data() : nullptr, narrow_.empty() ? nullptr : narrow_.data()};
    }
    /// `count` rows in a column of their own.
    [[nodiscard]] Column<double> spread(std::size_t count) const {
        Column<double> all(count);
        for (std::size_t row = 0; row < count; ++row) all[row] = (*this)[row];
        return all;
    }

    /// Keeps one number for all rows if none is farther from their mean than `apart` of it. No row may be set after that.
    void even_out(double apart) {
        if (wide_.empty()) return;
        const auto [least, most] = std::minmax_element(wide_.begin(), wide_.end());
        const double middle = 0.5 * (*least + *most);
        if (*most - *least > 2.0 * apart * std::fabs(middle)) return;
        same_ = middle;
        even_ = true;
        wide_ = {};
    }
    /// Rounds every row to single precision, now and whenever it is set.
    void keep_single() {
        if (wide_.empty()) return;
        narrow_.assign(wide_.size(), 0.0F);
        std::transform(wide_.begin(), wide_.end(), narrow_.begin(),
                       [](double wide) { return static_cast<float>(wide); });
        wide_ = {};
    }

private:
    Column<double> wide_;
    Column<float> narrow_;
    double same_ = 0.0;
    bool even_ = false;
};

} // namespace demlua
