#include "engine/step/time_step.hpp"

#include "engine/law/stable_step.hpp"
#include "engine/step/lanczos.hpp"
#include "engine/step/outline_bound.hpp"
#include "engine/step/pair_bound.hpp"
#include "engine/step/springs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace demlua::step {

namespace {

constexpr double greatest_paper_ratio = 2.0 / 3.0; // of Kt to Kn, beyond which eq. 19 is unstable in a lattice

Springs mass_scaled(const state::State& state, std::size_t body) {
    Springs springs = springs_of_body(state, body);
    springs.scale(inverse_root_masses(state.elements, state.bodies[body].first, state.bodies[body].last));
    return springs;
}

/// The largest dt with lambda_max(dt^2 K + 2 dt C) <= 4, never above it. Found by taking, of the mode that is largest at one
/// dt, the dt at which it would reach 4; each estimate on the way gives a safe step by lambda(s dt) <= s lambda(dt) for
/// s <= 1, and <= s^2 lambda(dt) for s >= 1.
double largest_step(const Springs& springs, const Eigen::VectorXd& stiffness, const Eigen::VectorXd& damping,
                    double dt) {
    constexpr int most_rounds = 5;
    constexpr double near_enough = 1e-3;
    const bool damped = springs.damped() || (damping.size() > 0 && damping.maxCoeff() > 0.0);
    double safe = 0.0;
    for (int round = 0; round < most_rounds; ++round) {
        const LargestPair mode = largest_pair(springs.freedoms(), [&](const Eigen::VectorXd& u) -> Eigen::VectorXd {
            return springs.times(dt * dt, 2.0 * dt, u) + (dt * dt * stiffness + 2.0 * dt * damping).cwiseProduct(u);
        });
        const double excess = mode.estimate() / 4.0;
        if (!damped || excess <= 1.0) {
            safe = std::max(safe, dt / std::sqrt(excess));
        } else {
            safe = std::max(safe, dt / excess);
        }
        if (!damped) break;
        const Eigen::VectorXd& x = mode.vector;
        const double k = x.dot(springs.times(1.0, 0.0, x)) + x.dot(stiffness.cwiseProduct(x));
        const double c = x.dot(springs.times(0.0, 1.0, x)) + x.dot(damping.cwiseProduct(x));
        const double next = law::stable_step(k, c);
        if (std::fabs(next / dt - 1.0) < near_enough) break;
        dt = next;
    }
    return safe;
}

double sharp_of(const state::State& state, const Facts& facts, std::size_t body, const Springs& springs, double bound) {
    Eigen::VectorXd stiffness = Eigen::VectorXd::Zero(springs.freedoms());
    Eigen::VectorXd damping = stiffness;
    const std::size_t first = state.bodies[body].first;
    for (std::size_t k = first; k < state.bodies[body].last; ++k) {
        const Felt contacts = beside_bonds(state, facts, k, false);
        stiffness.segment<3>(springs.row(k)) = contacts.stiffness;
        damping.segment<3>(springs.row(k)) = contacts.damping;
    }
    return largest_step(springs, stiffness, damping, bound);
}

/// Calls `work(body, springs)` for every body whose elements move on their own.
template <class Work>
void for_each_free_body(const state::State& state, const Work& work) {
    for (std::size_t body = 0; body < state.bodies.size(); ++body) {
        if (!state.bodies[body].rigid) work(body, mass_scaled(state, body));
    }
}

struct Found {
    double step = std::numeric_limits<double>::infinity();
    std::string reason = "nothing stiff: no bound";
};

/// The tighter of what the elements and what the outlines allow.
Found with_outlines(const state::State& state, Found elements) {
    const Tightest outlines = bound_of_outlines(state);
    return outlines.step < elements.step ? Found{outlines.step, outlines.why} : std::move(elements);
}

Found bound_found(const state::State& state) {
    const Facts facts = facts_of(state);
    Tightest tightest;
    for_each_free_body(state, [&](std::size_t body, const Springs& springs) {
        const Tightest here = bound_of(state, facts, body, springs);
        tightest.offer(here.step, here.at, here.why);
    });
    const Tightest rigid = bound_of_rigid(state, facts);
    tightest.offer(rigid.step, rigid.at, rigid.why);
    if (!std::isfinite(tightest.step)) return with_outlines(state, {});
    return with_outlines(
        state, {tightest.step, fmt::format("pair-energy bound, tightest at element {} of {} with {}", tightest.at,
                                           state.bodies[state.elements.body[tightest.at]].name, tightest.why)});
}

Found sharp_found(const state::State& state) {
    const Facts facts = facts_of(state);
    Tightest tightest;
    for_each_free_body(state, [&](std::size_t body, const Springs& springs) {
        const Tightest bound = bound_of(state, facts, body, springs);
        const std::string& name = state.bodies[body].name;
        const std::string at =
            fmt::format("pair-energy bound, tightest at element {} of {} with {}", bound.at, name, bound.why);
        if (can_loosen(state, body) || springs.size() == 0) {
            tightest.offer(bound.step, body, at);
            return;
        }
        const double sharp = sharp_of(state, facts, body, springs, bound.step);
        tightest.offer(std::max(bound.step, sharp), body,
                       sharp > bound.step ? fmt::format("highest frequency of {} by Lanczos iteration", name) : at);
    });
    const Tightest rigid = bound_of_rigid(state, facts);
    tightest.offer(rigid.step, 0,
                   fmt::format("pair-energy bound, tightest at element {} of {} with {}", rigid.at,
                               state.bodies[state.elements.body[rigid.at]].name, rigid.why));
    if (!std::isfinite(tightest.step)) return with_outlines(state, {});
    return with_outlines(state, {tightest.step, tightest.why});
}

struct PaperStep {
    double step = std::numeric_limits<double>::infinity();
    std::size_t element = 0;
    double ratio = 0.0; ///< the largest Kt/Kn
};

PaperStep paper_found(const state::State& state) {
    PaperStep found;
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        const law::ContactStiffness& stiffness =
            state.materials[state.bodies[state.elements.body[k]].material].stiffness;
        found.ratio = std::max(found.ratio, stiffness.shear / stiffness.normal);
        const double step = law::paper_step(state.elements.mass(k), stiffness.normal, 0.0);
        if (step >= found.step) continue;
        found.step = step;
        found.element = k;
    }
    return found;
}

