#include "engine/observe/simulation.hpp"

#include "engine/observe/bond_probes.hpp"
#include "engine/observe/cracks.hpp"
#include "engine/observe/drawn.hpp"
#include "engine/observe/fields.hpp"
#include "engine/observe/hash.hpp"
#include "engine/observe/ledger.hpp"
#include "engine/observe/rest.hpp"
#include "engine/state/assemble.hpp"
#include "engine/state/bond_assembly.hpp"
#include "engine/state/loading.hpp"
#include "engine/state/parts.hpp"
#include "engine/state/selection.hpp"
#include "engine/state/wall_assembly.hpp"
#include "engine/step/loads.hpp"
#include "engine/step/quasi_static.hpp"
#include "engine/step/real_moduli.hpp"
#include "engine/step/static_solve.hpp"
#include "engine/step/step.hpp"
#include "engine/step/time_step.hpp"
#include "engine/step/wall_start.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <thread>
#include <utility>
#include <variant>

namespace demlua::observe {

namespace {

/// The elements one motion of the scene drives, and its rows of State::drives.
struct Moved {
    Column<Index> elements;
    std::vector<std::size_t> drives;
};

/// How much of the scene has been taken in.
struct Taken {
    std::size_t supports = 0;
    std::size_t notches = 0;
    std::size_t dampings = 0;
    std::vector<Moved> motions;
    std::vector<std::size_t> forces;    ///< their rows of State::loads
    std::vector<std::size_t> tractions; ///< likewise
    std::vector<ProbedBond> probed;     ///< by row of the scene's bond probes
};

law::Rayleigh rayleigh_of(const model::Damping& damping) {
    if (damping.second_fraction && damping.second_frequency) {
        return law::rayleigh(damping.fraction, damping.frequency, *damping.second_fraction, *damping.second_frequency);
    }
    return law::rayleigh(damping.fraction, damping.frequency);
}

/// The longest step up to `longest` that makes the shortest of `intervals` (rising) a whole number of steps; one that would
/// cost more than a twentieth is passed over, unless it is the last.
double fitted_step(double longest, const std::vector<double>& intervals) {
    constexpr double fewest_steps = 20.0;
    double steps = 1.0;
    for (const double interval : intervals) {
        steps = std::ceil(interval / longest * (1.0 - 1e-12));
        if (steps >= fewest_steps) return interval / steps;
    }
    return intervals.empty() ? longest : intervals.back() / steps;
}

/// Energy of where the elements stand, J.
double stored(const Ledger& ledger) { return ledger.bonds + ledger.contacts + ledger.potential; }

/// Energy that is gone for good, J.
double spent(const Ledger& ledger) {
    return ledger.plastic + ledger.fracture + ledger.friction + ledger.bond_damping + ledger.contact_damping +
           ledger.mass_damping + ledger.removed;
}

/// As many threads as there is work for.
int thread_count(int asked, std::size_t elements) {
    constexpr std::size_t elements_worth_a_thread = 3000;
    if (asked > 0) return asked;
    const auto useful = static_cast<int>(std::max<std::size_t>(elements / elements_worth_a_thread, 1));
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, useful);
}

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

struct Simulation::Inside {
    model::Scene scene;
    Team team;
    step::Stepper stepper;
    std::vector<std::string> notes;
    Taken taken;
    double beta = 0.0; ///< of the dashpots laid beside the bonds, s
    step::StableStep stable;
    bool step_outdated = true;
    bool started = false;
    double balance_at_start = 0.0;
    bool stopping = false;
    std::string stop_reason;

