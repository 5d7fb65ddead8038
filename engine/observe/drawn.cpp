#include "engine/observe/drawn.hpp"

#include "engine/state/parts.hpp"

#include <cstddef>
#include <variant>
#include <vector>

namespace demlua::observe {

namespace {

/// Keeps of `rows` of `width` numbers those that are wanted.
template <class T>
void keep(std::vector<T>& rows, std::size_t width, const std::vector<bool>& wanted) {
    std::size_t next = 0;
    for (std::size_t row = 0; row < wanted.size(); ++row) {
        if (!wanted[row]) continue;
        for (std::size_t c = 0; c < width; ++c) rows[next * width + c] = rows[row * width + c];
        ++next;
    }
    rows.resize(next * width);
}

void keep(std::vector<Field>& fields, const std::vector<bool>& wanted) {
    for (Field& field : fields) {
        std::visit([&](auto& values) { keep(values, static_cast<std::size_t>(field.components), wanted); },
                   field.values);
    }
}

} // namespace

void bring_inside(Snapshot& snapshot, const state::State& state) {
    const std::vector<std::int32_t> part = state::part_of_elements(state);
    std::vector<double> shift;
    for (std::size_t k = 0; k < part.size(); ++k) {
        const auto number = static_cast<std::size_t>(part[k]);
        if (number == shift.size()) shift.push_back(state.period.shift_inside(snapshot.position[k].x));
        snapshot.position[k].x += shift[number];
    }
}

void leave_out_gone(Snapshot& snapshot, const state::State& state) {
    std::vector<bool> here(snapshot.position.size());
    std::vector<Index> row(here.size());
    Index next = 0;
    for (std::size_t k = 0; k < here.size(); ++k) {
        here[k] = !state.is_gone(k);
        row[k] = next;
        if (here[k]) ++next;
    }
    std::vector<bool> whole(snapshot.bond_ends.size());
    for (std::size_t b = 0; b < whole.size(); ++b) {
        auto& [i, j] = snapshot.bond_ends[b];
        whole[b] = here[i] && here[j];
        i = row[i];
        j = row[j];
    }
    keep(snapshot.position, 1, here);
    keep(snapshot.element_fields, here);
    keep(snapshot.bond_ends, 1, whole);
    keep(snapshot.bond_fields, whole);
}

} // namespace demlua::observe
