// Runs: by steps of motion, from rest to rest, or straight to rest.
#include "engine/observe/ledger.hpp"
#include "engine/observe/rest.hpp"
#include "engine/observe/simulation_inside.hpp"
#include "engine/step/quasi_static.hpp"
#include "engine/step/static_solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace demlua::observe {

namespace {

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

} // namespace

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

void Simulation::Inside::shorten_step(state::State& state) {
    step_outdated = true;
    if (!started) return;
    stable = step::stable_step(state, scene.time_step, scene.place);
    const double longest = scene.step_fraction * stable.critical;
    if (longest < state.dt) step::change_step(state, longest);
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
        if (state_->step % energy_checked_every == 0) {
            check_energy();
            inside_->note_passing(*state_);
        }
        if (until_rest && state_->step % rest_checked_every == 0 && at_rest(*state_, rest_share)) stop("at rest");
        return true;
    };
    RunReport report = run_until(state_->time + duration, watchers, interrupted, step);
    inside_->note_passing(*state_);
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
        const double worked = stored(after) + spent(after) - stored(before) - spent(before);
        state_->booked.loads += worked;
        inside_->balance_at_start += balance(after) - worked - balance(before);
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
    const state::Elements& elements = state_->elements;
    double unseen = 0.0; // energy of elements that move by rounding alone
    for (std::size_t k = 0; k < elements.size(); ++k) {
        constexpr double rounding = 1e-12; // of a radius, in a step
        const double speed = rounding * elements.radius[k] / state_->dt;
        unseen += 0.5 * elements.mass(k) * speed * speed;
    }
    if (now.error <= scale + unseen) return;
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

} // namespace demlua::observe
