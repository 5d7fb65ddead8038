#include "engine/step/static_solve.hpp"

#include "engine/state/parts.hpp"
#include "engine/step/held.hpp"
#include "engine/step/held_system.hpp"
#include "engine/step/loads.hpp"
#include "engine/step/motion.hpp"
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

[[noreturn]] void refuse(const model::StaticSolve& said, const std::string& rule, const std::string& hint) {
    throw SceneError(Problem{said.place, "solve_static", "", rule, hint});
}

/// The first contact that presses, as words.
std::optional<std::string> pressed_contact(const state::State& state) {
    const state::Contacts& contacts = state.contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (contacts.overlap[c] <= 0.0) continue;
        return fmt::format("elements {} and {} press on each other", contacts.i[c], contacts.j[c]);
    }
    return std::nullopt;
}

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
        : state_(state), stepper_(stepper), said_(said), before_(state),
          per_radius_(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(3 * state.elements.size()))) {
        for (std::size_t k = 0; k < state.elements.size(); ++k) {
            per_radius_[static_cast<Eigen::Index>(3 * k + 2)] = 1.0 / state.elements.radius[k];
        }
    }

    StaticAnswer find() {
        try {
            return find_or_throw();
        } catch (...) {
            state_ = before_;
            stepper_.search.travelled = std::numeric_limits<double>::infinity();
            throw;
        }
    }

private:
    StaticAnswer find_or_throw() {
        refuse_what_is_not_bonds();
        ++state_.step;
        state_.time += state_.dt;
        stop();
        held_ = held_freedoms(state_);
        refuse_floating();
        StaticAnswer answer = said_.linear ? once() : repeatedly();
        evaluate();
        settle();
        return answer;
    }

    void refuse_what_is_not_bonds() const {
        if (!state_.walls.empty()) refuse(said_, "knows no walls", "run the scene to rest instead");
        if (!state_.rigid_bodies.empty()) refuse(said_, "knows no rigid bodies", "run the scene to rest instead");
        if (const auto pressed = pressed_contact(state_)) {
            refuse(said_, "knows bonds only, and " + *pressed, "run the scene to rest instead");
        }
    }

    void refuse_floating() const {
        constexpr std::size_t most_told = 5;
        std::vector<Problem> problems;
        for (const std::vector<std::size_t>& part : floating_parts(state_, held_)) {
            if (problems.size() == most_told) break;
            problems.push_back({said_.place, "solve_static", "",
                                fmt::format("{} {} held by nothing", state::name_elements(state_, part),
                                            part.size() == 1 ? "is" : "are"),
                                "hold what may not move with sim:fix"});
        }
        if (!problems.empty()) throw SceneError(std::move(problems));
    }

    void stop() {
        for (Column<double>* column : {&state_.elements.vx, &state_.elements.vy, &state_.elements.spin}) {
            std::fill(column->begin(), column->end(), 0.0);
        }
    }

    /// Forces where the elements stand, from the memory that bonds and contacts had before: on the way to rest nothing is
    /// remembered.
    void evaluate() {
        state_.bond_sets = before_.bond_sets;
        state_.contacts = before_.contacts;
        state_.cracks = before_.cracks;
        stepper_.search.travelled = std::numeric_limits<double>::infinity();
        const double dt = std::exchange(state_.dt, 0.0);
        compute_forces(state_, stepper_);
        state_.dt = dt;
    }

    [[nodiscard]] Eigen::VectorXd forces_per_radius() const {
        const state::Elements& elements = state_.elements;
        Eigen::VectorXd force(per_radius_.size());
        for (std::size_t k = 0; k < elements.size(); ++k) {
            const auto row = static_cast<Eigen::Index>(3 * k);
            force[row] = elements.fx[k];
            force[row + 1] = elements.fy[k];
            force[row + 2] = elements.moment[k];
        }
        return force.cwiseProduct(per_radius_);
    }

    [[nodiscard]] Eigen::VectorXd outer_forces() {
        clear_forces(state_, stepper_.team);
        add_loads(state_);
        return forces_per_radius();
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
            refuse(said_, "the bonds leave a motion that takes no force", "look for a hinge or a chain");
        }
        return system.solve(force, jump);
    }

    StaticAnswer once() {
        state::Elements& elements = state_.elements;
        Eigen::VectorXd at = held_.jump;
        for (std::size_t k = 0; k < elements.size(); ++k) {
            const auto row = static_cast<Eigen::Index>(3 * k);
            const Eigen::Vector3d stands{elements.ux[k], elements.uy[k], elements.rotation[k]};
            for (Eigen::Index f = 0; f < 3; ++f) {
                if (held_.is[static_cast<std::size_t>(row + f)] != 0) at[row + f] += stands[f];
            }
            elements.ux[k] = elements.uy[k] = elements.rotation[k] = 0.0;
        }
        const Eigen::VectorXd outer = outer_forces();
        move_by(solution(springs_of(state_), outer, at.cwiseQuotient(per_radius_)));
        evaluate();
        return {1, share_left(forces_per_radius(), outer.norm())};
    }

    StaticAnswer repeatedly() {
        constexpr double greatest_turn = 0.2; // rad in one solution; beyond it a tangent says little
        const double outer = outer_forces().norm();
        Eigen::VectorXd jump = held_.jump.cwiseQuotient(per_radius_);
        StaticAnswer answer;
        while (true) {
            evaluate();
            const Eigen::VectorXd force = forces_per_radius();
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
        refuse(said_,
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
                    if (one) refuse(said_, "knows elastic bonds only, and " + *one, "run the scene to rest instead");
                },
                state_.bond_sets[set]);
        }
    }

    /// Takes the present place as the state at rest, if bonds and contacts allow it.
    void settle() {
        refuse_yielded();
        if (const auto pressed = pressed_contact(state_)) {
            refuse(said_, "knows bonds only, and at rest " + *pressed, "run the scene to rest instead");
        }
        if (!state_.drives.empty()) apply_drives(state_);
    }

    state::State& state_;
    Stepper& stepper_;
    const model::StaticSolve& said_;
    state::State before_;
    Eigen::VectorXd per_radius_; ///< 1, 1, 1/R of each element: rotation = value / R
    Held held_;
};

} // namespace

StaticAnswer solve_static(state::State& state, Stepper& stepper, const model::StaticSolve& said) {
    return Rest(state, stepper, said).find();
}

} // namespace demlua::step
