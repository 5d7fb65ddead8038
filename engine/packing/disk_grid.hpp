// Disks put down one after another, found again by place.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace demlua::packing {

/// Square cells over a box, each with a chain of its disks; columns of cells know the highest.
class DiskGrid {
public:
    /// Disks of at most `largest` radius (m) with their centres in `box`, which is finite and not empty.
    DiskGrid(const Box& box, double largest) : box_(box), largest_(largest) {
        constexpr double most = 4e6; // cells
        const Vec2 size = box.size();
        side_ = std::max(2.0 * largest, std::sqrt(size.x * size.y / most));
        columns_ = static_cast<std::size_t>(size.x / side_) + 1;
        rows_ = static_cast<std::size_t>(size.y / side_) + 1;
        last_.assign(columns_ * rows_, none);
        tops_.assign(columns_, -std::numeric_limits<double>::infinity());
    }

    void add(const model::Disk& disk) {
        const std::size_t column = column_of(disk.centre.x);
        Index& last = last_[row_of(disk.centre.y) * columns_ + column];
        before_.push_back(last);
        last = static_cast<Index>(disks_.size());
        disks_.push_back(disk);
        tops_[column] = std::max(tops_[column], disk.centre.y + disk.radius);
    }

    /// Calls `f(disk)` for every disk less than `gap` (m) away from a circle of `radius` (m) about `point`.
    template <class F>
    void for_each_near(Vec2 point, double radius, double gap, const F& f) const {
        const double reach = radius + gap + largest_;
        const std::size_t right = column_of(point.x + reach);
        const std::size_t top = row_of(point.y + reach);
        for (std::size_t row = row_of(point.y - reach); row <= top; ++row) {
            for (std::size_t column = column_of(point.x - reach); column <= right; ++column) {
                for (Index k = last_[row * columns_ + column]; k != none; k = before_[k]) {
                    const Vec2 between = disks_[k].centre - point;
                    const double near = radius + gap + disks_[k].radius;
                    if (dot(between, between) < near * near) f(disks_[k]);
                }
            }
        }
    }

    /// How high disks reach that a circle of `radius` (m) falling at `x` (m) might meet.
    [[nodiscard]] double top(double x, double radius) const {
        const double reach = radius + largest_;
        const auto from = tops_.begin() + static_cast<std::ptrdiff_t>(column_of(x - reach));
        const auto to = tops_.begin() + static_cast<std::ptrdiff_t>(column_of(x + reach));
        return *std::max_element(from, to + 1);
    }

private:
    static constexpr Index none = std::numeric_limits<Index>::max();

    [[nodiscard]] static std::size_t cell(double steps, std::size_t cells) {
        return steps <= 0.0 ? 0 : std::min(static_cast<std::size_t>(steps), cells - 1);
    }
    [[nodiscard]] std::size_t column_of(double x) const { return cell((x - box_.lower.x) / side_, columns_); }
    [[nodiscard]] std::size_t row_of(double y) const { return cell((y - box_.lower.y) / side_, rows_); }

    Box box_;
    double largest_;
    double side_ = 0.0;
    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    std::vector<Index> last_;   ///< put down in each cell
    std::vector<Index> before_; ///< the disk put down in the same cell before each
    std::vector<double> tops_;
    std::vector<model::Disk> disks_;
};

} // namespace demlua::packing
