// Solutions of one linear system for right sides that are mostly sums of few, such as loads that grow together.
#pragma once

#include "engine/step/held_system.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace demlua::step {

class SolvedSides {
public:
    /// `system` outlives this.
    explicit SolvedSides(const HeldSystem& system) : system_(system) {}

    /// The solution for `right_side`: by superposition of earlier ones as far as they reach (to 1e-13 of its norm), else found.
    [[nodiscard]] Eigen::VectorXd solution(Eigen::VectorXd right_side);

private:
    struct Solved {
        Eigen::VectorXd right; ///< of norm 1, all of them normal to each other
        Eigen::VectorXd solution;
    };

    static constexpr std::size_t most = 8; ///< kept

    const HeldSystem& system_;
    std::vector<Solved> solved_;
};

} // namespace demlua::step
