#include "engine/state/incidence.hpp"

namespace demlua::state {

Incidence incidence_of(const Column<Index>& i, const Column<Index>& j, std::size_t first, std::size_t count) {
    Incidence incidence;
    incidence.first = first;
    incidence.start.assign(count + 1, 0);
    for (std::size_t k = 0; k < i.size(); ++k) {
        ++incidence.start[i[k] - first + 1];
        ++incidence.start[j[k] - first + 1];
    }
    for (std::size_t e = 0; e < count; ++e) incidence.start[e + 1] += incidence.start[e];
    incidence.end.resize(2 * i.size());
    Column<Index> next(incidence.start.begin(), incidence.start.end() - 1);
    for (std::size_t k = 0; k < i.size(); ++k) {
        const auto entry = static_cast<Index>(2 * k);
        incidence.end[next[i[k] - first]++] = entry;
        incidence.end[next[j[k] - first]++] = entry + 1;
    }
    return incidence;
}

} // namespace demlua::state
