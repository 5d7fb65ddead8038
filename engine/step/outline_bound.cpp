#include "engine/step/outline_bound.hpp"

#include "engine/law/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demlua::step {

namespace {

/// Side by side along the sides, and round every corner two more.
double most_contacts(const state::Wall& outline, double smallest_radius, std::size_t elements) {
    double length = 0.0;
    for (std::size_t k = 0; k < outline.segments(); ++k) {
        length += norm(outline.point_after(k) - outline.points[k]);
    }
    const double fit = length / (1.8 * smallest_radius) + 2.0 * static_cast<double>(outline.points.size());
    return std::min(fit, 2.0 * static_cast<double>(elements));
}

} // namespace

Tightest bound_of_outlines(const state::State& state) {
    constexpr double sides = 2.0;
    Tightest tightest;
    const state::Elements& elements = state.elements;
    const double smallest = *std::min_element(elements.radius.begin(), elements.radius.end());
    const double heaviest = 1.0 / *std::min_element(elements.inverse_mass.begin(), elements.inverse_mass.end());
    for (std::size_t w = 0; w < state.walls.size(); ++w) {
        const state::Wall& outline = state.walls[w];
        if (!outline.matter) continue;
        double K = 0.0;
        double C = 0.0;
        const double mass = 1.0 / (1.0 / heaviest + 1.0 / outline.matter->mass);
        for (const state::Body& body : state.bodies) {
            const state::PairRule& rule = outline.rules[body.material];
            const double k = std::max(rule.Kn, rule.Kt);
            K = std::max(K, k);
            C = std::max(C, 2.0 * rule.damping_fraction * std::sqrt(k * mass));
        }
        const double felt = sides * most_contacts(outline, smallest, elements.size()) *
                            (1.0 / outline.matter->mass + outline.reach * outline.reach / outline.matter->inertia);
        tightest.offer(law::stable_step(felt * K, felt * C), w,
                       fmt::format("outline {} with contacts all round", outline.name));
    }
    return tightest;
}

} // namespace demlua::step
