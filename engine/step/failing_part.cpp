#include "engine/step/failing_part.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace demlua::step {

namespace {

/// Of a bond's own stiffness, what it is taken to meet at least: where it alone holds a part, offsets meet nothing.
constexpr double least_share = 1e-3;
/// After so many, those that still move are those that will; twice as many after each leap in vain.
constexpr int sweeps_before_leap = 4;

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

Eigen::Vector2d FailingPart::met(std::size_t n) const {
    const auto at = static_cast<Eigen::Index>(2 * n);
    return Eigen::Vector2d{-B_(at, at), -B_(at + 1, at + 1)}.cwiseMax(members_[n].least);
}

/// Each in turn; gives what was the most beyond its strength.
double FailingPart::sweep(Eigen::VectorXd& force, Eigen::VectorXd& moved) {
    double worst = 0.0;
    for (std::size_t n = 0; n < members_.size(); ++n) {
        const auto at = static_cast<Eigen::Index>(2 * n);
        const Member& member = members_[n];
        const GivenWay given = member.set->give_way(member.row, force.segment<2>(at), met(n));
        worst = std::max(worst, given.beyond / member.set->strength(member.row));
        moved.segment<2>(at) = given.moved;
        if (given.moved != Eigen::Vector2d::Zero()) {
            force.noalias() += B_.block(0, at, force.size(), 2) * given.moved;
        }
    }
    return worst;
}

/// Those that `moved` most in the last sweep, where `worst` was the most; the others go by themselves.
std::vector<Moving> FailingPart::moving_now(const Eigen::VectorXd& force, const Eigen::VectorXd& moved,
                                            double worst) const {
    constexpr double least_moved = 0.2; // of the most
    std::vector<Moving> moving;
    for (std::size_t n = 0; n < members_.size(); ++n) {
        const auto at = static_cast<Eigen::Index>(2 * n);
        const Eigen::Vector2d last = moved.segment<2>(at);
        const Member& member = members_[n];
        const Eigen::Vector2d stiffness = member.set->reckoned(member.row, met(n));
        if (!(stiffness.cwiseProduct(last).norm() > least_moved * worst * member.set->strength(member.row))) continue;
        const Eigen::Vector2d now = force.segment<2>(at);
        const Eigen::Vector2d due = member.set->would_give(member.row, now, met(n)).moved;
        for (const Way& way : member.set->ways(member.row, now, met(n), last)) {
            moving.push_back({n, way, way.along.dot(due), stiffness});
        }
    }
    return moving;
}

/// The share of `eta` to use: laws are not linear.
double FailingPart::share_of_leap(const std::vector<Moving>& moving, const Eigen::VectorXd& eta) const {
    constexpr double most = 0.95;
    constexpr double farthest = 0.5; // in strengths over the stiffness met
    double far = 0.0;
    for (std::size_t a = 0; a < moving.size(); ++a) {
        const Moving& one = moving[a];
        const double of = eta[static_cast<Eigen::Index>(a)] * one.stiffness.cwiseProduct(one.way.along).norm();
        far = std::max(far, std::fabs(of) / members_[one.member].set->strength(members_[one.member].row));
    }
    return far * most > farthest ? farthest / far : most;
}

/// Moves together those that move most (leap.hpp). False, and nothing moves, where they would not come to rest.
bool FailingPart::leap(Eigen::VectorXd& force, const Eigen::VectorXd& moved, double worst) {
    constexpr std::size_t most = 800;
    const std::vector<Moving> moving = moving_now(force, moved, worst);
    if (moving.empty() || moving.size() > most) return false;
    Eigen::VectorXd eta = leap_.moved(moving, B_);
    if (eta.size() == 0) return false;
    eta *= share_of_leap(moving, eta);

    std::map<std::size_t, Eigen::Vector2d> together;
    for (std::size_t a = 0; a < moving.size(); ++a) {
        const auto [place, fresh] = together.try_emplace(moving[a].member, Eigen::Vector2d::Zero());
        place->second += eta[static_cast<Eigen::Index>(a)] * moving[a].way.along;
    }
    Eigen::VectorXd change = Eigen::VectorXd::Zero(force.size());
    for (const auto& [n, own] : together) {
        // What the others do to it, and its own stiffness in place of what its law takes into account.
        const auto at = static_cast<Eigen::Index>(2 * n);
        Eigen::Vector2d trial =
            force.segment<2>(at) + members_[n].set->reckoned(members_[n].row, met(n)).cwiseProduct(own);
        for (const auto& [m, of_other] : together) {
            trial += B_.block<2, 2>(at, static_cast<Eigen::Index>(2 * m)) * of_other;
        }
        const GivenWay given = members_[n].set->give_way(members_[n].row, trial, met(n));
        change.noalias() += B_.block(0, at, force.size(), 2) * given.moved;
    }
    force += change;
    return true;
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
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(size);
    double worst = 0.0;
    int before_leap = sweeps_before_leap;
    int since = 0;
    for (int done = 0; done < sweeps; ++done) {
        worst = sweep(force, moved);
        if (worst <= tolerance) break;
        if (++since < before_leap) continue;
        since = 0;
        before_leap = leap(force, moved, worst) ? sweeps_before_leap : 2 * before_leap;
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
