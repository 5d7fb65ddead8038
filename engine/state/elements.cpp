#include "engine/state/elements.hpp"

namespace demlua::state {

void Elements::grow(std::size_t count) {
    const std::size_t rows = size() + count;
    for (Column<double>* column : {&ux, &uy, &rotation, &vx, &vy, &spin, &fx, &fy, &moment, &inverse_mass,
                                   &inverse_inertia, &reference_x, &reference_y, &radius, &cell_area}) {
        column->resize(rows);
    }
    body.resize(rows);
    cluster.resize(rows);
}

} // namespace demlua::state
