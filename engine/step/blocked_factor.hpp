// L D L' = P A P' of a sparse symmetric matrix, its columns in dense blocks.
//
// Neighbouring columns of L that have the same rows below them (an element's three freedoms, and the more the later they are
// eliminated) are kept as one block with one list of rows, so that solving reads numbers in the order they lie in memory.
// The factor itself and its ordering are Eigen's.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

namespace demlua::step {

class BlockedFactor {
public:
    /// `matrix` symmetric, both halves stored.
    explicit BlockedFactor(const Eigen::SparseMatrix<double>& matrix);

    /// Least pivot, absolute; 0 where there is no factor.
    [[nodiscard]] double least_pivot() const { return least_pivot_; }

    /// L^-1 P f. Costs what f reaches: little where few of its entries are other than zero.
    [[nodiscard]] Eigen::VectorXd forward(const Eigen::VectorXd& f) const;
    [[nodiscard]] Eigen::VectorXd over_pivots(const Eigen::VectorXd& y) const { return y.cwiseQuotient(pivots_); }
    /// P' L^-T D^-1 y: with y = forward(f) the solution of A x = f.
    [[nodiscard]] Eigen::VectorXd backward(const Eigen::VectorXd& y) const;

private:
    struct Block {
        Eigen::Index first; ///< column
        Eigen::Index width;
        Eigen::Index below;  ///< rows under the block
        std::size_t rows_at; ///< in rows_
        std::size_t at;      ///< in values_: `width` columns of width + below entries
    };

    [[nodiscard]] Eigen::Map<const Eigen::MatrixXd> values(const Block& block) const;
    void append(const Eigen::SparseMatrix<double>& lower, Eigen::Index first, Eigen::Index width);

    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order_; ///< P
    Eigen::VectorXd pivots_;                                              ///< D
    double least_pivot_ = 0.0;
    std::vector<Block> blocks_;
    std::vector<int> rows_;
    std::vector<double> values_;
    Eigen::Index most_below_ = 0;
};

} // namespace demlua::step
