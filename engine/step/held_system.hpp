// A linear system some of whose unknowns are given.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

namespace demlua::step {

/// K u = f on free rows with u given on held ones, factorised once (Eigen, L D L'). All entries must be of one kind, such as
/// N/m, so that a pivot can be called small.
class HeldSystem {
public:
    /// `matrix` symmetric, both halves stored; `held` one entry per row.
    HeldSystem(const Eigen::SparseMatrix<double>& matrix, const std::vector<std::uint8_t>& held);

    /// Whether some motion of the free rows takes no force.
    [[nodiscard]] bool singular() const;

    /// `given` counts on held rows, `force` on free ones.
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& force, const Eigen::VectorXd& given) const;

private:
    [[nodiscard]] bool is_held(Eigen::Index row) const { return held_[static_cast<std::size_t>(row)] != 0; }

    const std::vector<std::uint8_t>& held_;
    Eigen::SparseMatrix<double> whole_;
    double typical_ = 0.0; ///< diagonal entry
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

} // namespace demlua::step
