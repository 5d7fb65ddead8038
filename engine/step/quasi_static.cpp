#include "engine/step/quasi_static.hpp"

#include "engine/step/loads.hpp"
#include "engine/step/springs.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <type_traits>
#include <utility>
#include <variant>

namespace demlua::step {

namespace {

constexpr double overshoot = 0.005;      ///< by which a bond may exceed its strength before it is let fail
constexpr int most_sweeps = 3000;        ///< in search of one rest
constexpr double greatest_opening = 0.1; ///< of an element's radius; beyond, displacements are not small
constexpr double least_share = 1e-4;     ///< of the run's duration, the shortest way from rest to rest
constexpr double same_load = 5e-4;       ///< of the run's duration: so near to each other loads are one

std::vector<std::unique_ptr<FailingBonds>> failing_sets(state::State& state) {
    std::vector<std::unique_ptr<FailingBonds>> sets;
    for (state::AnyBondSet& any : state.bond_sets) {
        std::visit(
            [&](auto& bonds) {
                const std::size_t material = state.bodies[bonds.body].material;
                sets.push_back(std::make_unique<FailingBondsOf<std::decay_t<decltype(bonds)>>>(
                    bonds, state.elements,
                    state.contacts.rules[material * state.contacts.materials + material].params()));
            },
            any);
    }
    return sets;
}

double least_radius(const state::Elements& elements) {
    return *std::min_element(elements.radius.begin(), elements.radius.end());
}

} // namespace

QuasiStatic::QuasiStatic(state::State& state, Stepper& stepper, const model::QuasiStaticRun& said)
    : state_(state), stepper_(stepper), asked_{said.place, "run"}, said_(said), held_(held_freedoms(state)),
      per_radius_(freedoms_per_radius(state.elements)), sets_(failing_sets(state)), at_(state.time),
      ahead_(said.duration / 50.0) {
    refuse_what_is_not_bonds(state_, asked_);
    refuse_floating(state_, held_, asked_);
    Springs springs = springs_of(state_);
    springs.scale(per_radius_);
    system_.emplace(springs.stiffness_matrix(), held_.is);
    if (system_->singular()) {
        refuse(asked_, "the bonds leave a motion that takes no force", "look for a hinge or a chain");
    }
    loads_.emplace(*system_);
    part_.emplace(*system_, per_radius_);
    const Eigen::VectorXd nowhere = Eigen::VectorXd::Zero(per_radius_.size());
    for (const std::unique_ptr<FailingBonds>& set : sets_) {
        set->measure(nowhere);
    }
    std::vector<Candidate> before;
    for (const std::unique_ptr<FailingBonds>& set : sets_) {
        for (const std::size_t bond : set->offset_before()) before.push_back({set.get(), bond});
    }
    add(std::move(before));
}

std::size_t QuasiStatic::broken() const {
    std::size_t count = 0;
    for (const std::unique_ptr<FailingBonds>& set : sets_) count += set->broken_rows();
    return count;
}

/// Rest under the loads of `time` with the bonds that are allowed to fail so far.
QuasiStatic::Trial QuasiStatic::settle(double time) {
    const double now = std::exchange(state_.time, time);
    const Eigen::VectorXd outer = outer_forces(state_, stepper_, per_radius_);
    const Eigen::VectorXd given = places_held(state_.elements, held_freedoms(state_));
    state_.time = now;
    const Eigen::VectorXd right = system_->right_side(outer, given.cwiseQuotient(per_radius_));
    const Eigen::VectorXd loaded = loads_->solution(right).cwiseProduct(per_radius_);
    Trial trial;
    trial.left = part_->relax(loaded, said_.tolerance, most_sweeps);
    displacements_ = loaded + part_->displacements();
    for (const std::unique_ptr<FailingBonds>& set : sets_) {
        set->measure(displacements_);
        for (std::size_t k = 0; k < set->bonds(); ++k) trial.use = std::max(trial.use, set->use(k));
    }
    return trial;
}

/// From left to right and upwards, so that nothing hangs on how elements are numbered.
void QuasiStatic::add(std::vector<Candidate> bonds) {
    std::sort(bonds.begin(), bonds.end(), [](const Candidate& a, const Candidate& b) {
        const Vec2 at = a.set->place(a.bond);
        const Vec2 other = b.set->place(b.bond);
        return at.x != other.x ? at.x < other.x : at.y < other.y;
    });
    for (const Candidate& each : bonds) part_->add(*each.set, each.bond);
}

/// Lets the bonds nearest to failing fail, the nearest of which is at `use`.
void QuasiStatic::let_fail(double use) {
    std::vector<Candidate> failing;
    for (const std::unique_ptr<FailingBonds>& set : sets_) {
        const double least = std::max(1.0, set->together() * use);
        for (std::size_t k = 0; k < set->bonds(); ++k) {
            if (set->use(k) >= least) failing.push_back({set.get(), k});
        }
    }
    add(std::move(failing));
}

/// At the last rest up to `time`, or the first that is known.
std::size_t QuasiStatic::broken_at(double time) const {
    const auto after = std::upper_bound(rests_.begin(), rests_.end(), time,
                                        [](double t, const RestKnown& rest) { return t < rest.time; });
    return after == rests_.begin() ? rests_.front().broken : std::prev(after)->broken;
}

bool QuasiStatic::no_rest(double time, const std::string& what) {
    why_ = fmt::format("no rest beyond t = {:.6g} s: at {:.6g} s {}", at_, time, what);
    restore();
    return false;
}

/// Lets bonds fail at one instant until none should any more.
bool QuasiStatic::follow(double time, Trial trial) {
    const std::size_t broken_before = broken_at(time - same_load * said_.duration);
    const std::size_t failing_before = part_->size();
    const double open = greatest_opening * least_radius(state_.elements);
    while (true) {
        if (broken() - broken_before > said_.runs_after) {
            return no_rest(time, fmt::format("more than {} bonds break one after another", said_.runs_after));
        }
        if (part_->largest_offset() > open) return no_rest(time, "bonds open without end");
        if (trial.left > said_.tolerance) return no_rest(time, "bonds go on yielding");
        if (part_->size() - failing_before > said_.most_failing) {
            return no_rest(time, fmt::format("more than {} bonds yield", said_.most_failing));
        }
        if (trial.use < 1.0) break;
        let_fail(trial.use);
        trial = settle(time);
    }
    use_ = trial.use;
    place(time);
    return true;
}

void QuasiStatic::keep() {
    for (const std::unique_ptr<FailingBonds>& set : sets_) set->keep();
    kept_ = part_->size();
    rests_.push_back({at_, broken()});
}

void QuasiStatic::restore() {
    for (const std::unique_ptr<FailingBonds>& set : sets_) set->restore();
    part_->keep_first(kept_);
}

bool QuasiStatic::advance(double until) {
    const double shortest = least_share * said_.duration;
    keep();
    why_.clear();
    while (true) {
        const double time = std::min(at_ + ahead_, until);
        const double ahead = time - at_;
        const Trial trial = settle(time);
        const bool beyond = trial.use > 1.0 + overshoot || trial.left > said_.tolerance;
        if (!beyond || ahead <= 1.01 * shortest) {
            const double use = use_;
            if (follow(time, trial)) {
                const double rise = (trial.use - use) / ahead;
                const double reach = rise > 0.0 ? (1.0 + 0.5 * overshoot - trial.use) / rise : 2.0 * ahead_;
                ahead_ = std::clamp(reach, std::max(0.5 * ahead_, shortest), std::max(2.0 * ahead_, shortest));
                return true;
            }
            if (ahead <= 1.01 * shortest) return false;
            ahead_ = std::max(0.2 * ahead, shortest);
            continue;
        }
        restore();
        const double to_strength =
            trial.left > said_.tolerance ? 0.3 * ahead : (1.0 + 0.5 * overshoot - use_) / (trial.use - use_) * ahead;
        ahead_ = std::max(std::clamp(to_strength, 0.1 * ahead, 0.7 * ahead), shortest);
    }
}

/// Writes the rest that was found into the state.
void QuasiStatic::place(double time) {
    state::Elements& elements = state_.elements;
    double farthest = 0.0;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(3 * k);
        const Vec2 to{displacements_[row], displacements_[row + 1]};
        farthest = std::max(farthest, norm(to - elements.displacement(k)));
        elements.ux[k] = to.x;
        elements.uy[k] = to.y;
        elements.rotation[k] = displacements_[row + 2];
    }
    travel(stepper_.search, farthest);
    stop_motion(elements);
    at_ = state_.time = time;
    ++state_.step;
    std::vector<NewContact> contacts;
    const double dt = std::exchange(state_.dt, 0.0);
    for (const std::unique_ptr<FailingBonds>& set : sets_) set->settle(state_, contacts);
    append_contacts(state_, stepper_.search, contacts);
    compute_forces(state_, stepper_);
    state_.dt = dt;
    if (!state_.drives.empty()) apply_drives(state_);
}

} // namespace demlua::step
