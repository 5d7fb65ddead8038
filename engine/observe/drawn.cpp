#include "engine/observe/drawn.hpp"

#include "engine/state/parts.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
    const double far = 0.5 * state.period.length;
    const auto reaches_across = [&](const std::array<Index, 2>& ends) {
        return std::fabs(snapshot.position[ends[1]].x - snapshot.position[ends[0]].x) > far;
    };
    const std::vector<std::int32_t> part = state::part_of_elements(state);
    std::vector<bool> across(part.size());
    for (const std::array<Index, 2>& ends : snapshot.bond_ends) {
        const auto number = static_cast<std::size_t>(part[ends[0]]);
        if (part[ends[0]] == part[ends[1]] && reaches_across(ends)) across[number] = true;
    }
    std::vector<double> shift;
    for (std::size_t k = 0; k < part.size(); ++k) {
        const auto number = static_cast<std::size_t>(part[k]);
        const double own = state.period.shift_inside(snapshot.position[k].x);
        if (number == shift.size()) shift.push_back(own);
        snapshot.position[k].x += across[number] ? own : shift[number];
    }
    std::vector<bool> drawn(snapshot.bond_ends.size());
    for (std::size_t b = 0; b < drawn.size(); ++b) drawn[b] = !reaches_across(snapshot.bond_ends[b]);
    keep(snapshot.bond_ends, 1, drawn);
    keep(snapshot.bond_fields, drawn);
    for (std::array<Vec2, 2>& ends : snapshot.crack_ends) {
        const double inside = state.period.shift_inside(0.5 * (ends[0].x + ends[1].x));
        for (Vec2& end : ends) end.x += inside;
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
