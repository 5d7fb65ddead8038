#include "engine/step/static_solve.hpp"

#include "engine/step/at_rest.hpp"
#include "engine/step/held_system.hpp"
#include "engine/step/loads.hpp"
#include "engine/step/springs.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace demlua::step {

namespace {

/// The first bond, in words, that has yielded or broken since.
template <class Bonds>
std::optional<std::string> yielded(const Bonds& now, const Bonds& before) {
    for (std::size_t k = 0; k < now.size(); ++k) {
        bool changed = now.is_broken(k) != before.is_broken(k);
        for (std::size_t m = 0; m < now.history.columns.size(); ++m) {
            changed = changed || now.history.columns[m][k] != before.history.columns[m][k];
        }
        if (changed) return fmt::format("the bond of elements {} and {} would yield", now.i[k], now.j[k]);
    }
    return std::nullopt;
}

class Rest {
public:
    Rest(state::State& state, Stepper& stepper, const model::StaticSolve& said)
        : state_(state), stepper_(stepper), said_(said), asked_{said.place, "solve_static"}, before_(state),
          per_radius_(freedoms_per_radius(state.elements)) {}

    StaticAnswer find() {
        try {
            return find_or_throw();
        } catch (...) {
            state_ = before_;
            put_in_doubt(stepper_.search);
            throw;
        }
    }

private:
    StaticAnswer find_or_throw() {
        refuse_what_is_not_bonds(state_, asked_);
        ++state_.step;
        state_.time += state_.dt;
        stop_motion(state_.elements);
        held_ = held_freedoms(state_);
        refuse_floating(state_, held_, asked_);
        StaticAnswer answer = said_.linear ? once() : repeatedly();
        evaluate();
        settle();
        return answer;
    }

    /// Forces where the elements stand, from the memory that bonds and contacts had before: on the way to rest nothing is
    /// remembered.
    void evaluate() {
        state_.bond_sets = before_.bond_sets;
        state_.contacts = before_.contacts;
        state_.cracks = before_.cracks;
        put_in_doubt(stepper_.search);
        const double dt = std::exchange(state_.dt, 0.0);
        compute_forces(state_, stepper_);
        state_.dt = dt;
    }

    /// What is left on free rows, of the loads and reactions.
    [[nodiscard]] double share_left(const Eigen::VectorXd& force, double outer) const {
        double left = 0.0;
        double reactions = 0.0;
        for (Eigen::Index row = 0; row < force.size(); ++row) {
            double& sum = held_.is[static_cast<std::size_t>(row)] != 0 ? reactions : left;
            sum += force[row] * force[row];
        }
        const double scale = outer + std::sqrt(reactions);
        return left == 0.0 ? 0.0 : std::sqrt(left) / scale;
    }

    /// Adds moves (rotations in radii) to where the elements stand.
    void move_by(const Eigen::VectorXd& moves) {
        state::Elements& elements = state_.elements;
        for (std::size_t k = 0; k < elements.size(); ++k) {
            const auto row = static_cast<Eigen::Index>(3 * k);
            elements.ux[k] += moves[row];
            elements.uy[k] += moves[row + 1];
            elements.rotation[k] += moves[row + 2] * per_radius_[row + 2];
        }
    }

    [[nodiscard]] Eigen::VectorXd solution(Springs springs, const Eigen::VectorXd& force,
                                           const Eigen::VectorXd& jump) const {
        springs.scale(per_radius_);
        const HeldSystem system(springs.stiffness_matrix(), held_.is);
        if (system.singular()) {
            refuse(asked_, "the bonds leave a motion that takes no force", "look for a hinge or a chain");
        }
        return system.solve(force, jump);
    }

    StaticAnswer once() {
        state::Elements& elements = state_.elements;
        const Eigen::VectorXd at = places_held(elements, held_);
        for (Column<double>* column : {&elements.ux, &elements.uy, &elements.rotation}) {
            std::fill(column->begin(), column->end(), 0.0);
        }
        const Eigen::VectorXd outer = outer_forces(state_, stepper_, per_radius_);
        move_by(solution(springs_of(state_), outer, at.cwiseQuotient(per_radius_)));
        evaluate();
        return {1, share_left(forces_per_radius(state_.elements, per_radius_), outer.norm())};
    }

    StaticAnswer repeatedly() {
        constexpr double greatest_turn = 0.2; // rad in one solution; beyond it a tangent says little
        const double outer = outer_forces(state_, stepper_, per_radius_).norm();
        Eigen::VectorXd jump = held_.jump.cwiseQuotient(per_radius_);
        StaticAnswer answer;
        while (true) {
            evaluate();
            const Eigen::VectorXd force = forces_per_radius(state_.elements, per_radius_);
            answer.residual = share_left(force, outer);
            if (jump.squaredNorm() == 0.0 && answer.residual <= said_.tolerance) return answer;
            if (!std::isfinite(answer.residual) || answer.solutions == static_cast<int>(said_.max_iterations)) break;
            const Eigen::VectorXd moves = solution(tangent_of(state_), force, jump);
            const double share = std::min(1.0, greatest_turn / farthest_turn(moves));
            move_by(share * moves);
            jump = share < 1.0 ? Eigen::VectorXd((1.0 - share) * jump) : Eigen::VectorXd::Zero(jump.size());
            ++answer.solutions;
        }
        refuse_yielded();
        refuse(asked_,
               fmt::format("finds no rest: after {} solutions {:.2g} of the loads is left on free elements",
                           answer.solutions, answer.residual),
               "put the load on in parts, one sim:solve_static after each, or allow a larger tolerance");
    }

    [[nodiscard]] double farthest_turn(const Eigen::VectorXd& moves) const {
        double farthest = std::numeric_limits<double>::min();
        for (Eigen::Index row = 2; row < moves.size(); row += 3) {
            farthest = std::max(farthest, std::fabs(moves[row] * per_radius_[row]));
        }
        return farthest;
    }

    void refuse_yielded() const {
        for (std::size_t set = 0; set < state_.bond_sets.size(); ++set) {
            std::visit(
                [&](const auto& bonds) {
                    using Set = std::decay_t<decltype(bonds)>;
                    const auto one = yielded(bonds, std::get<Set>(before_.bond_sets[set]));
                    if (one) refuse(asked_, "knows elastic bonds only, and " + *one, "run the scene to rest instead");
                },
                state_.bond_sets[set]);
        }
    }

    /// Takes the present place as the state at rest, if bonds and contacts allow it.
    void settle() {
        refuse_yielded();
        const std::string pressed = pressed_contact(state_);
        if (!pressed.empty()) {
            refuse(asked_, "knows bonds only, and at rest " + pressed, "run the scene to rest instead");
        }
        if (!state_.drives.empty()) apply_drives(state_);
    }

    state::State& state_;
    Stepper& stepper_;
    const model::StaticSolve& said_;
    RestAsked asked_;
    state::State before_;
    Eigen::VectorXd per_radius_; ///< 1, 1, 1/R of each element: rotation = value / R
    Held held_;
};

} // namespace

StaticAnswer solve_static(state::State& state, Stepper& stepper, const model::StaticSolve& said) {
    return Rest(state, stepper, said).find();
}

} // namespace demlua::step
