#include "engine/step/springs.hpp"

#include "engine/step/facet_springs.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace demlua::step {

void Springs::add(double stiffness, double damping, std::span<const SpringEnd> ends) {
    ends_.insert(ends_.end(), ends.begin(), ends.end());
    last_.push_back(ends_.size());
    stiffness_.push_back(stiffness);
    damping_.push_back(damping);
}

std::span<const SpringEnd> Springs::ends(std::size_t spring) const {
    const std::size_t begin = spring == 0 ? 0 : last_[spring - 1];
    return {ends_.data() + begin, last_[spring] - begin};
}

bool Springs::damped() const {
    return std::any_of(damping_.begin(), damping_.end(), [](double c) { return c > 0.0; });
}

void Springs::scale(const Eigen::VectorXd& factor) {
    for (SpringEnd& end : ends_) {
        const Eigen::Index at = row(end.element);
        end.x *= factor[at];
        end.y *= factor[at + 1];
        end.turn *= factor[at + 2];
    }
}

Eigen::VectorXd Springs::times(double stiff, double damp, const Eigen::VectorXd& u) const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(u.size());
    for (std::size_t spring = 0; spring < size(); ++spring) {
        double stretch = 0.0;
        for (const SpringEnd& end : ends(spring)) {
            const double* const at = u.data() + row(end.element);
            stretch += end.x * at[0] + end.y * at[1] + end.turn * at[2];
        }
        stretch *= stiff * stiffness_[spring] + damp * damping_[spring];
        for (const SpringEnd& end : ends(spring)) {
            double* const at = force.data() + row(end.element);
            at[0] += end.x * stretch;
            at[1] += end.y * stretch;
            at[2] += end.turn * stretch;
        }
    }
    return force;
}

Eigen::SparseMatrix<double> Springs::sum(const std::vector<double>& weight) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t spring = 0; spring < size(); ++spring) {
        for (const SpringEnd& a : ends(spring)) {
            for (const SpringEnd& b : ends(spring)) {
                const std::array<double, 3> left{a.x, a.y, a.turn};
                const std::array<double, 3> right{b.x, b.y, b.turn};
                for (int p = 0; p < 3; ++p) {
                    for (int q = 0; q < 3; ++q) {
                        entries.emplace_back(row(a.element) + p, row(b.element) + q,
                                             weight[spring] * left[static_cast<std::size_t>(p)] *
                                                 right[static_cast<std::size_t>(q)]);
                    }
                }
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(freedoms(), freedoms());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Springs springs_of_body(const state::State& state, std::size_t body) {
    Springs springs(state.bodies[body].first, state.bodies[body].size());
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](const auto& bonds) {
                if (bonds.body == body) add_stiffness(bonds, state.elements, springs);
            },
            any);
    }
    return springs;
}

Springs springs_of(const state::State& state) {
    Springs springs(0, state.elements.size());
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit([&](const auto& bonds) { add_stiffness(bonds, state.elements, springs); }, any);
    }
    return springs;
}

Springs tangent_of(const state::State& state) {
    Springs springs(0, state.elements.size());
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit([&](const auto& bonds) { add_tangent(bonds, state.elements, springs); }, any);
    }
    return springs;
}

Eigen::VectorXd inverse_root_masses(const state::Elements& elements, std::size_t first, std::size_t last) {
    Eigen::VectorXd factor(static_cast<Eigen::Index>(3 * (last - first)));
    for (std::size_t k = first; k < last; ++k) {
        const auto at = static_cast<Eigen::Index>(3 * (k - first));
        factor[at] = factor[at + 1] = std::sqrt(elements.inverse_mass[k]);
        factor[at + 2] = std::sqrt(elements.inverse_inertia[k]);
    }
    return factor;
}

} // namespace demlua::step
