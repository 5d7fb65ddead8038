// Growth of a cohesive zone on a ligament.
#include "tests/cohesive_crack.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <stdexcept>

namespace demlua::test {

namespace {

constexpr double fracture_energy = std::numbers::pi;
constexpr double last_softening_opening = 2.0 * fracture_energy;
constexpr double last_plateau_opening = fracture_energy;

using Cell3 = std::array<double, 3>;
constexpr Cell3 gauss_places{-0.774596669241483377, 0.0, 0.774596669241483377};
constexpr Cell3 gauss_weights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

Eigen::Vector3d parabolas(double x) { return {0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)}; }

struct Traction {
    double value;
    double slope; // over the opening
};

Traction traction(Softening shape, double opening) {
    if (shape == Softening::plateau || opening < 0.0) {
        return {1.0, 0.0};
    }
    const double left = 1.0 - opening / last_softening_opening;
    return left > 0.0 ? Traction{left, -1.0 / last_softening_opening} : Traction{0.0, 0.0};
}

/// Forces that the ligament opposes to its half-openings v, with their slopes.
void add_cohesion(const Ligament& ligament, Softening shape, const Eigen::VectorXd& v, Eigen::VectorXd& force,
                  Eigen::MatrixXd& slope) {
    const Eigen::Index rows = force.size();
    for (Eigen::Index first = 0; first + 2 < v.size() && first < rows; first += 2) {
        const double half =
            0.5 * (ligament.x[static_cast<std::size_t>(first + 2)] - ligament.x[static_cast<std::size_t>(first)]);
        for (std::size_t g = 0; g < 3; ++g) {
            const Eigen::Vector3d N = parabolas(gauss_places[g]);
            const Traction q = traction(shape, 2.0 * N.dot(v.segment<3>(first)));
            const double length = half * gauss_weights[g];
            for (Eigen::Index i = 0; i < 3 && first + i < rows; ++i) {
                force[first + i] += length * N[i] * q.value;
                for (Eigen::Index j = 0; j < 3 && first + j < slope.cols(); ++j) {
                    slope(first + i, first + j) += length * N[i] * N[j] * 2.0 * q.slope;
                }
            }
        }
    }
}

/// Half-openings of all nodes and the load with the zone's tip at node `tip`, by Newton's method from the values given.
void balance(const Ligament& ligament, Softening shape, Eigen::Index tip, Eigen::VectorXd& v, double& load) {
    const Eigen::Index rows = tip + 1;
    const auto stiffness = ligament.stiffness.topLeftCorner(rows, tip);
    const auto pull = ligament.pull.head(rows);
    for (int turn = 0; turn < 50; ++turn) {
        Eigen::VectorXd cohesion = Eigen::VectorXd::Zero(rows);
        Eigen::MatrixXd tangent(rows, rows);
        tangent.leftCols(tip) = stiffness;
        tangent.col(tip) = -pull;
        Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(rows, tip);
        add_cohesion(ligament, shape, v, cohesion, slope);
        tangent.leftCols(tip) += slope;
        const Eigen::VectorXd change = tangent.partialPivLu().solve(load * pull - stiffness * v.head(tip) - cohesion);
        v.head(tip) += change.head(tip);
        load += change[tip];
        if (change.head(tip).lpNorm<Eigen::Infinity>() < 1e-10 && std::fabs(change[tip]) < 1e-11) {
            return;
        }
    }
    throw std::runtime_error("cohesive crack: no balance");
}

/// The place at which the traction sets in.
double zone_start(const Ligament& ligament, Softening shape, const Eigen::VectorXd& v) {
    const double last = shape == Softening::linear ? last_softening_opening : last_plateau_opening;
    std::size_t k = 0;
    while (2.0 * v[static_cast<Eigen::Index>(k)] > last) {
        ++k;
    }
    if (k == 0) {
        return ligament.x.front();
    }
    const double before = 2.0 * v[static_cast<Eigen::Index>(k - 1)];
    const double after = 2.0 * v[static_cast<Eigen::Index>(k)];
    return ligament.x[k] - (ligament.x[k] - ligament.x[k - 1]) * (last - after) / (before - after);
}

Growth between(const Growth& a, const Growth& b, double share) {
    const auto mean = [share](double from, double to) { return from + share * (to - from); };
    return {mean(a.tip, b.tip), mean(a.load, b.load), mean(a.opening, b.opening), mean(a.zone_from, b.zone_from)};
}

/// Energy in half the body under a unit load, the nodes before `open` free, less that with all closed.
double released(const Ligament& ligament, Eigen::Index open) {
    if (open == 0) {
        return 0.0;
    }
    const Eigen::VectorXd pull = ligament.pull.head(open);
    return 0.5 * pull.dot(ligament.stiffness.topLeftCorner(open, open).llt().solve(pull));
}

} // namespace

std::vector<Growth> grow(const Ligament& ligament, Softening shape, double stop) {
    const auto nodes = static_cast<Eigen::Index>(ligament.x.size());
    Eigen::VectorXd v = Eigen::VectorXd::Zero(nodes);
    double load = 0.0;
    double highest = 0.0;
    std::vector<Growth> states;
    for (Eigen::Index tip = 0; tip < nodes; tip += 2) {
        balance(ligament, shape, tip, v, load);
        states.push_back({ligament.x[static_cast<std::size_t>(tip)], load, 2.0 * v[0], zone_start(ligament, shape, v)});
        highest = std::max(highest, load);
        const bool past = shape == Softening::linear ? load < stop * highest : 2.0 * v[0] > last_plateau_opening;
        if (past) {
            return states;
        }
    }
    throw std::runtime_error("cohesive crack: the zone outgrows the fine part of the ligament");
}

Growth peak(const std::vector<Growth>& states, Softening shape) {
    if (shape == Softening::plateau) {
        const Growth& before = states[states.size() - 2];
        const Growth& after = states.back();
        return between(before, after, (last_plateau_opening - before.opening) / (after.opening - before.opening));
    }
    const auto highest = std::max_element(states.begin(), states.end(),
                                          [](const Growth& a, const Growth& b) { return a.load < b.load; });
    if (highest == states.begin()) {
        return *highest;
    }
    // The parabola through three equally spaced tips.
    const double before = std::prev(highest)->load;
    const double after = std::next(highest)->load;
    const double bend = before - 2.0 * highest->load + after;
    const double share = bend < 0.0 ? 0.5 * (before - after) / bend : 0.0;
    Growth top =
        share < 0.0 ? between(*highest, *std::prev(highest), -share) : between(*highest, *std::next(highest), share);
    top.load = highest->load - 0.5 * bend * share * share;
    return top;
}

double stress_intensity(const Ligament& ligament, int corner) {
    const auto at = static_cast<std::size_t>(corner);
    const double length = ligament.x[at + 2] - ligament.x[at - 2];
    return std::sqrt(2.0 * (released(ligament, corner + 2) - released(ligament, corner - 2)) / length);
}

} // namespace demlua::test
