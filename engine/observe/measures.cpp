// Fields and history of a simulation by name.
#include "engine/observe/cracks.hpp"
#include "engine/observe/fields.hpp"
#include "engine/observe/simulation.hpp"
#include "engine/state/selection.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <type_traits>

namespace demlua::observe {

namespace {

struct Component {
    const ElementField* field = nullptr;
    std::size_t index = 0;
};

Component component_named(const std::string& name) {
    for (const ElementField& field : element_fields()) {
        const std::vector<std::string> names = component_names(field);
        const auto found = std::find(names.begin(), names.end(), name);
        if (found != names.end()) return {&field, static_cast<std::size_t>(found - names.begin())};
    }
    const std::vector<std::string> known = measurable_fields();
    throw SceneError(
        Problem{Place(), "field", '"' + name + '"', fmt::format("must be one of {}", fmt::join(known, ", ")), ""});
}

bool any_selected(const model::Selection& selection) {
    return selection.body || selection.side || selection.within || selection.where;
}

} // namespace

std::vector<std::string> measurable_fields() {
    std::vector<std::string> names;
    for (const ElementField& field : element_fields()) {
        for (std::string& name : component_names(field)) names.push_back(std::move(name));
    }
    return names;
}

std::vector<double> Simulation::field(const std::string& name, const model::Selection& selection) const {
    const Component component = component_named(name);
    const auto stride = static_cast<std::size_t>(component.field->components);
    Column<Index> rows;
    if (any_selected(selection)) {
        rows = state::selected(selection, *state_);
    } else {
        rows.resize(state_->elements.size());
        std::iota(rows.begin(), rows.end(), Index{0});
    }
    return std::visit(
        [&](const auto& values) {
            std::vector<double> chosen;
            chosen.reserve(rows.size());
            for (const Index k : rows) chosen.push_back(static_cast<double>(values[k * stride + component.index]));
            return chosen;
        },
        component.field->values(*state_));
}

double Simulation::measure(const std::string& name, const model::Selection& selection) const {
    const std::vector<double> values = field(name, selection);
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    const bool summed = component_named(name).field->combine == Combine::sum;
    return summed || values.empty() ? sum : sum / static_cast<double>(values.size());
}

HistoryRow Simulation::history_row() const {
    HistoryRow row{{"time", time()}, {"step", static_cast<double>(step())}};
    const Ledger energy = ledger();
    const bool bonded = !state_->bond_sets.empty();
    const bool breaks = can_break(*state_);
    const bool dashpots = std::any_of(state_->bond_sets.begin(), state_->bond_sets.end(), [](const auto& any) {
        return std::visit([](const auto& bonds) { return bonds.dashpots.present(); }, any);
    });
    const bool worked = !state_->loads.empty() || !state_->drives.empty() || !state_->walls.empty();
    const auto column = [&](bool used, const char* name, double value) {
        if (used) row.emplace_back(name, value);
    };
    column(true, "kinetic_energy", energy.kinetic);
    column(bonded, "bond_energy", energy.bonds);
    column(true, "contact_energy", energy.contacts);
    column(state_->gravity != Vec2{}, "potential_energy", energy.potential);
    column(breaks, "plastic_work", energy.plastic);
    column(breaks, "fracture_work", energy.fracture);
    column(true, "friction_work", energy.friction);
    column(dashpots, "bond_damping_work", energy.bond_damping);
    column(true, "contact_damping_work", energy.contact_damping);
    column(state_->alpha > 0.0, "mass_damping_work", energy.mass_damping);
    column(!state_->gone.empty(), "removed_energy", energy.removed);
    column(worked, "work_of_loads", energy.work);
    column(true, "energy_error", energy.error);
    const Momentum total = momentum();
    column(true, "momentum_x", total.linear.x);
    column(true, "momentum_y", total.linear.y);
    column(true, "angular_momentum", total.angular);
    column(true, "contacts", static_cast<double>(contact_count()));
    column(state_->wear.present(), "worn", static_cast<double>(worn_elements()));
    column(!state_->gone.empty(), "removed", static_cast<double>(removed_elements()));
    column(breaks, "broken_bonds", static_cast<double>(broken_bonds()));
    column(breaks, "crack_length", breaks ? crack_length() : 0.0);
    column(breaks, "surface_energy", breaks ? surface_energy() : 0.0);
    column(breaks, "fragments", breaks ? static_cast<double>(fragments()) : 0.0);
    add_probes(row);
    return row;
}

} // namespace demlua::observe
