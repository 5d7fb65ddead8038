#include "engine/step/lanczos.hpp"

#include "engine/base/random.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

namespace demlua::step {

namespace {

using Times = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

constexpr Eigen::Index most_dense_rows = 60;
constexpr double error = 0.02;
constexpr double chance = 1e-6;
constexpr double greatest_residual = 0.01; // of the eigenvalue
constexpr int most_rounds = 4;

LargestPair by_writing_out(Eigen::Index rows, const Times& times) {
    Eigen::MatrixXd A(rows, rows);
    for (Eigen::Index k = 0; k < rows; ++k) A.col(k) = times(Eigen::VectorXd::Unit(rows, k));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(A);
    return {solved.eigenvalues()[rows - 1], 0.0, solved.eigenvectors().col(rows - 1)};
}

Eigen::VectorXd random_direction(Eigen::Index rows) {
    Eigen::VectorXd v(rows);
    for (Eigen::Index k = 0; k < rows; ++k) v[k] = uniform(1, 0, static_cast<std::uint64_t>(k)) - 0.5;
    return v.normalized();
}

int enough_steps(Eigen::Index rows) {
    const double n = static_cast<double>(rows);
    return static_cast<int>(std::ceil(0.5 * (1.0 + std::log(1.648 * std::sqrt(n) / chance) / std::sqrt(error))));
}

/// A basis that grows.
class Krylov {
public:
    Krylov(Eigen::Index rows, const Times& times) : times_(times), next_(random_direction(rows)) {}

    /// Whether there was a direction left to go.
    bool grow() {
        if (next_.size() == 0) return false;
        basis_.push_back(next_);
        Eigen::VectorXd w = times_(basis_.back());
        diagonal_.push_back(w.dot(basis_.back()));
        w -= diagonal_.back() * basis_.back();
        if (basis_.size() > 1) w -= beside_.back() * basis_[basis_.size() - 2];
        const double beta = w.norm();
        beside_.push_back(beta);
        const double largest = *std::max_element(diagonal_.begin(), diagonal_.end());
        next_ = beta > 1e-14 * largest ? Eigen::VectorXd(w / beta) : Eigen::VectorXd();
        return true;
    }

    [[nodiscard]] LargestPair best() const {
        const auto m = static_cast<Eigen::Index>(basis_.size());
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved;
        solved.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal_.data(), m),
                                      Eigen::Map<const Eigen::VectorXd>(beside_.data(), m - 1));
        const Eigen::VectorXd s = solved.eigenvectors().col(m - 1);
        LargestPair pair;
        pair.vector = Eigen::VectorXd::Zero(basis_.front().size());
        for (Eigen::Index k = 0; k < m; ++k) pair.vector += s[k] * basis_[static_cast<std::size_t>(k)];
        pair.vector.normalize();
        const Eigen::VectorXd image = times_(pair.vector);
        pair.value = image.dot(pair.vector);
        pair.residual = (image - pair.value * pair.vector).norm();
        return pair;
    }

private:
    const Times& times_;
    Eigen::VectorXd next_;
    std::vector<Eigen::VectorXd> basis_;
    std::vector<double> diagonal_;
    std::vector<double> beside_;
};

} // namespace

LargestPair largest_pair(Eigen::Index rows, const Times& times) {
    if (rows <= most_dense_rows) return by_writing_out(rows, times);
    Krylov krylov(rows, times);
    LargestPair pair;
    for (int round = 0; round < most_rounds; ++round) {
        bool grown = true;
        for (int k = enough_steps(rows); k > 0 && grown; --k) grown = krylov.grow();
        pair = krylov.best();
        if (!grown || pair.residual <= greatest_residual * pair.value) break;
    }
    return pair;
}

} // namespace demlua::step
