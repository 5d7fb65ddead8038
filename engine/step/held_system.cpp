#include "engine/step/held_system.hpp"

namespace demlua::step {

HeldSystem::HeldSystem(const Eigen::SparseMatrix<double>& matrix, const std::vector<std::uint8_t>& held)
    : held_(held), whole_(matrix), typical_(whole_.diagonal().cwiseAbs().maxCoeff()) {
    if (typical_ == 0.0) typical_ = 1.0;
    Eigen::SparseMatrix<double> free = whole_;
    free.prune([&](Eigen::Index row, Eigen::Index column, double /*value*/) {
        return row == column || (!is_held(row) && !is_held(column));
    });
    for (Eigen::Index row = 0; row < free.rows(); ++row) {
        if (is_held(row)) free.coeffRef(row, row) = typical_;
    }
    factors_.compute(free);
}

bool HeldSystem::singular() const {
    constexpr double nothing = 1e-14;
    return factors_.info() != Eigen::Success || factors_.vectorD().cwiseAbs().minCoeff() < nothing * typical_;
}

Eigen::VectorXd HeldSystem::solve(const Eigen::VectorXd& force, const Eigen::VectorXd& given) const {
    Eigen::VectorXd known = Eigen::VectorXd::Zero(given.size());
    for (Eigen::Index row = 0; row < known.size(); ++row) {
        if (is_held(row)) known[row] = given[row];
    }
    Eigen::VectorXd right = force - whole_ * known;
    for (Eigen::Index row = 0; row < right.size(); ++row) {
        if (is_held(row)) right[row] = typical_ * known[row];
    }
    return factors_.solve(right);
}

} // namespace demlua::step