    Inside(const model::Scene& said, int threads, const state::State& state, std::vector<std::string> facts)
        : scene(said), team(thread_count(threads, state.elements.size())), stepper(team, state, said.greatest_move),
          notes(std::move(facts)) {
        stepper.domain = said.domain;
    }
};

Simulation::Simulation(const model::Scene& scene, int threads, const packing::PackStore* packs) {
    state::Assembly assembly = state::assemble(scene, packs);
    state_ = std::make_unique<state::State>(std::move(assembly.state));
    for (std::string& warning : warnings(scene, *state_)) assembly.notes.push_back(std::move(warning));
    inside_ = std::make_unique<Inside>(scene, threads, *state_, std::move(assembly.notes));
    check_period();
    take_in(scene);
    step::refresh_contacts(*state_, inside_->stepper.search);
    std::vector<Problem> problems = step::elements_across_walls(scene, *state_);
    if (!problems.empty()) throw SceneError(std::move(problems));
    prepare({});
}

Simulation::~Simulation() = default;

/// An element must not meet another on both sides at once.
void Simulation::check_period() const {
    if (!state_->period.repeats()) return;
    const double largest = *std::max_element(state_->elements.radius.begin(), state_->elements.radius.end());
    const double least = 2.0 * (2.0 * largest + inside_->stepper.search.skin);
    if (state_->period.length >= least) return;
    const model::Scene& scene = inside_->scene;
    throw SceneError(Problem{scene.place, "simulation.periodic_x", fmt::format("{} m", state_->period.length),
                             fmt::format("must be at least {:.6g} m apart, twice the reach of the search", least),
                             "make the box wider or the elements smaller"});
}

// --- changing ---------------------------------------------------------------------------------------------------------

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
    inside_->stepper.search.travelled = std::numeric_limits<double>::infinity();
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
    state::set_motion(outline, state_->walls.at(inside_->scene.walls.size() + row));
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

// --- running ----------------------------------------------------------------------------------------------------------

void Simulation::prepare(const std::vector<double>& intervals) {
    const model::Scene& scene = inside_->scene;
    if (inside_->step_outdated) {
        inside_->stable = step::stable_step(*state_, scene.time_step, scene.place);
        inside_->step_outdated = false;
    }
    double longest = scene.step_fraction * inside_->stable.critical;
    if (!std::isfinite(longest)) longest = step_in_flight(intervals.empty() ? 1.0 : intervals.front());
    const double dt = fitted_step(longest, intervals);
    if (!inside_->started) {
        state_->dt = dt;
    } else if (dt != state_->dt) {
        step::change_step(*state_, dt);
    }
}

/// A step for a scene without springs: a thousandth of the time ahead, and no element past half the move allowed.
double Simulation::step_in_flight(double ahead) const {
    const state::Elements& elements = state_->elements;
    double longest = 1e-3 * ahead;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const double speed = norm(elements.velocity(k)) + norm(state_->gravity) * ahead;
        const double move = 0.5 * inside_->scene.greatest_move * elements.radius[k];
        if (speed * longest > move) longest = move / speed;
    }
    return longest;
}

void Simulation::start_once() {
    if (inside_->started) return;
    step::start(*state_, inside_->stepper);
    inside_->balance_at_start = balance(ledger_of(*state_));
    inside_->started = true;
}

RunReport Simulation::run(double duration, const std::vector<Watcher>& watchers, const std::atomic<bool>* interrupted,
                          bool until_rest) {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<double> intervals{duration};
    for (const Watcher& watcher : watchers) {
        if (watcher.every > 0.0 && watcher.every < duration) intervals.push_back(watcher.every);
    }
    std::sort(intervals.begin(), intervals.end());
    prepare(intervals);
    start_once();
    const auto step = [this, until_rest](double /*until*/) {
        step::advance(*state_, inside_->stepper);
        if (state_->step % energy_checked_every == 0) check_energy();
        if (until_rest && state_->step % rest_checked_every == 0 && at_rest(*state_, rest_share)) stop("at rest");
        return true;
    };
    RunReport report = run_until(state_->time + duration, watchers, interrupted, step);
    report.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return report;
}

RunReport Simulation::run_quasi_static(const model::QuasiStaticRun& said, const std::vector<Watcher>& watchers,
                                       const std::atomic<bool>* interrupted) {
    const auto begin = std::chrono::steady_clock::now();
    prepare({});
    start_once();
    step::QuasiStatic slowly(*state_, inside_->stepper, said);
    const auto rest = [&](double until) {
        const Ledger before = ledger_of(*state_);
        const bool found = slowly.advance(until);
        const Ledger after = ledger_of(*state_);
        state_->booked.loads += stored(after) + spent(after) - stored(before) - spent(before);
        inside_->balance_at_start += balance(ledger_of(*state_)) - balance(before);
        if (!found) stop(slowly.why());
        return found;
    };
    RunReport report = run_until(state_->time + said.duration, watchers, interrupted, rest);
    report.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (!slowly.why().empty()) inside_->notes.push_back(slowly.why());
    return report;
}

