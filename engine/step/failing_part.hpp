// The part of a bonded network that fails, with all that stays elastic condensed into it.
//
//   f = f_P + B w,   B_km = L_k . K^-1 L_m - M_km         forces in failing bonds under their offsets (bond_offsets.hpp)
//
// f_P are the forces the loads put into these bonds while nothing has failed; K is factorised once. Rest is where every law
// agrees with its f; it is found bond by bond (Gauss-Seidel), each giving way as its law says against its own -B_kk. -B
// is positive definite, so offsets grow towards rest and never beyond it, as they would if the load grew slowly.
#pragma once

#include "engine/step/failing_bonds.hpp"
#include "engine/step/held_system.hpp"
#include "engine/step/leap.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <vector>

namespace demlua::step {

class FailingPart {
public:
    /// `system` and `per_radius` (1, 1, 1/R of each element: rotation = value/R) outlive this.
    FailingPart(const HeldSystem& system, const Eigen::VectorXd& per_radius)
        : system_(system), per_radius_(per_radius) {}

    void add(FailingBonds& set, std::size_t bond);
    [[nodiscard]] std::size_t size() const { return members_.size(); }
    /// Forgets all bonds but the first `size`; for their sets to do the same.
    void keep_first(std::size_t size) {
        members_.resize(size);
        leap_.forget();
    }

    /// Lets failing bonds give way under `loaded`, the displacements and rotations the loads alone would cause, until no
    /// force is out of balance with its law by more than `tolerance` of the bond's strength. Gives what is left.
    double relax(const Eigen::VectorXd& loaded, double tolerance, int sweeps);

    /// Displacements and rotations that the offsets cause.
    [[nodiscard]] Eigen::VectorXd displacements() const;
    [[nodiscard]] double largest_offset() const; ///< m

private:
    struct Member {
        FailingBonds* set;
        std::size_t row;
        std::array<ElementForces, 2> forces;               ///< of unit offsets
        std::array<Eigen::SparseVector<double>, 2> halves; ///< of what these forces move (HeldSystem::forward)
        Eigen::Vector2d least;                             ///< stiffness it meets at least, N/m
    };

    [[nodiscard]] Eigen::VectorXd half_response(const ElementForces& forces) const;
    void hold_back(std::size_t element, Eigen::VectorXd& right) const;
    [[nodiscard]] Eigen::VectorXd offsets() const;
    [[nodiscard]] Eigen::Vector2d met(std::size_t n) const;
    double sweep(Eigen::VectorXd& force, Eigen::VectorXd& moved);
    [[nodiscard]] std::vector<Moving> moving_now(const Eigen::VectorXd& force, const Eigen::VectorXd& moved,
                                                 double worst) const;
    [[nodiscard]] double share_of_leap(const std::vector<Moving>& moving, const Eigen::VectorXd& eta) const;
    bool leap(Eigen::VectorXd& force, const Eigen::VectorXd& moved, double worst);

    const HeldSystem& system_;
    const Eigen::VectorXd& per_radius_;
    std::vector<Member> members_;
    Leap leap_;
    Eigen::MatrixXd B_; ///< two rows and columns to a member, room for more
};

} // namespace demlua::step
