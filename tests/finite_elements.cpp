#include "tests/finite_elements.hpp"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace demlua::fe {

namespace {

constexpr std::size_t cell_nodes = 9;
constexpr std::array<double, 3> node_places{-1.0, 0.0, 1.0}; // along either side of the square
using CellMatrix = Eigen::Matrix<double, 18, 18>;

struct GaussPoint {
    double place;
    double weight;
};

const std::array<GaussPoint, 3>& gauss() {
    static const std::array<GaussPoint, 3> points{
        {{-std::sqrt(0.6), 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {std::sqrt(0.6), 5.0 / 9.0}}};
    return points;
}

/// Quadratic shape functions at -1, 0, 1 and their slopes.
std::array<double, 3> parabolas(double x) { return {0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)}; }
std::array<double, 3> parabola_slopes(double x) { return {x - 0.5, -2.0 * x, x + 0.5}; }

/// Shape functions of a cell at one point, with their derivatives over x and y.
struct Shapes {
    std::array<double, cell_nodes> value;
    std::array<Vec2, cell_nodes> gradient; // 1/m
    double jacobian;                       // m^2 per unit of the square
};

Shapes shapes_at(const Mesh& mesh, const Cell& cell, double xi, double eta) {
    const auto nx = parabolas(xi);
    const auto ny = parabolas(eta);
    const auto dx = parabola_slopes(xi);
    const auto dy = parabola_slopes(eta);
    Shapes shapes{};
    Vec2 along_xi;
    Vec2 along_eta;
    for (std::size_t k = 0; k < cell_nodes; ++k) {
        const Vec2 at = mesh.nodes[static_cast<std::size_t>(cell[k])];
        shapes.value[k] = nx[k % 3] * ny[k / 3];
        shapes.gradient[k] = {dx[k % 3] * ny[k / 3], nx[k % 3] * dy[k / 3]};
        along_xi += shapes.gradient[k].x * at;
        along_eta += shapes.gradient[k].y * at;
    }
    shapes.jacobian = cross(along_xi, along_eta);
    for (Vec2& g : shapes.gradient) {
        g = Vec2{g.x * along_eta.y - g.y * along_xi.y, g.y * along_xi.x - g.x * along_eta.x} / shapes.jacobian;
    }
    return shapes;
}

/// Stress over strain (xx, yy, engineering xy), Pa.
Eigen::Matrix3d elasticity(const Solid& solid) {
    const double nu = solid.plane_strain ? solid.poisson / (1.0 - solid.poisson) : solid.poisson;
    const double modulus = solid.plane_strain ? solid.modulus / (1.0 - solid.poisson * solid.poisson) : solid.modulus;
    Eigen::Matrix3d D;
    D << 1.0, nu, 0.0, nu, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - nu);
    return modulus / (1.0 - nu * nu) * D;
}

/// Strain over the displacements of the nodes of a cell.
Eigen::Matrix<double, 3, 18> strain_matrix(const Shapes& shapes) {
    Eigen::Matrix<double, 3, 18> B = Eigen::Matrix<double, 3, 18>::Zero();
    for (std::size_t k = 0; k < cell_nodes; ++k) {
        const auto x = static_cast<Eigen::Index>(2 * k);
        B(0, x) = shapes.gradient[k].x;
        B(1, x + 1) = shapes.gradient[k].y;
        B(2, x) = shapes.gradient[k].y;
        B(2, x + 1) = shapes.gradient[k].x;
    }
    return B;
}

struct CellMatrices {
    CellMatrix stiffness = CellMatrix::Zero();
    CellMatrix mass = CellMatrix::Zero();
};

CellMatrices cell_matrices(const Mesh& mesh, const Cell& cell, const Solid& solid, const Eigen::Matrix3d& D) {
    CellMatrices sum;
    for (const GaussPoint& p : gauss()) {
        for (const GaussPoint& q : gauss()) {
            const Shapes shapes = shapes_at(mesh, cell, p.place, q.place);
            if (!(shapes.jacobian > 0.0)) {
                throw std::runtime_error("finite elements: a cell is turned inside out");
            }
            const double volume = solid.thickness * shapes.jacobian * p.weight * q.weight;
            const Eigen::Matrix<double, 3, 18> B = strain_matrix(shapes);
            sum.stiffness += volume * B.transpose() * (D * B);
            for (std::size_t a = 0; a < cell_nodes; ++a) {
                for (std::size_t b = 0; b < cell_nodes; ++b) {
                    const double m = solid.density * volume * shapes.value[a] * shapes.value[b];
                    const auto row = static_cast<Eigen::Index>(2 * a);
                    const auto column = static_cast<Eigen::Index>(2 * b);
                    sum.mass(row, column) += m;
                    sum.mass(row + 1, column + 1) += m;
                }
            }
        }
    }
    return sum;
}

