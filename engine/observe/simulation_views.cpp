// What a simulation answers.
#include "engine/observe/cracks.hpp"
#include "engine/observe/drawn.hpp"
#include "engine/observe/fields.hpp"
#include "engine/observe/hash.hpp"
#include "engine/observe/ledger.hpp"
#include "engine/observe/simulation_inside.hpp"
#include "engine/state/parts.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demlua::observe {

double Simulation::time() const { return state_->time; }
std::uint64_t Simulation::step() const { return state_->step; }
double Simulation::time_step() const { return state_->dt; }

std::string Simulation::time_step_reason() const {
    return fmt::format("{:.3g} of {}, {}", state_->dt / inside_->stable.critical,
                       step::in_seconds(inside_->stable.critical), inside_->stable.reason);
}

int Simulation::threads() const { return static_cast<int>(inside_->team.size()); }
std::size_t Simulation::element_count() const { return state_->elements.size(); }
std::size_t Simulation::bond_count() const { return observe::bond_count(*state_); }

std::size_t Simulation::contact_count() const {
    std::size_t count = 0;
    for (std::size_t c = 0; c < state_->contacts.size(); ++c) count += state_->overlap(c) > 0.0 ? 1 : 0;
    for (const double overlap : state_->wall_contacts.overlap) count += overlap > 0.0 ? 1 : 0;
    for (const state::OutlineContact& row : state_->outline_contacts.rows) count += row.overlap > 0.0 ? 1 : 0;
    return count;
}

std::size_t Simulation::broken_bonds() const { return broken_bond_count(*state_); }
double Simulation::crack_length() const { return crack_length_of(*state_); }
double Simulation::surface_energy() const { return surface_energy_of(*state_); }
std::size_t Simulation::worn_elements() const { return state_->wear.left; }
std::size_t Simulation::removed_elements() const {
    return static_cast<std::size_t>(std::count(state_->gone.begin(), state_->gone.end(), std::uint8_t{1}));
}
std::size_t Simulation::fragments() const { return fragment_count(state::part_of_elements(*state_)); }

Ledger Simulation::ledger() const {
    Ledger now = ledger_of(*state_);
    if (inside_->started) now.error = balance(now) - inside_->balance_at_start;
    return now;
}

Momentum Simulation::momentum() const { return momentum_of(*state_); }
BodyMotion Simulation::body_motion(std::size_t body) const { return motion_of_body(*state_, body); }
Vec2 Simulation::wall_force(std::size_t wall) const { return state_->walls.at(wall).force; }
WallMotion Simulation::wall_motion(std::size_t wall) const { return motion_of_wall(*state_, wall); }

Snapshot Simulation::snapshot() const {
    Snapshot snapshot;
    snapshot.time = state_->time;
    snapshot.step = state_->step;
    snapshot.position.reserve(state_->elements.size());
    for (std::size_t k = 0; k < state_->elements.size(); ++k) snapshot.position.push_back(state_->elements.position(k));
    for (const ElementField& field : element_fields()) {
        if (!field.present(*state_)) continue;
        snapshot.element_fields.push_back({field.name, field.unit, field.components, field.values(*state_)});
    }
    add_bonds_to(snapshot, *state_);
    add_cracks_to(snapshot, *state_);
    add_walls_to(snapshot, *state_);
    if (state_->period.repeats()) bring_inside(snapshot, *state_);
    if (!state_->gone.empty()) leave_out_gone(snapshot, *state_);
    return snapshot;
}

void Simulation::add_probes(HistoryRow& row) const {
    for (const model::Probe& probe : inside_->scene.probes) {
        row.emplace_back(probe.name, measure(probe.measure, probe.selection));
    }
    for (std::size_t k = 0; k < inside_->taken.probed.size(); ++k) {
        add_bond_columns(row, inside_->scene.bond_probes[k].name, *state_, inside_->taken.probed[k]);
    }
}

std::vector<std::string> Simulation::notes() const { return inside_->notes; }
std::string Simulation::schedule() const { return step::schedule_line(*state_); }
std::uint64_t Simulation::hash() const { return hash_of(*state_); }

std::vector<StageTime> Simulation::stage_times() const {
    std::vector<StageTime> times;
    for (std::size_t s = 0; s < step::stage_names.size(); ++s) {
        if (inside_->stepper.clock.seconds[s] > 0.0) {
            times.push_back({step::stage_names[s], inside_->stepper.clock.seconds[s]});
        }
    }
    return times;
}

} // namespace demlua::observe
