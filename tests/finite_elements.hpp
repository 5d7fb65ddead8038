// Linear elasticity with nine-node finite elements: the independent reference for bonded bodies.
//
// Biquadratic isoparametric quadrilaterals, 3 x 3 Gauss points, small strains, constant thickness (Zienkiewicz & Taylor,
// The Finite Element Method, vol. 1). They share no line with the engine. The compliance converges from below: with the
// fourth power of the cell size where the solution is smooth, slower with a clamped corner.
#pragma once

#include "tests/finite_element_mesh.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <functional>
#include <vector>

namespace demlua::fe {

struct Solid {
    double modulus = 1.0;   // Young's, Pa
    double poisson = 0.3;   // below 0.5
    double density = 1.0;   // kg/m^3
    double thickness = 1.0; // m
    bool plane_strain = false;
};

/// Displacements (m) or forces (N): components 2 k and 2 k + 1 are x and y at node k.
using Field = Eigen::VectorXd;
using ComplexField = Eigen::VectorXcd;

/// Which components of which nodes are held at zero.
class Supports {
public:
    explicit Supports(const Mesh& mesh) : m_mesh(&mesh), m_held(2 * mesh.nodes.size(), false) {}

    Supports& hold_x(const Place& where) { return hold(where, 0); }
    Supports& hold_y(const Place& where) { return hold(where, 1); }
    Supports& clamp(const Place& where) { return hold(where, 0).hold(where, 1); }

    [[nodiscard]] const std::vector<bool>& held() const { return m_held; }

private:
    Supports& hold(const Place& where, std::size_t component);

    const Mesh* m_mesh;
    std::vector<bool> m_held;
};

/// Stiffness (N/m) and consistent mass (kg) over the components that are free.
struct System {
    Eigen::SparseMatrix<double> stiffness;
    Eigen::SparseMatrix<double> mass;
    std::vector<int> row; // of each component of a Field; -1 where held
};

System assemble(const Mesh& mesh, const Solid& solid, const Supports& supports);

/// Force per area (Pa) at a place of the boundary whose outward normal is given.
using Traction = std::function<Vec2(Vec2 at, Vec2 outward)>;

/// The same force per area everywhere.
Traction uniform(Vec2 traction);

/// Consistent forces of a traction on edges.
Field forces(const Mesh& mesh, const std::vector<Edge>& edges, double thickness, const Traction& traction);

/// Mean displacement over edges, m: what does work with a traction that is uniform over them.
Vec2 mean_over(const Mesh& mesh, const std::vector<Edge>& edges, const Field& displacement);

/// Displacements at rest. Throws std::runtime_error where the supports leave the body movable.
Field solve_static(const System& system, const Field& forces);

/// Complex amplitudes of u(t) = Re(U exp(i w t)) under forces Re(F exp(i w t)), w = `frequency` (rad/s), with damping
/// C = `mass_damping` M (1/s): (K + i w C - w^2 M) U = F, solved at this frequency.
ComplexField solve_harmonic(const System& system, const Field& forces, double frequency, double mass_damping);

/// The lowest natural frequency, rad/s, by inverse iteration from `start`, a shape that contains the first mode.
double first_frequency(const System& system, const Field& start);

/// Stress (xx, yy, xy; Pa) at a node: the mean over the cells that meet there.
Eigen::Vector3d stress_at(const Mesh& mesh, const Solid& solid, const Field& displacement, int node);

} // namespace demlua::fe
