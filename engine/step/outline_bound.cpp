#include "engine/step/outline_bound.hpp"

#include "engine/law/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

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

/// The hardest contacts of an outline's corners and of those that meet it.
struct Company {
    double most = 0.0; ///< contacts at once
    double K = 0.0;    ///< N/m
    double C = 0.0;    ///< N s/m
};

/// Two of each of its own corners, and four of each of as many others as find room round it.
Company company_of(const state::State& state, std::size_t o) {
    constexpr double own = 2.0;
    constexpr double others_own = 4.0;
    constexpr double room_beside_corners = 6.0;
    const state::Wall& outline = state.walls[o];
    const auto corners = static_cast<double>(outline.matter->corners.size());
    Company company;
    double others = 0.0;
    for (std::size_t w = 0; w < state.walls.size(); ++w) {
        if (w == o) continue;
        const std::optional<state::Matter>& matter = state.walls[w].matter;
        others += matter ? 1.0 : 0.0;
        const state::PairRule rule = state::outline_rule(state, w, o);
        const double k = std::max(rule.Kn, rule.Kt);
        const double mass = 1.0 / (1.0 / outline.matter->mass + (matter ? 1.0 / matter->mass : 0.0));
        company.K = std::max(company.K, k);
        company.C = std::max(company.C, 2.0 * rule.damping_fraction * std::sqrt(k * mass));
    }
    if (state.walls.size() > 1) {
        company.most = own * corners + others_own * std::min(others, corners + room_beside_corners);
    }
    return company;
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
        const double moves = 1.0 / outline.matter->mass + outline.reach * outline.reach / outline.matter->inertia;
        const double fit = most_contacts(outline, smallest, elements.size());
        const Company company = company_of(state, w);
        tightest.offer(law::stable_step(sides * moves * (fit * K + company.most * company.K),
                                        sides * moves * (fit * C + company.most * company.C)),
                       w, fmt::format("outline {} with contacts all round", outline.name));
    }
    return tightest;
}

} // namespace demlua::step
