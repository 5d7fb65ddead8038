// The largest eigenvalue of a symmetric matrix that is known only by what it does to a vector.
//
//   A V = V T + beta v e',   T tridiagonal;   (theta, V s) with T s = theta s approaches the largest pair from below.
//
// The estimate is theta + |A x - theta x|. From a random start, m steps leave a relative error above e with a probability
// of at most 1.648 sqrt(n) exp(-sqrt(e) (2m - 1)) (Kuczynski & Wozniakowski, SIAM J. Matrix Anal. Appl. 13, 1992,
// theorem 4.2); so many are taken that this is below 1e-6 at e = 2 %. The vectors are not made orthogonal again: that
// would only add copies of eigenvalues that have been found. Up to 60 rows the matrix is written out and solved densely.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace demlua::step {

struct LargestPair {
    double value = 0.0;     ///< theta, never above the largest eigenvalue but by rounding
    double residual = 0.0;  ///< |A x - theta x|
    Eigen::VectorXd vector; ///< x, of length one

    [[nodiscard]] double estimate() const { return value + residual; }
};

/// `times` gives A x for a symmetric A of `rows` rows without negative eigenvalues.
LargestPair largest_pair(Eigen::Index rows, const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& times);

} // namespace demlua::step
