// What changes a simulation between runs, or from a watcher.
#include "engine/observe/ledger.hpp"
#include "engine/observe/simulation_inside.hpp"
#include "engine/state/bond_assembly.hpp"
#include "engine/state/loading.hpp"
#include "engine/state/selection.hpp"
#include "engine/state/wall_assembly.hpp"
#include "engine/step/loads.hpp"
#include "engine/step/outline_search.hpp"
#include "engine/step/wall_start.hpp"

#include <fmt/format.h>
#include <tuple>
#include <utility>
#include <variant>

namespace demlua::observe {

namespace {

law::Rayleigh rayleigh_of(const model::Damping& damping) {
    if (damping.second_fraction && damping.second_frequency) {
        return law::rayleigh(damping.fraction, damping.frequency, *damping.second_fraction, *damping.second_frequency);
    }
    return law::rayleigh(damping.fraction, damping.frequency);
}

} // namespace

void Simulation::add_drives(std::vector<std::size_t>& rows, std::vector<state::Drive> drives) {
    for (state::Drive& drive : drives) {
        rows.push_back(state_->drives.size());
        state_->drives.push_back(std::move(drive));
    }
}

void Simulation::take_in(const model::Scene& scene) {
    Taken& taken = inside_->taken;
    const model::Scene& assembled = inside_->scene;
    const auto refuse_more = [](const auto& rows, const auto& known, const char* word) {
        if (rows.size() == known.size()) return;
        throw SceneError(Problem{rows.back().place, word, "", "must be said before the first run", ""});
    };
    refuse_more(scene.bodies, assembled.bodies, "body");
    refuse_more(scene.walls, assembled.walls, "wall");
    refuse_more(scene.outlines, assembled.outlines, "outline");
    std::vector<Problem> problems;
    const auto attempt = [&](const auto& work) {
        try {
            work();
        } catch (const SceneError& error) {
            problems.insert(problems.end(), error.problems().begin(), error.problems().end());
        }
    };
    for (; taken.notches < scene.notches.size(); ++taken.notches) {
        attempt([&] { take_in(scene.notches[taken.notches]); });
    }
    std::vector<std::size_t> unreplaceable;
    for (; taken.supports < scene.supports.size(); ++taken.supports) {
        attempt([&] { add_drives(unreplaceable, state::drives_of(scene.supports[taken.supports], *state_)); });
    }
    for (std::size_t row = taken.motions.size(); row < scene.motions.size(); ++row) {
        Moved& moved = taken.motions.emplace_back();
        attempt([&] {
            moved.elements = state::rows_of(scene.motions[row], *state_);
            add_drives(moved.drives, state::drives_of(scene.motions[row], moved.elements, *state_));
        });
    }
    for (std::size_t row = taken.forces.size(); row < scene.forces.size(); ++row) {
        taken.forces.push_back(state_->loads.size());
        attempt([&] { state_->loads.push_back(state::load_of(scene.forces[row], *state_)); });
    }
    for (std::size_t row = taken.tractions.size(); row < scene.tractions.size(); ++row) {
        const model::Traction& traction = scene.tractions[row];
        taken.tractions.push_back(state_->loads.size());
        attempt([&] {
            state_->loads.push_back(state::load_of(traction, scene.bodies[traction.selection.body.value()], *state_));
            add_drives(unreplaceable, state::drives_of(traction, *state_));
        });
    }
    for (std::size_t row = taken.probed.size(); row < scene.bond_probes.size(); ++row) {
        taken.probed.emplace_back();
        attempt([&] { taken.probed.back() = bond_of(scene.bond_probes[row], *state_); });
    }
    if (!problems.empty()) throw SceneError(std::move(problems));
    if (taken.dampings < scene.dampings.size()) {
        taken.dampings = scene.dampings.size();
        take_in(scene.dampings.back());
    }
    inside_->scene = scene;
}

void Simulation::take_in(const model::Notch& notch) {
    const double held = inside_->started ? ledger_of(*state_).bonds : 0.0;
    if (state::cut(*state_, notch.body, notch.from, notch.to) == 0) {
        throw SceneError(
            Problem{notch.place, "notch", "", "cuts no bond of body \"" + state_->bodies.at(notch.body).name + '"',
                    "it must cross a line between two bonded centres, whose bond can break and still holds"});
    }
    step::put_in_doubt(inside_->stepper.search);
    inside_->step_outdated = true;
    if (inside_->started) release(notch.body, held);
}

/// Forces without bonds of `body` that have just been cut. What they and their cells held of `before`, the energy of all
/// bonds, is booked as that of breaking bonds.
void Simulation::release(std::size_t body, double before) {
    const double dt = std::exchange(state_->dt, 0.0);
    step::compute_forces(*state_, inside_->stepper);
    state_->dt = dt;
    if (!state_->drives.empty()) step::apply_drives(*state_);
    const double released = before - ledger_of(*state_).bonds;
    for (state::AnyBondSet& any : state_->bond_sets) {
        std::visit(
            [&](auto& bonds) {
                if (bonds.body == body) bonds.fracture_work += released;
            },
            any);
    }
}

void Simulation::take_in(const model::Damping& said) {
    const law::Rayleigh damping = rayleigh_of(said);
    state_->alpha = damping.alpha;
    for (state::AnyBondSet& bonds : state_->bond_sets) {
        if (damping.beta != inside_->beta) state::add_stiffness_damping(bonds, damping.beta - inside_->beta);
    }
    inside_->beta = damping.beta;
    inside_->step_outdated = true;
}

void Simulation::replace_force(std::size_t row, const model::Force& force) {
    state::Load& load = state_->loads[inside_->taken.forces.at(row)];
    load.x = force.x;
    load.y = force.y;
}

void Simulation::replace_traction(std::size_t row, const model::Traction& traction) {
    state::Load& load = state_->loads[inside_->taken.tractions.at(row)];
    load.x = traction.stress_x;
    load.y = traction.stress_y;
}

void Simulation::replace_motion(std::size_t row, const model::Motion& motion) {
    Moved& moved = inside_->taken.motions.at(row);
    for (const std::size_t old : moved.drives) state_->drives[old] = {};
    moved.drives.clear();
    add_drives(moved.drives, state::drives_of(motion, moved.elements, *state_));
}

void Simulation::replace_wall(std::size_t row, const model::Wall& wall) {
    state::set_motion(wall, *state_, state_->walls.at(row));
}

void Simulation::replace_outline(std::size_t row, const model::Outline& outline) {
    const double before = balance(ledger_of(*state_));
    state::Wall& wall_of_it = state_->walls.at(inside_->scene.walls.size() + row);
    const auto freedoms = [&] {
        return std::tuple{wall_of_it.free_x(), wall_of_it.free_y(), wall_of_it.free_to_turn()};
    };
    const auto free_before = freedoms();
    state::set_motion(outline, wall_of_it);
    if (freedoms() != free_before) inside_->shorten_step(*state_);
    std::vector<Problem> too_wide = step::outlines_meeting_images(inside_->scene, *state_);
    if (!too_wide.empty()) throw SceneError(std::move(too_wide));
    for (const step::Crossing& crossing : step::crossing_outlines(*state_)) {
        const state::Wall& wall = state_->walls[crossing.wall];
        throw SceneError(
            Problem{outline.place, "outline:move", '"' + outline.name + '"',
                    fmt::format("lets \"{}\" and \"{}\" meet, which lie across each other at ({:.6g}, {:.6g}) m",
                                state_->walls[crossing.outline].name, wall.name, crossing.place.x, crossing.place.y),
                    "free it where it stands clear"});
    }
    step::put_in_doubt(inside_->stepper.search);
    // What moves as it is told keeps no account of its own motion.
    state_->booked.walls += balance(ledger_of(*state_)) - before;
}

void Simulation::set_velocity(const model::Selection& selection, Vec2 velocity) {
    const double before = ledger_of(*state_).kinetic;
    for (const Index k : state::selected(selection, *state_)) {
        if (const auto rigid = state_->rigid_of(k)) {
            state_->rigid_bodies[*rigid].velocity = velocity;
        }
        state_->elements.vx[k] = velocity.x;
        state_->elements.vy[k] = velocity.y;
    }
    state_->booked.loads += ledger_of(*state_).kinetic - before;
}

} // namespace demlua::observe
