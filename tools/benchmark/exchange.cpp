#include "tools/benchmark/exchange.hpp"

#include "engine/law/elastic.hpp"
#include "engine/observe/ledger.hpp"
#include "engine/step/step.hpp"
#include "tools/benchmark/batch.hpp"
#include "tools/benchmark/measure.hpp"

#include <fstream>
#include <type_traits>
#include <variant>
#include <vector>

namespace demlua::bench {

namespace {

using Json = nlohmann::ordered_json;

constexpr int batches = 5;
constexpr int steps_per_batch = 400;

/// Velocities are kept half a step before the instant.
std::vector<double> at_the_instant(const Column<double>& velocity, const Column<double>& force,
                                   const Column<double>& inverse_mass, double dt) {
    std::vector<double> now(velocity.size());
    for (std::size_t k = 0; k < now.size(); ++k) now[k] = velocity[k] + 0.5 * dt * force[k] * inverse_mass[k];
    return now;
}

Json elements_json(const state::State& state) {
    const state::Elements& elements = state.elements;
    Json json;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        json["x"].push_back(elements.position(k).x);
        json["y"].push_back(elements.position(k).y);
        json["mass"].push_back(elements.mass(k));
    }
    json["radius"] = elements.radius;
    json["vx"] = at_the_instant(elements.vx, elements.fx, elements.inverse_mass, state.dt);
    json["vy"] = at_the_instant(elements.vy, elements.fy, elements.inverse_mass, state.dt);
    return json;
}

Json bonds_json(const state::State& state) {
    Json json = Json::object();
    for (const state::AnyBondSet& any : state.bond_sets) {
        const auto* bonds = std::get_if<state::BondSet<law::Elastic>>(&any);
        if (bonds == nullptr) continue;
        json["i"] = bonds->i;
        json["j"] = bonds->j;
        json["length"] = bonds->length.spread(bonds->size());
        json["Kn"] = bonds->params.Kn;
        json["Kt"] = bonds->params.Kt;
    }
    return json;
}

Json contact_json(const state::State& state) {
    const state::PairRule rule = state.contacts.rules[0];
    return {{"Kn", rule.Kn},
            {"Kt", rule.Kt},
            {"friction", rule.mu},
            {"damping_fraction", rule.damping_fraction},
            {"wall_Kn", state.materials.front().stiffness.normal},
            {"wall_Kt", state.materials.front().stiffness.shear}};
}

Json instant_json(const Work& work, const state::State& state) {
    Json json{{"dt", state.dt},
              {"gravity", -state.gravity.y},
              {"steps_before", work.steps_before},
              {"batches", batches},
              {"steps_per_batch", steps_per_batch},
              {"elements", elements_json(state)},
              {"bonds", bonds_json(state)},
              {"contact", contact_json(state)}};
    for (const state::Wall& wall : state.walls) {
        for (const Vec2 point : wall.path) json["wall"].push_back({point.x, point.y});
    }
    return json;
}

double mean_height(const state::Elements& elements) {
    double sum = 0.0;
    for (std::size_t k = 0; k < elements.size(); ++k) sum += elements.position(k).y;
    return sum / static_cast<double>(elements.size());
}

} // namespace

Json follow(const Work& work, int threads, const packing::PackStore* packs, const std::string& file) {
    const Begun begun = begin_of(work, packs);
    state::State& state = *begun.state;
    if (file != "-") std::ofstream(file) << instant_json(work, state).dump();
    Team team(threads);
    step::Stepper stepper(team, state, work.scene.greatest_move);
    step::refresh_contacts(state, stepper.search, stepper.team);
    for (std::uint64_t step = 0; step < work.steps_before; ++step) step::advance(state, stepper);
    Json seconds = Json::array();
    for (int batch = 0; batch < batches; ++batch) {
        const double taken = time_of([&] {
            for (int step = 0; step < steps_per_batch; ++step) step::advance(state, stepper);
        });
        seconds.push_back(taken / steps_per_batch);
    }
    const observe::Ledger ledger = observe::ledger_of(state);
    return {{"elements", state.elements.size()},
            {"seconds_per_step", seconds},
            {"stored", ledger.bonds},
            {"kinetic", ledger.kinetic},
            {"height", mean_height(state.elements)}};
}

} // namespace demlua::bench
