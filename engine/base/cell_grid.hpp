// Near pairs among points of the plane, found through square cells; the order of the pairs depends on the
// points alone.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/vec2.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace demlua {

/// Points sorted by cell (a counting sort: cells row by row, points of one cell in rising index). Build anew
/// whenever the points have moved; memory is kept from one build to the next.
class CellGrid {
public:
    /// `points` must be finite; `cell` is the least side of a cell, m, above zero: it bounds the reach of the
    /// searches that follow. Cells are made larger where the points are so sparse that most would be empty.
    void build(std::span<const Vec2> points, double cell) {
        points_.assign(points.begin(), points.end());
        lay_out(cell);
        cell_of_.resize(points_.size());
        first_.assign(columns_ * rows_ + 1, 0);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            cell_of_[i] = row_of(points_[i]) * columns_ + column_of(points_[i]);
            ++first_[cell_of_[i] + 1];
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        order_.resize(points_.size());
        std::vector<Index> next(first_.begin(), first_.end() - 1);
        for (std::size_t i = 0; i < points_.size(); ++i) order_[next[cell_of_[i]]++] = static_cast<Index>(i);
    }

    /// Indices of the points, cell after cell.
    [[nodiscard]] const std::vector<Index>& order() const { return order_; }

    /// Calls `f(i, j)` once for every pair of points at most `reach` (m, not above `cell`) apart. The pairs
    /// of one `i` come in a row, the `i` in the order of `order()`; either index may be the smaller.
    template <class F>
    void for_each_pair(double reach, const F& f) const {
        for_each_pair_of(0, points_.size(), reach, f);
    }

    /// Those of the `i` that stand in `order()` from `begin` to `end`.
    template <class F>
    void for_each_pair_of(std::size_t begin, std::size_t end, double reach, const F& f) const {
        while (begin < end) {
            const std::size_t cell = cell_of_[order_[begin]];
            const std::size_t stop = std::min<std::size_t>(end, first_[cell + 1]);
            pairs_within_cell(cell, begin, stop, reach, f);
            begin = stop;
        }
    }

    /// Calls `f(i)` once for every point at most `reach` (m) from the segment from `a` to `b`, and for others near it.
    template <class F>
    void for_each_near(Vec2 a, Vec2 b, double reach, const F& f) const {
        const std::size_t last = cell_at(std::max(a.y, b.y) + reach - origin_.y, rows_);
        for (std::size_t row = cell_at(std::min(a.y, b.y) - reach - origin_.y, rows_); row <= last; ++row) {
            const double bottom = origin_.y + static_cast<double>(row) * side_;
            const auto [left, right] = stretch_between(a, b, bottom - reach, bottom + side_ + reach);
            const std::size_t first_column = cell_at(left - reach - origin_.x, columns_);
            const std::size_t last_column = cell_at(right + reach - origin_.x, columns_);
            const std::size_t end = first_[row * columns_ + last_column + 1];
            for (std::size_t k = first_[row * columns_ + first_column]; k < end; ++k) f(order_[k]);
        }
    }

private:
    /// The cell in which a coordinate (m from the origin) lies, or the first or last of `count`.
    [[nodiscard]] std::size_t cell_at(double coordinate, std::size_t count) const {
        const double most = static_cast<double>(count - 1);
        return static_cast<std::size_t>(std::clamp(std::floor(coordinate / side_), 0.0, most));
    }

    /// Least and greatest x of what a segment has between two heights, or of where it comes nearest to them.
    static std::pair<double, double> stretch_between(Vec2 a, Vec2 b, double bottom, double top) {
        const double rise = b.y - a.y;
        if (rise == 0.0) return {std::min(a.x, b.x), std::max(a.x, b.x)};
        const double one = a.x + std::clamp((bottom - a.y) / rise, 0.0, 1.0) * (b.x - a.x);
        const double other = a.x + std::clamp((top - a.y) / rise, 0.0, 1.0) * (b.x - a.x);
        return {std::min(one, other), std::max(one, other)};
    }

    void lay_out(double cell) {
        Box box{{0.0, 0.0}, {0.0, 0.0}};
        if (!points_.empty()) box = {points_.front(), points_.front()};
        for (const Vec2 p : points_) {
            box.lower = {std::min(box.lower.x, p.x), std::min(box.lower.y, p.y)};
            box.upper = {std::max(box.upper.x, p.x), std::max(box.upper.y, p.y)};
        }
        origin_ = box.lower;
        side_ = cell;
        const double most = 4.0 * static_cast<double>(points_.size()) + 16.0;
        const Vec2 size = box.size();
        while ((size.x / side_ + 1.0) * (size.y / side_ + 1.0) > most) side_ *= 2.0;
        columns_ = static_cast<std::size_t>(size.x / side_) + 1;
        rows_ = static_cast<std::size_t>(size.y / side_) + 1;
    }

    [[nodiscard]] std::size_t column_of(Vec2 p) const {
        return std::min(static_cast<std::size_t>((p.x - origin_.x) / side_), columns_ - 1);
    }
    [[nodiscard]] std::size_t row_of(Vec2 p) const {
        return std::min(static_cast<std::size_t>((p.y - origin_.y) / side_), rows_ - 1);
    }

    /// Pairs of points `begin` to `end` of one cell with those after them in the cell, and with the four neighbours that come
    /// after it: right, and the three above.
    template <class F>
    void pairs_within_cell(std::size_t cell, std::size_t begin, std::size_t end, double reach, const F& f) const {
        const std::size_t row = cell / columns_;
        const std::size_t column = cell % columns_;
        const std::size_t left = column == 0 ? 0 : column - 1;
        const std::size_t right = std::min(column + 1, columns_ - 1);
        const std::size_t end_of_row = first_[row * columns_ + right + 1];
        const bool last_row = row + 1 == rows_;
        const std::size_t above = last_row ? 0 : first_[(row + 1) * columns_ + left];
        const std::size_t end_above = last_row ? 0 : first_[(row + 1) * columns_ + right + 1];
        for (std::size_t k = begin; k < end; ++k) {
            pairs_of_point(k, k + 1, end_of_row, reach, f);
            pairs_of_point(k, above, end_above, reach, f);
        }
    }

    template <class F>
    void pairs_of_point(std::size_t k, std::size_t begin, std::size_t end, double reach, const F& f) const {
        const Index i = order_[k];
        for (std::size_t n = begin; n < end; ++n) {
            const Index j = order_[n];
            const Vec2 between = points_[j] - points_[i];
            if (dot(between, between) <= reach * reach) f(i, j);
        }
    }

    std::vector<Vec2> points_;
    std::vector<std::size_t> cell_of_;
    std::vector<Index> first_; ///< where each cell begins in `order_`, and the end
    std::vector<Index> order_;
    Vec2 origin_;
    double side_ = 1.0;
    std::size_t columns_ = 1;
    std::size_t rows_ = 1;
};

} // namespace demlua
