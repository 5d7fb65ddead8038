#include "engine/step/failing_part.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace demlua::step {

namespace {

/// Of a bond's own stiffness, what it is taken to meet at least: where it alone holds a part, offsets meet nothing.
constexpr double least_share = 1e-3;

void put(const ElementForces& forces, double factor, const Eigen::VectorXd& per_radius, Eigen::VectorXd& sum) {
    for (const SpringEnd& end : forces) {
        const auto row = static_cast<Eigen::Index>(3 * end.element);
        sum[row] += factor * end.x;
        sum[row + 1] += factor * end.y;
        sum[row + 2] += factor * end.turn * per_radius[row + 2];
    }
}

} // namespace

Eigen::VectorXd FailingPart::half_response(const ElementForces& forces) const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(per_radius_.size());
    put(forces, 1.0, per_radius_, right);
    for (const SpringEnd& end : forces) hold_back(end.element, right);
    return system_.forward(right);
}

/// Forces on held freedoms move nothing.
void FailingPart::hold_back(std::size_t element, Eigen::VectorXd& right) const {
    const auto row = static_cast<Eigen::Index>(3 * element);
    for (const Eigen::Index r : {row, row + 1, row + 2}) {
        if (system_.is_held(r)) right[r] = 0.0;
    }
}

void FailingPart::add(FailingBonds& set, std::size_t bond) {
    const auto mine = static_cast<Eigen::Index>(2 * members_.size());
    if (mine + 2 > B_.rows()) B_.conservativeResize(2 * mine + 32, 2 * mine + 32);
    const std::size_t row = set.add_row(bond);
    Member fresh{&set, row, {}, {}, least_share * set.coupling(bond, bond).diagonal()};
    fresh.forces = {set.offset_forces(bond, Eigen::Vector2d::UnitX()),
                    set.offset_forces(bond, Eigen::Vector2d::UnitY())};
    std::array<Eigen::VectorXd, 2> moved;
    for (const std::size_t c : {0U, 1U}) {
        const Eigen::VectorXd half = half_response(fresh.forces[c]);
        fresh.halves[c] = half.sparseView();
        moved[c] = system_.over_pivots(half);
    }
    members_.push_back(std::move(fresh));
    for (std::size_t n = 0; n < members_.size(); ++n) {
        const Member& other = members_[n];
        Eigen::Matrix2d force;
        for (const Eigen::Index c : {0, 1}) {
            const Eigen::VectorXd& u = moved[static_cast<std::size_t>(c)];
            force.col(c) << other.halves[0].dot(u), other.halves[1].dot(u);
        }
        if (other.set == &set) force -= set.coupling(set.bond(other.row), bond);
        const auto its = static_cast<Eigen::Index>(2 * n);
        B_.block<2, 2>(its, mine) = force;
        B_.block<2, 2>(mine, its) = force.transpose();
    }
}

Eigen::VectorXd FailingPart::offsets() const {
    Eigen::VectorXd w(static_cast<Eigen::Index>(2 * members_.size()));
    for (std::size_t n = 0; n < members_.size(); ++n) {
        w.segment<2>(static_cast<Eigen::Index>(2 * n)) = members_[n].set->offset(members_[n].row);
    }
    return w;
}

double FailingPart::relax(const Eigen::VectorXd& loaded, double tolerance, int sweeps) {
    const auto size = static_cast<Eigen::Index>(2 * members_.size());
    Eigen::VectorXd force = B_.topLeftCorner(size, size) * offsets();
    for (std::size_t n = 0; n < members_.size(); ++n) {
        const auto at = static_cast<Eigen::Index>(2 * n);
        for (const Eigen::Index c : {0, 1}) {
            force[at + c] += work_of(members_[n].forces[static_cast<std::size_t>(c)], loaded);
        }
    }
    double worst = 0.0;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        worst = 0.0;
        for (std::size_t n = 0; n < members_.size(); ++n) {
            const auto at = static_cast<Eigen::Index>(2 * n);
            const Member& member = members_[n];
            const Eigen::Vector2d met = Eigen::Vector2d{-B_(at, at), -B_(at + 1, at + 1)}.cwiseMax(member.least);
            const GivenWay given = member.set->give_way(member.row, force.segment<2>(at), met);
            worst = std::max(worst, given.beyond / member.set->strength(member.row));
            if (given.moved != Eigen::Vector2d::Zero()) force.noalias() += B_.block(0, at, size, 2) * given.moved;
        }
        if (worst <= tolerance) break;
    }
    return worst;
}

Eigen::VectorXd FailingPart::displacements() const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(per_radius_.size());
    for (const Member& member : members_) {
        const Eigen::Vector2d w = member.set->offset(member.row);
        for (const Eigen::Index c : {0, 1}) {
            if (w[c] != 0.0) put(member.forces[static_cast<std::size_t>(c)], w[c], per_radius_, right);
        }
    }
    for (const Member& member : members_) {
        for (const SpringEnd& end : member.forces[0]) hold_back(end.element, right);
    }
    return system_.backward(system_.forward(right)).cwiseProduct(per_radius_);
}

double FailingPart::largest_offset() const { return members_.empty() ? 0.0 : offsets().cwiseAbs().maxCoeff(); }

} // namespace demlua::step
