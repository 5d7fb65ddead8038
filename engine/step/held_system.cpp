#include "engine/step/held_system.hpp"

namespace demlua::step {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

double typical_of(const Sparse& matrix) {
    const double largest = matrix.diagonal().cwiseAbs().maxCoeff();
    return largest == 0.0 ? 1.0 : largest;
}

/// `matrix` with `typical` alone on held rows and columns.
Sparse free_part(const Sparse& matrix, const std::vector<std::uint8_t>& held, double typical) {
    const auto is_held = [&](Eigen::Index row) { return held[static_cast<std::size_t>(row)] != 0; };
    Sparse free = matrix;
    free.prune([&](Eigen::Index row, Eigen::Index column, double /*value*/) {
        return row == column || (!is_held(row) && !is_held(column));
    });
    for (Eigen::Index row = 0; row < free.rows(); ++row) {
        if (is_held(row)) free.coeffRef(row, row) = typical;
    }
    return free;
}

} // namespace

HeldSystem::HeldSystem(const Sparse& matrix, const std::vector<std::uint8_t>& held)
    : held_(held), whole_(matrix), typical_(typical_of(matrix)), factor_(free_part(matrix, held, typical_)) {}

bool HeldSystem::singular() const {
    constexpr double nothing = 1e-14;
    return factor_.least_pivot() < nothing * typical_;
}

Eigen::VectorXd HeldSystem::right_side(const Eigen::VectorXd& force, const Eigen::VectorXd& given) const {
    Eigen::VectorXd known = Eigen::VectorXd::Zero(given.size());
    for (Eigen::Index row = 0; row < known.size(); ++row) {
        if (is_held(row)) known[row] = given[row];
    }
    Eigen::VectorXd right = force;
    if (!known.isZero(0.0)) right -= whole_ * known;
    for (Eigen::Index row = 0; row < right.size(); ++row) {
        if (is_held(row)) right[row] = typical_ * known[row];
    }
    return right;
}

Eigen::VectorXd HeldSystem::solve(const Eigen::VectorXd& force, const Eigen::VectorXd& given) const {
    return backward(forward(right_side(force, given)));
}

} // namespace demlua::step
