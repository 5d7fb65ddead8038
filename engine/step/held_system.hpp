// A linear system some of whose unknowns are given.
#pragma once

#include "engine/step/blocked_factor.hpp"

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

namespace demlua::step {

/// K u = f on free rows with u given on held ones, factorised once (L D L'). All entries must be of one kind, such as N/m, so
/// that a pivot can be called small.
class HeldSystem {
public:
    /// `matrix` symmetric, both halves stored; `held` one entry per row.
    HeldSystem(const Eigen::SparseMatrix<double>& matrix, const std::vector<std::uint8_t>& held);

    /// Whether some motion of the free rows takes no force.
    [[nodiscard]] bool singular() const;

    /// `given` counts on held rows, `force` on free ones.
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& force, const Eigen::VectorXd& given) const;

    /// In two halves, as u = backward(forward(right_side)); forces f and g, for their part, do to each other
    /// g.K^-1 f = forward(g) . over_pivots(forward(f)). Entries on held rows of a right side are what is given there, as
    /// force; zero holds.
    [[nodiscard]] Eigen::VectorXd right_side(const Eigen::VectorXd& force, const Eigen::VectorXd& given) const;
    [[nodiscard]] Eigen::VectorXd forward(const Eigen::VectorXd& right_side) const {
        return factor_.forward(right_side);
    }
    [[nodiscard]] Eigen::VectorXd over_pivots(const Eigen::VectorXd& y) const { return factor_.over_pivots(y); }
    [[nodiscard]] Eigen::VectorXd backward(const Eigen::VectorXd& y) const { return factor_.backward(y); }

    [[nodiscard]] bool is_held(Eigen::Index row) const { return held_[static_cast<std::size_t>(row)] != 0; }

private:
    const std::vector<std::uint8_t>& held_;
    Eigen::SparseMatrix<double> whole_;
    double typical_; ///< diagonal entry
    BlockedFactor factor_;
};

} // namespace demlua::step
