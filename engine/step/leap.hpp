// Many bonds that give way and load each other, moved at once nearly as far as they would come one by one.
//
//   moved_n = along_n eta_n,   eta_n = due_n + slope_n . sum_m B'_nm along_m eta_m
//
// B' is B (failing_part.hpp) without what each bond takes into account itself, its own stiffness; due is what it would move
// now. The laws are linearised, so only a share of the answer may be used; what is left is for the laws.
#pragma once

#include "engine/step/failing_bonds.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <cstddef>
#include <vector>

namespace demlua::step {

/// One way of one member.
struct Moving {
    std::size_t member;
    Way way;
    double due;                ///< m
    Eigen::Vector2d stiffness; ///< taken into account, N/m
};

class Leap {
public:
    /// eta of each, m. Those that could only move back are left out: 0. Empty where there is no such rest: bonds soften faster
    /// than they are held.
    Eigen::VectorXd moved(const std::vector<Moving>& moving, const Eigen::MatrixXd& B);

    /// To be called when members have changed their numbers.
    void forget() { factored_.clear(); }

private:
    void factorise(const std::vector<Moving>& moving, const Eigen::MatrixXd& B);
    [[nodiscard]] bool factorised(const std::vector<Moving>& moving) const;

    std::vector<Moving> factored_;
    Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

} // namespace demlua::step
