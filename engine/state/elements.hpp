// Elements: rigid disks, one row each, in columns.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/vec2.hpp"

#include <cstddef>

namespace demlua::state {

/// Rows of one body stand together. Position is `reference + displacement`: displacements are kept apart so that the
/// stretch of a bond is exact however far from the origin it lies. Velocities are those of the half step before the
/// present instant; forces are those of the present instant.
struct Elements {
    // hot: read or written every step
    Column<double> ux, uy;          ///< displacement, m
    Column<double> rotation;        ///< counter-clockwise since the start, rad
    Column<double> vx, vy;          ///< m/s
    Column<double> spin;            ///< rad/s
    Column<double> fx, fy;          ///< N
    Column<double> moment;          ///< N m
    Column<double> inverse_mass;    ///< 1/kg
    Column<double> inverse_inertia; ///< 1/(kg m^2), of m R^2/2

    // read by contacts and at output
    Column<double> reference_x, reference_y; ///< where the element stood at the start, m
    Column<double> radius;                   ///< m

    // cold
    Column<double> cell_area; ///< m^2 of the plane the element stands for
    Column<Index> body;
    Column<Index> cluster; ///< numbered through the scene

    [[nodiscard]] std::size_t size() const { return ux.size(); }
    [[nodiscard]] Vec2 position(std::size_t k) const { return {reference_x[k] + ux[k], reference_y[k] + uy[k]}; }
    [[nodiscard]] Vec2 displacement(std::size_t k) const { return {ux[k], uy[k]}; }
    [[nodiscard]] Vec2 velocity(std::size_t k) const { return {vx[k], vy[k]}; }
    [[nodiscard]] Vec2 force(std::size_t k) const { return {fx[k], fy[k]}; }
    [[nodiscard]] double mass(std::size_t k) const { return 1.0 / inverse_mass[k]; }
    [[nodiscard]] double inertia(std::size_t k) const { return 1.0 / inverse_inertia[k]; }

    /// Appends `count` rows of zeros.
    void grow(std::size_t count);
};

} // namespace demlua::state
