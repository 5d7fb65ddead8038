#include "engine/step/at_rest.hpp"

#include "engine/state/parts.hpp"
#include "engine/step/loads.hpp"
#include "engine/step/motion.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>
#include <vector>

namespace demlua::step {

void refuse(const RestAsked& asked, const std::string& rule, const std::string& hint) {
    throw SceneError(Problem{asked.place, asked.word, "", rule, hint});
}

std::string pressed_contact(const state::State& state) {
    constexpr double rounding = 1e-9; // of the distance
    const state::Contacts& contacts = state.contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (state.overlap(c) <= rounding * contacts.reference[c]) continue;
        return fmt::format("elements {} and {} press on each other", contacts.i[c], contacts.j[c]);
    }
    return "";
}

void refuse_what_is_not_bonds(const state::State& state, const RestAsked& asked) {
    const std::string instead = "run the scene to rest instead";
    if (!state.walls.empty()) refuse(asked, "knows no walls", instead);
    if (!state.rigid_bodies.empty()) refuse(asked, "knows no rigid bodies", instead);
    const std::string pressed = pressed_contact(state);
    if (!pressed.empty()) refuse(asked, "knows bonds only, and " + pressed, instead);
}

void refuse_floating(const state::State& state, const Held& held, const RestAsked& asked) {
    constexpr std::size_t most_told = 5;
    std::vector<Problem> problems;
    for (const std::vector<std::size_t>& part : floating_parts(state, held)) {
        if (problems.size() == most_told) break;
        problems.push_back(
            {asked.place, asked.word, "",
             fmt::format("{} {} held by nothing", state::name_elements(state, part), part.size() == 1 ? "is" : "are"),
             "hold what may not move with sim:fix"});
    }
    if (!problems.empty()) throw SceneError(std::move(problems));
}

void stop_motion(state::Elements& elements) {
    for (Column<double>* column : {&elements.vx, &elements.vy, &elements.spin}) {
        std::fill(column->begin(), column->end(), 0.0);
    }
}

Eigen::VectorXd places_held(const state::Elements& elements, const Held& held) {
    Eigen::VectorXd at = held.jump;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(3 * k);
        const Eigen::Vector3d stands{elements.ux[k], elements.uy[k], elements.rotation[k]};
        for (Eigen::Index f = 0; f < 3; ++f) {
            if (held.is[static_cast<std::size_t>(row + f)] != 0) at[row + f] += stands[f];
        }
    }
    return at;
}

Eigen::VectorXd freedoms_per_radius(const state::Elements& elements) {
    Eigen::VectorXd factor = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(3 * elements.size()));
    for (std::size_t k = 0; k < elements.size(); ++k) {
        factor[static_cast<Eigen::Index>(3 * k + 2)] = 1.0 / elements.radius[k];
    }
    return factor;
}

Eigen::VectorXd forces_per_radius(const state::Elements& elements, const Eigen::VectorXd& per_radius) {
    Eigen::VectorXd force(per_radius.size());
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(3 * k);
        force[row] = elements.fx[k];
        force[row + 1] = elements.fy[k];
        force[row + 2] = elements.moment[k];
    }
    return force.cwiseProduct(per_radius);
}

Eigen::VectorXd outer_forces(state::State& state, Stepper& stepper, const Eigen::VectorXd& per_radius) {
    clear_forces(state, stepper.team);
    add_loads(state);
    return forces_per_radius(state.elements, per_radius);
}

} // namespace demlua::step
