// A table of small structures, one column for each of their members.
#pragma once

#include "engine/base/column.hpp"

#include <array>
#include <cstddef>

namespace demlua {

/// Of structures of numbers that list their members in `members`. Rows are read and written whole, by value; loops over
/// several rows take the columns.
template <class Struct, template <class> class ColumnOf = Column>
struct StructColumns {
    static constexpr std::size_t width = Struct::members.size();
    std::array<ColumnOf<double>, width> columns;

    void resize(std::size_t rows) {
        for (ColumnOf<double>& column : columns) column.resize(rows);
    }

    [[nodiscard]] Struct at(std::size_t row) const {
        Struct whole;
        for (std::size_t m = 0; m < width; ++m) whole.*Struct::members[m] = columns[m][row];
        return whole;
    }
    [[nodiscard]] Struct operator[](std::size_t row) const { return at(row); }

    /// Of one member.
    template <auto member>
    [[nodiscard]] const ColumnOf<double>& column() const {
        std::size_t m = 0;
        while (m + 1 < width && !(Struct::members[m] == member)) ++m;
        return columns[m];
    }

    /// Where each column begins.
    [[nodiscard]] std::array<const double*, width> begins() const {
        std::array<const double*, width> all{};
        for (std::size_t m = 0; m < width; ++m) all[m] = columns[m].data();
        return all;
    }

    void store(std::size_t row, const Struct& whole) {
        for (std::size_t m = 0; m < width; ++m) columns[m][row] = whole.*Struct::members[m];
    }
    void push_back(const Struct& whole) {
        for (std::size_t m = 0; m < width; ++m) columns[m].push_back(whole.*Struct::members[m]);
    }
};

} // namespace demlua
