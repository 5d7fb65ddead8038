// Meshes of nine-node quadrilaterals: mapped blocks, their joining, and their boundaries.
#pragma once

#include "engine/base/vec2.hpp"

#include <array>
#include <functional>
#include <vector>

namespace demlua::fe {

/// Nodes of a cell, row by row: node 3 j + i stands at xi = i - 1, eta = j - 1 of the square [-1, 1] x [-1, 1].
using Cell = std::array<int, 9>;

/// Nodes of one side of a cell from end to end, the body on the left.
using Edge = std::array<int, 3>;

struct Mesh {
    std::vector<Vec2> nodes; // m
    std::vector<Cell> cells; // each with a positive Jacobian
};

/// From the unit square (s to the right, t upwards) to the plane, m; must keep the orientation.
using Mapping = std::function<Vec2(double s, double t)>;

/// Whether a place (m) belongs to a selection.
using Place = std::function<bool(Vec2 at)>;

/// Places closer than this are one, m: bodies here are of the size of a metre and more.
constexpr double touching = 1e-9;

Place at_x(double x);
Place at_y(double y);
Place at_point(Vec2 point);

/// Where cells end in [0, 1], rising from 0 to 1.
using Stations = std::vector<double>;

/// Cells of equal size.
Stations even(int cells);
/// Cells that become small towards 0: station k stands at (k / cells)^power.
Stations small_at_start(int cells, double power);
/// Cells that become small towards 1.
Stations small_at_end(int cells, double power);
/// Cells that become small towards both ends, symmetric about 1/2; an even number of them.
Stations small_at_ends(int cells, double power);

/// A grid of cells between stations of s and t. All nodes stand on the mapping, those between stations half-way in s or t,
/// so that curved walls are met by parabolas.
Mesh block(const Stations& s, const Stations& t, const Mapping& mapping);

/// One mesh of several whose nodes coincide along common sides.
Mesh joined(const std::vector<Mesh>& parts);

/// Sides that belong to one cell only and whose three nodes all are in `where`.
std::vector<Edge> boundary(const Mesh& mesh, const Place& where);

/// The node nearest to a place.
int nearest_node(const Mesh& mesh, Vec2 place);

} // namespace demlua::fe
