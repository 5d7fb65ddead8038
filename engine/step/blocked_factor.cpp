#include "engine/step/blocked_factor.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <span>

namespace demlua::step {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Rows of column `c` of `lower`, which holds what is below the diagonal.
std::span<const int> rows_of(const Sparse& lower, Eigen::Index c) {
    const int begin = lower.outerIndexPtr()[c];
    const int end = lower.isCompressed() ? lower.outerIndexPtr()[c + 1] : begin + lower.innerNonZeroPtr()[c];
    return {lower.innerIndexPtr() + begin, static_cast<std::size_t>(end - begin)};
}

/// Whether column `c` has, below row c + 1, the rows of column c + 1.
bool continues(const Sparse& lower, Eigen::Index c) {
    const std::span<const int> rows = rows_of(lower, c);
    const std::span<const int> next = rows_of(lower, c + 1);
    return rows.size() == next.size() + 1 && rows.front() == c + 1 && std::ranges::equal(rows.subspan(1), next);
}

} // namespace

BlockedFactor::BlockedFactor(const Sparse& matrix) {
    const Eigen::SimplicialLDLT<Sparse> factors(matrix);
    if (factors.info() != Eigen::Success) return;
    order_ = factors.permutationP();
    pivots_ = factors.vectorD();
    least_pivot_ = pivots_.cwiseAbs().minCoeff();
    const Sparse& lower = factors.matrixL().nestedExpression();
    values_.reserve(static_cast<std::size_t>(lower.nonZeros() + 2 * lower.cols()));
    for (Eigen::Index first = 0; first < lower.cols();) {
        Eigen::Index width = 1;
        while (first + width < lower.cols() && continues(lower, first + width - 1)) ++width;
        append(lower, first, width);
        first += width;
    }
}

void BlockedFactor::append(const Sparse& lower, Eigen::Index first, Eigen::Index width) {
    const std::span<const int> below = rows_of(lower, first + width - 1);
    const auto depth = static_cast<Eigen::Index>(below.size());
    const Block block{first, width, depth, rows_.size(), values_.size()};
    rows_.insert(rows_.end(), below.begin(), below.end());
    values_.resize(values_.size() + static_cast<std::size_t>(width * (width + depth)), 0.0);
    for (Eigen::Index c = 0; c < width; ++c) {
        const std::span<const int> rows = rows_of(lower, first + c);
        const double* entries = lower.valuePtr() + lower.outerIndexPtr()[first + c];
        double* column = values_.data() + block.at + static_cast<std::size_t>(c * (width + depth));
        std::copy(entries, entries + rows.size(), column + c + 1);
    }
    blocks_.push_back(block);
    most_below_ = std::max(most_below_, depth);
}

Eigen::Map<const Eigen::MatrixXd> BlockedFactor::values(const Block& block) const {
    return {values_.data() + block.at, block.width + block.below, block.width};
}

Eigen::VectorXd BlockedFactor::forward(const Eigen::VectorXd& f) const {
    Eigen::VectorXd x = order_ * f;
    Eigen::VectorXd taken = Eigen::VectorXd::Zero(most_below_);
    for (const Block& block : blocks_) {
        auto own = x.segment(block.first, block.width);
        if ((own.array() == 0.0).all()) continue;
        const auto L = values(block);
        for (Eigen::Index c = 0; c + 1 < block.width; ++c) {
            const Eigen::Index after = block.width - c - 1;
            own.tail(after) -= own[c] * L.col(c).segment(c + 1, after);
        }
        taken.head(block.below).noalias() = L.bottomRows(block.below) * own;
        const int* rows = rows_.data() + block.rows_at;
        for (Eigen::Index r = 0; r < block.below; ++r) x[rows[r]] -= taken[r];
    }
    return x;
}

Eigen::VectorXd BlockedFactor::backward(const Eigen::VectorXd& y) const {
    Eigen::VectorXd x = over_pivots(y);
    Eigen::VectorXd under = Eigen::VectorXd::Zero(most_below_);
    for (std::size_t b = blocks_.size(); b-- > 0;) {
        const Block& block = blocks_[b];
        const int* rows = rows_.data() + block.rows_at;
        for (Eigen::Index r = 0; r < block.below; ++r) under[r] = x[rows[r]];
        const auto L = values(block);
        auto own = x.segment(block.first, block.width);
        for (Eigen::Index c = block.width; c-- > 0;) {
            const Eigen::Index after = block.width - c - 1;
            own[c] -= L.col(c).tail(block.below).dot(under.head(block.below)) +
                      L.col(c).segment(c + 1, after).dot(own.tail(after));
        }
    }
    return order_.transpose() * x;
}

} // namespace demlua::step