StableStep by_paper(const state::State& state, const Place& place) {
    const PaperStep paper = paper_found(state);
    const auto refuse = [&](const std::string& why) {
        throw SceneError(Problem{place, "simulation.time_step", "\"paper\"", why, "use \"sharp\" or \"bound\""});
    };
    if (paper.ratio > greatest_paper_ratio) {
        refuse(fmt::format("eq. 19 is unstable for Kt/Kn above 2/3, here {:.3f}", paper.ratio));
    }
    const double limit = sharp_step_of_bonds(state);
    if (paper.step > limit) {
        refuse(fmt::format("eq. 19 is unstable here: it gives {} where the bonds allow {}", in_seconds(paper.step),
                           in_seconds(limit)));
    }
    return {paper.step,
            fmt::format("eq. 19 of the paper, which is no bound, at element {} of {}; the bonds would allow "
                        "{}",
                        paper.element, state.bodies[state.elements.body[paper.element]].name, in_seconds(limit))};
}

} // namespace

std::string in_seconds(double time) {
    const std::array<std::pair<double, const char*>, 4> units{{{1.0, "s"}, {1e-3, "ms"}, {1e-6, "us"}, {1e-9, "ns"}}};
    for (const auto& [unit, name] : units) {
        if (time >= unit) return fmt::format("{:.4g} {}", time / unit, name);
    }
    return fmt::format("{:.4g} ns", 1e9 * time);
}

double bound_step(const state::State& state) { return bound_found(state).step; }
double sharp_step(const state::State& state) { return sharp_found(state).step; }
double paper_step(const state::State& state) { return paper_found(state).step; }

double sharp_step_of_bonds(const state::State& state) {
    double shortest = std::numeric_limits<double>::infinity();
    for_each_free_body(state, [&](std::size_t /*body*/, const Springs& springs) {
        if (springs.size() == 0) return;
        const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(springs.freedoms());
        const double start = bound_of_bonds(springs);
        shortest = std::min(shortest, std::max(start, largest_step(springs, nothing, nothing, start)));
    });
    return shortest;
}

StableStep stable_step(const state::State& state, model::StepRule rule, const Place& place) {
    if (rule == model::StepRule::paper) return by_paper(state, place);
    const Found found = rule == model::StepRule::bound ? bound_found(state) : sharp_found(state);
    if (!std::isfinite(found.step)) return {found.step, found.reason};
    const PaperStep paper = paper_found(state);
    return {found.step, fmt::format("{}; the paper's eq. 19 would give {}{}", found.reason, in_seconds(paper.step),
                                    paper.ratio > greatest_paper_ratio ? ", unstable for Kt/Kn above 2/3" : "")};
}

} // namespace demlua::step
