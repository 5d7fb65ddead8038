// The bonds of a state as springs and dashpots between degrees of freedom, whatever kind of bonds they are.
//
//   U = sum over springs of k (b . u)^2/2,   K = sum k b b',   C = sum c b b'
//
// u: displacement x, y (m) and rotation (rad) of each element; b (1, 1, m): how much u stretches the spring; k N/m;
// c N s/m. A kind of bonds takes part through one overload each of
//
//   add_stiffness(bonds, elements, springs)   the linear form at bonding (first order in displacements from there)
//   add_tangent(bonds, elements, springs)     the second derivative of the energy where the elements stand now;
//                                             without one, the linear form stands in for it
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/state/state.hpp"
#include "engine/step/bond_forces.hpp"

#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace demlua::step {

/// How one element stretches a spring: by x and y per displacement, by turn (m) per rotation.
struct SpringEnd {
    std::size_t element = 0; ///< row of State::elements
    double x = 0.0;
    double y = 0.0;
    double turn = 0.0;
};

/// Springs among elements `first` to `first + count`; freedom f of element e is row 3 (e - first) + f of every vector.
class Springs {
public:
    Springs(std::size_t first, std::size_t count) : first_(first), count_(count) {}

    /// `stiffness` may be negative in a tangent; `damping` may not.
    void add(double stiffness, double damping, std::span<const SpringEnd> ends);

    [[nodiscard]] std::size_t size() const { return stiffness_.size(); }
    [[nodiscard]] Eigen::Index freedoms() const { return static_cast<Eigen::Index>(3 * count_); }
    [[nodiscard]] Eigen::Index row(std::size_t element) const {
        return static_cast<Eigen::Index>(3 * (element - first_));
    }
    [[nodiscard]] std::span<const SpringEnd> ends(std::size_t spring) const;
    [[nodiscard]] double stiffness(std::size_t spring) const { return stiffness_[spring]; }
    [[nodiscard]] double damping(std::size_t spring) const { return damping_[spring]; }
    [[nodiscard]] bool damped() const;

    /// The same for u = diag(factor) v: K becomes diag(factor) K diag(factor). One factor per freedom.
    void scale(const Eigen::VectorXd& factor);

    /// (stiff K + damp C) u.
    [[nodiscard]] Eigen::VectorXd times(double stiff, double damp, const Eigen::VectorXd& u) const;

    [[nodiscard]] Eigen::SparseMatrix<double> stiffness_matrix() const { return sum(stiffness_); }
    [[nodiscard]] Eigen::SparseMatrix<double> damping_matrix() const { return sum(damping_); }

private:
    [[nodiscard]] Eigen::SparseMatrix<double> sum(const std::vector<double>& weight) const;

    std::size_t first_;
    std::size_t count_;
    std::vector<SpringEnd> ends_;
    std::vector<std::size_t> last_; ///< of each spring, one past its ends
    std::vector<double> stiffness_;
    std::vector<double> damping_;
};

/// Springs of the bonds that hold in one body, or in all, in their linear form at bonding.
Springs springs_of_body(const state::State& state, std::size_t body);
Springs springs_of(const state::State& state);

/// The same as the second derivative of the energy where the elements stand now.
Springs tangent_of(const state::State& state);

/// M^-1/2 of elements `first` to `last`, one number per freedom, kg^-1/2 and kg^-1/2/m.
Eigen::VectorXd inverse_root_masses(const state::Elements& elements, std::size_t first, std::size_t last);

/// Ends of a spring between two elements that a displacement of j by `along` stretches by |along|^2, and rotations of i
/// and j by the arms given.
inline std::array<SpringEnd, 2> between(std::size_t i, std::size_t j, Vec2 along, double arm_i, double arm_j) {
    return {SpringEnd{i, -along.x, -along.y, -arm_i}, SpringEnd{j, along.x, along.y, -arm_j}};
}

template <class Law>
void add_stiffness(const state::BondSet<Law>& bonds, const state::Elements& /*elements*/, Springs& springs) {
    const bool damped = bonds.dashpots.present();
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        if (bonds.is_broken(k)) continue;
        const Vec2 n = Vec2{bonds.Dx[k], bonds.Dy[k]} / bonds.length[k];
        const double arm = bonds.length[k] * bonds.share_i[k];
        const double Cn = damped ? bonds.dashpots.Cn[k] : 0.0;
        const double Ct = damped ? bonds.dashpots.Ct[k] : 0.0;
        springs.add(bonds.params.Kn, Cn, between(bonds.i[k], bonds.j[k], n, 0.0, 0.0));
        springs.add(bonds.params.Kt, Ct, between(bonds.i[k], bonds.j[k], turned_left(n), arm, bonds.length[k] - arm));
    }
}

template <class AnyBonds>
void add_tangent(const AnyBonds& bonds, const state::Elements& elements, Springs& springs) {
    add_stiffness(bonds, elements, springs);
}

/// With d the length now: de = n.du, d(ut) = (l/d) t.du - a dtheta, and the curvature of stretch and angle
///   d2e = (t.du)^2/d,   d2(ut) = -(2 l/d^2) (n.du)(t.du) = -(l/2d^2) (((n+t).du)^2 - ((n-t).du)^2).
template <class Law>
void add_tangent(const state::BondSet<Law>& bonds, const state::Elements& elements, Springs& springs) {
    for (std::size_t k = 0; k < bonds.size(); ++k) {
        if (bonds.is_broken(k)) continue;
        const std::size_t i = bonds.i[k];
        const std::size_t j = bonds.j[k];
        const double l = bonds.length[k];
        const law::BondMotion<double> motion = motion_of(bonds, elements, k);
        auto history = bonds.history.at(k);
        const law::BondForce<double> force = Law::respond(bonds.params, bonds.radius[k], motion, history);
        const Vec2 n = motion.normal;
        const Vec2 t = turned_left(n);
        const double turned = l * motion.inverse_length;
        springs.add(bonds.params.Kn, 0.0, between(i, j, n, 0.0, 0.0));
        springs.add(bonds.params.Kt, 0.0,
                    between(i, j, turned * t, l * bonds.share_i[k], l * (1.0 - bonds.share_i[k])));
        springs.add(force.normal * motion.inverse_length, 0.0, between(i, j, t, 0.0, 0.0));
        const double twist = 0.5 * force.shear * turned * motion.inverse_length;
        springs.add(-twist, 0.0, between(i, j, n + t, 0.0, 0.0));
        springs.add(twist, 0.0, between(i, j, n - t, 0.0, 0.0));
    }
}

} // namespace demlua::step