RunReport Simulation::solve_static(const model::StaticSolve& said, const std::vector<Watcher>& watchers) {
    const auto begin = std::chrono::steady_clock::now();
    prepare({});
    start_once();
    for (const Watcher& watcher : watchers) watcher.act(*this);
    const Ledger before = ledger_of(*state_);
    const step::StaticAnswer answer = step::solve_static(*state_, inside_->stepper, said);
    state_->booked.loads += stored(ledger_of(*state_)) - stored(before);
    // What moved has been stopped: its energy leaves the account.
    inside_->balance_at_start += balance(ledger_of(*state_)) - balance(before);
    for (const Watcher& watcher : watchers) watcher.act(*this);
    RunReport report;
    report.steps = 1;
    report.solutions = answer.solutions;
    report.residual = answer.residual;
    report.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    inside_->notes.push_back(
        fmt::format("static solution at t = {:.6g} s: {} of a linear system of {} unknowns, {:.2g} "
                    "of the loads left on free elements{}",
                    state_->time, answer.solutions, 3 * state_->elements.size(), answer.residual,
                    said.linear ? ", of first order in displacements" : ""));
    return report;
}

RunReport Simulation::run_until(double end, const std::vector<Watcher>& watchers, const std::atomic<bool>* interrupted,
                                const std::function<bool(double)>& go) {
    const double begin = state_->time;
    const std::uint64_t first_step = state_->step;
    const double tolerance = 1e-6 * state_->dt;
    std::vector<std::uint64_t> looked(watchers.size(), 0); // instants each watcher has had so far
    inside_->stopping = false;
    inside_->stop_reason.clear();
    RunReport report;
    while (true) {
        const bool asked_to_end = interrupted != nullptr && interrupted->load(std::memory_order_relaxed);
        const bool last = asked_to_end || inside_->stopping || state_->time >= end - tolerance;
        for (std::size_t w = 0; w < watchers.size(); ++w) {
            const double due = begin + static_cast<double>(looked[w]) * watchers[w].every;
            if (!last && state_->time < due - tolerance) continue;
            ++looked[w];
            watchers[w].act(*this);
        }
        if (asked_to_end) report.ending = Ending::interrupted;
        if (inside_->stopping) report.ending = Ending::stopped;
        if (last || inside_->stopping) break;
        double next = end;
        for (std::size_t w = 0; w < watchers.size(); ++w) {
            if (watchers[w].every > 0.0) {
                next = std::min(next, begin + static_cast<double>(looked[w]) * watchers[w].every);
            }
        }
        if (!go(next)) {
            for (const Watcher& watcher : watchers) watcher.act(*this);
            report.ending = Ending::stopped;
            break;
        }
    }
    report.reason = inside_->stop_reason;
    report.steps = state_->step - first_step;
    return report;
}

void Simulation::check_energy() const {
    const Ledger now = ledger();
    const double scale =
        std::fabs(inside_->balance_at_start) + std::fabs(now.work) + std::fabs(now.potential) + spent(now);
    if (now.error <= scale) return;
    const state::Elements& elements = state_->elements;
    std::size_t fastest = 0;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        if (norm(elements.velocity(k)) > norm(elements.velocity(fastest))) fastest = k;
    }
    throw RunError(fmt::format("energy ran away: {:.4g} J more than was put in, at t = {:.6g} s (step {}); the fastest "
                               "is element {} of body \"{}\" at {:.4g} m/s; take a smaller step_fraction",
                               now.error, state_->time, state_->step, fastest,
                               state_->bodies[elements.body[fastest]].name, norm(elements.velocity(fastest))));
}

void Simulation::stop(std::string reason) {
    inside_->stopping = true;
    inside_->stop_reason = std::move(reason);
}

// --- looking ----------------------------------------------------------------------------------------------------------

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
    const auto touching = [](const Column<double>& overlap) {
        return static_cast<std::size_t>(
            std::count_if(overlap.begin(), overlap.end(), [](double depth) { return depth > 0.0; }));
    };
    return touching(state_->contacts.overlap) + touching(state_->wall_contacts.overlap);
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
