#include "engine/observe/simulation.hpp"

#include "engine/observe/ledger.hpp"
#include "engine/observe/simulation_inside.hpp"
#include "engine/state/assemble.hpp"
#include "engine/step/outline_search.hpp"
#include "engine/step/real_moduli.hpp"
#include "engine/step/wall_start.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <thread>
#include <utility>

namespace demlua::observe {

namespace {

/// What a reader must know of bodies whose bonds do not make them what the scene says, one sentence each.
std::vector<std::string> warnings(const model::Scene& scene, const state::State& state) {
    std::vector<std::string> sentences;
    for (std::size_t row = 0; row < scene.bodies.size(); ++row) {
        const std::optional<model::Network> network = model::network_of(scene.bodies[row]);
        if (network != model::Network::contacts && network != model::Network::delaunay) continue;
        if (scene.bodies[row].in_clusters) continue;
        const std::optional<law::PlaneModuli> plane = step::real_moduli(state, row);
        if (!plane) continue;
        const law::PlaneModuli real = law::solid_moduli(*plane, scene.plane == model::Plane::strain);
        const model::Material& said = scene.materials[scene.bodies[row].material];
        constexpr double unseen = 5e-3; // what the sentence would round away
        if (std::abs(real.youngs_modulus - said.youngs_modulus) < unseen * said.youngs_modulus &&
            std::abs(real.poissons_ratio - said.poissons_ratio) < unseen) {
            continue;
        }
        sentences.push_back(fmt::format("warning: {} behaves as E = {:.3g} Pa and nu = {:.2f}, not {:.3g} Pa and "
                                        "{:.2f}: eqs 15 and 16 are exact for "
                                        "close packing only; stiffness = \"facets\" is exact on any pack",
                                        scene.bodies[row].name, real.youngs_modulus, real.poissons_ratio,
                                        said.youngs_modulus, said.poissons_ratio));
    }
    return sentences;
}

} // namespace

int thread_count(int asked, std::size_t elements) {
    constexpr std::size_t elements_worth_a_thread = 3000;
    if (asked > 0) return asked;
    const auto useful = static_cast<int>(std::max<std::size_t>(elements / elements_worth_a_thread, 1));
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, useful);
}

Simulation::Simulation(const model::Scene& scene, Threads threads, const packing::PackStore* packs) {
    state::Assembly assembly = state::assemble(scene, packs);
    state_ = std::make_unique<state::State>(std::move(assembly.state));
    for (std::string& warning : warnings(scene, *state_)) assembly.notes.push_back(std::move(warning));
    inside_ = std::make_unique<Inside>(scene, threads, *state_, std::move(assembly.notes));
    check_period();
    take_in(scene);
    step::refresh_contacts(*state_, inside_->stepper.search, inside_->stepper.team);
    std::vector<Problem> problems = step::elements_across_walls(scene, *state_);
    if (!problems.empty()) throw SceneError(std::move(problems));
    inside_->note_passing(*state_);
    prepare({});
}

Simulation::~Simulation() = default;

void Simulation::Inside::note_passing(const state::State& state) {
    for (const step::Crossing& crossing : step::passing_outlines(state)) {
        const state::Wall& wall = state.walls[crossing.wall];
        const state::Wall& outline = state.walls[crossing.outline];
        if (!passing_.insert(std::minmax(crossing.wall, crossing.outline)).second) continue;
        notes.push_back(fmt::format(
            "warning: outline \"{}\" lies across {} \"{}\" at ({:.6g}, {:.6g}) m, t = {:.6g} s: "
            "both move as given, so they do not touch",
            outline.name, wall.matter ? "outline" : "wall", wall.name, crossing.place.x, crossing.place.y, state.time));
    }
}

/// An element must not meet another on both sides at once.
void Simulation::check_period() const {
    if (!state_->period.repeats()) return;
    const double largest = *std::max_element(state_->elements.radius.begin(), state_->elements.radius.end());
    const double least = 2.0 * (2.0 * largest + inside_->stepper.search.greatest_skin);
    if (state_->period.length >= least) return;
    const model::Scene& scene = inside_->scene;
    throw SceneError(Problem{scene.place, "simulation.periodic_x", fmt::format("{} m", state_->period.length),
                             fmt::format("must be at least {:.6g} m apart, twice the reach of the search", least),
                             "make the box wider or the elements smaller"});
}

} // namespace demlua::observe
