// Columns for what a law remembers: one per member of its History, none for a law that remembers nothing.
#pragma once

#include "engine/base/column.hpp"

#include <array>
#include <cstddef>

namespace demlua::state {

template <class History>
struct HistoryColumns {
    static constexpr std::size_t width = History::members.size();
    std::array<Column<double>, width> columns;

    void resize(std::size_t rows) {
        for (Column<double>& column : columns) column.resize(rows);
    }

    [[nodiscard]] History at(std::size_t row) const {
        History history;
        for (std::size_t m = 0; m < width; ++m) history.*History::members[m] = columns[m][row];
        return history;
    }

    void store(std::size_t row, const History& history) {
        for (std::size_t m = 0; m < width; ++m) columns[m][row] = history.*History::members[m];
    }
};

} // namespace demlua::state
