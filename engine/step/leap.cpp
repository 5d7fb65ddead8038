#include "engine/step/leap.hpp"

#include <algorithm>
#include <utility>

namespace demlua::step {

namespace {

/// Whether the system of one serves for the other: what remains of a change this small is for the laws.
bool alike(const Moving& a, const Moving& b) {
    constexpr double small = 0.01;
    return a.member == b.member && a.way.back == b.way.back && (a.way.along - b.way.along).norm() < small &&
           (a.way.slope - b.way.slope).norm() < small * b.way.slope.norm() && a.stiffness == b.stiffness;
}

} // namespace

bool Leap::factorised(const std::vector<Moving>& moving) const {
    return std::equal(moving.begin(), moving.end(), factored_.begin(), factored_.end(), alike);
}

void Leap::factorise(const std::vector<Moving>& moving, const Eigen::MatrixXd& B) {
    const auto size = static_cast<Eigen::Index>(moving.size());
    Eigen::MatrixXd A(size, size);
    for (Eigen::Index b = 0; b < size; ++b) {
        const Moving& by = moving[static_cast<std::size_t>(b)];
        const auto column = static_cast<Eigen::Index>(2 * by.member);
        const Eigen::Vector2d own = by.stiffness.cwiseProduct(by.way.along);
        for (Eigen::Index a = 0; a < size; ++a) {
            const Moving& on = moving[static_cast<std::size_t>(a)];
            Eigen::Vector2d force =
                B.block<2, 2>(static_cast<Eigen::Index>(2 * on.member), column).lazyProduct(by.way.along);
            if (on.member == by.member) force += own;
            A(a, b) = -on.way.slope.dot(force);
        }
        A(b, b) += 1.0;
    }
    factors_.compute(A);
    factored_ = moving;
}

Eigen::VectorXd Leap::moved(const std::vector<Moving>& moving, const Eigen::MatrixXd& B) {
    constexpr int most_rounds = 4;
    std::vector<std::size_t> left(moving.size());
    for (std::size_t n = 0; n < left.size(); ++n) left[n] = n;
    for (int round = 0; round < most_rounds && !left.empty(); ++round) {
        std::vector<Moving> some;
        Eigen::VectorXd due(static_cast<Eigen::Index>(left.size()));
        for (const std::size_t n : left) {
            due[static_cast<Eigen::Index>(some.size())] = moving[n].due;
            some.push_back(moving[n]);
        }
        if (!factorised(some)) factorise(some, B);
        const Eigen::VectorXd eta = factors_.solve(due);
        if (!eta.allFinite()) return {};
        std::vector<std::size_t> forward;
        Eigen::VectorXd all = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(moving.size()));
        for (std::size_t s = 0; s < left.size(); ++s) {
            const double by = eta[static_cast<Eigen::Index>(s)];
            if (!moving[left[s]].way.back && !(by >= 0.0)) continue;
            forward.push_back(left[s]);
            all[static_cast<Eigen::Index>(left[s])] = by;
        }
        if (forward.size() == left.size()) return all;
        left = std::move(forward);
    }
    return {};
}

} // namespace demlua::step