/// Number of a cell's local component among all components.
std::size_t component(const Cell& cell, std::size_t local) {
    return 2 * static_cast<std::size_t>(cell[local / 2]) + local % 2;
}

} // namespace

Supports& Supports::hold(const Place& where, std::size_t component) {
    for (std::size_t k = 0; k < m_mesh->nodes.size(); ++k) {
        if (where(m_mesh->nodes[k])) {
            m_held[2 * k + component] = true;
        }
    }
    return *this;
}

System assemble(const Mesh& mesh, const Solid& solid, const Supports& supports) {
    System system;
    int rows = 0;
    for (const bool held : supports.held()) {
        system.row.push_back(held ? -1 : rows++);
    }

    const Eigen::Matrix3d D = elasticity(solid);
    std::vector<Eigen::Triplet<double>> stiffness;
    std::vector<Eigen::Triplet<double>> mass;
    stiffness.reserve(324 * mesh.cells.size());
    mass.reserve(162 * mesh.cells.size());
    for (const Cell& cell : mesh.cells) {
        const CellMatrices matrices = cell_matrices(mesh, cell, solid, D);
        for (std::size_t a = 0; a < 2 * cell_nodes; ++a) {
            for (std::size_t b = 0; b < 2 * cell_nodes; ++b) {
                const int row = system.row[component(cell, a)];
                const int column = system.row[component(cell, b)];
                if (row < 0 || column < 0) {
                    continue;
                }
                const auto i = static_cast<Eigen::Index>(a);
                const auto j = static_cast<Eigen::Index>(b);
                stiffness.emplace_back(row, column, matrices.stiffness(i, j));
                if (a % 2 == b % 2) {
                    mass.emplace_back(row, column, matrices.mass(i, j));
                }
            }
        }
    }
    system.stiffness.resize(rows, rows);
    system.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
    system.mass.resize(rows, rows);
    system.mass.setFromTriplets(mass.begin(), mass.end());
    return system;
}

Field forces(const Mesh& mesh, const std::vector<Edge>& edges, double thickness, const Traction& traction) {
    Field sum = Field::Zero(static_cast<Eigen::Index>(2 * mesh.nodes.size()));
    for (const Edge& edge : edges) {
        for (const GaussPoint& p : gauss()) {
            const auto shape = parabolas(p.place);
            const auto slope = parabola_slopes(p.place);
            Vec2 at;
            Vec2 tangent;
            for (std::size_t k = 0; k < 3; ++k) {
                at += shape[k] * mesh.nodes[static_cast<std::size_t>(edge[k])];
                tangent += slope[k] * mesh.nodes[static_cast<std::size_t>(edge[k])];
            }
            const double length = norm(tangent);
            const Vec2 force = p.weight * thickness * length * traction(at, -turned_left(tangent) / length);
            for (std::size_t k = 0; k < 3; ++k) {
                sum[2 * edge[k]] += shape[k] * force.x;
                sum[2 * edge[k] + 1] += shape[k] * force.y;
            }
        }
    }
    return sum;
}

Traction uniform(Vec2 traction) {
    return [traction](Vec2, Vec2) { return traction; };
}

Vec2 mean_over(const Mesh& mesh, const std::vector<Edge>& edges, const Field& displacement) {
    const Field x = forces(mesh, edges, 1.0, uniform({1.0, 0.0}));
    const Field y = forces(mesh, edges, 1.0, uniform({0.0, 1.0}));
    return Vec2{x.dot(displacement), y.dot(displacement)} / x.sum();
}

Eigen::Vector3d stress_at(const Mesh& mesh, const Solid& solid, const Field& displacement, int node) {
    Eigen::Vector3d strain = Eigen::Vector3d::Zero();
    int cells = 0;
    for (const Cell& cell : mesh.cells) {
        for (std::size_t local = 0; local < cell_nodes; ++local) {
            if (cell[local] != node) {
                continue;
            }
            const Shapes shapes = shapes_at(mesh, cell, node_places[local % 3], node_places[local / 3]);
            Eigen::Matrix<double, 18, 1> u;
            for (std::size_t k = 0; k < 2 * cell_nodes; ++k) {
                u[static_cast<Eigen::Index>(k)] = displacement[static_cast<Eigen::Index>(component(cell, k))];
            }
            strain += strain_matrix(shapes) * u;
            ++cells;
        }
    }
    return elasticity(solid) * strain / cells;
}

} // namespace demlua::fe
