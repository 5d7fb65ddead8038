#include "engine/step/outline_bound.hpp"

#include "engine/law/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <vector>

namespace demlua::step {

namespace {

/// Stiffness of the hardest contact, and the greatest dashpots.
struct Hardest {
    double Kn = 0.0, Kt = 0.0; ///< N/m
    double Cn = 0.0, Ct = 0.0; ///< N s/m

    void meet(const state::PairRule& rule, double mass) {
        Kn = std::max(Kn, rule.Kn);
        Kt = std::max(Kt, rule.Kt);
        Cn = std::max(Cn, 2.0 * rule.damping_fraction * std::sqrt(rule.Kn * mass));
        Ct = std::max(Ct, 2.0 * rule.damping_fraction * std::sqrt(rule.Kt * mass));
    }
    [[nodiscard]] double K() const { return std::max(Kn, Kt); }
    [[nodiscard]] double C() const { return std::max(Cn, Ct); }
};

/// By how much a displacement of an outline's free motions, scaled by M^1/2, moves its place at `arm` from the centre along
/// `direction`.
Eigen::Vector3d felt(const state::Wall& outline, Vec2 arm, Vec2 direction) {
    const double along = 1.0 / std::sqrt(outline.matter->mass);
    const double round = 1.0 / std::sqrt(outline.matter->inertia);
    return {outline.free_x() ? along * direction.x : 0.0, outline.free_y() ? along * direction.y : 0.0,
            outline.free_to_turn() ? round * cross(arm, direction) : 0.0};
}

/// What a contact with springs (or dashpots) `normal` and `shear` at that place adds to a block.
Eigen::Matrix3d of_contact(const state::Wall& outline, Vec2 arm, Vec2 n, double normal, double shear) {
    const Eigen::Vector3d across = felt(outline, arm, n);
    const Eigen::Vector3d along = felt(outline, arm, turned_left(n));
    return normal * across * across.transpose() + shear * along * along.transpose();
}

/// The largest eigenvalue of contacts side by side along all sides, and two more of any direction at every corner.
double all_round(const state::Wall& outline, double spacing, double normal, double shear) {
    constexpr double at_corner = 2.0;
    const double hardest = std::max(normal, shear);
    Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < outline.segments(); ++k) {
        const Vec2 a = outline.points[k] - outline.centre_now();
        const Vec2 b = outline.point_after(k) - outline.centre_now();
        const double length = norm(b - a);
        const Vec2 n = turned_left(b - a) / length;
        // Of second order along the side: Simpson's rule is exact.
        const Eigen::Matrix3d mean =
            (of_contact(outline, a, n, normal, shear) + 4.0 * of_contact(outline, 0.5 * (a + b), n, normal, shear) +
             of_contact(outline, b, n, normal, shear)) /
            6.0;
        block += (length / spacing) * mean + at_corner * of_contact(outline, a, n, hardest, hardest);
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(block, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

/// The largest eigenvalue that one contact of stiffness 1 may have.
double farthest(const state::Wall& outline) {
    return (outline.free_x() || outline.free_y() ? 1.0 / outline.matter->mass : 0.0) +
           (outline.free_to_turn() ? outline.reach * outline.reach / outline.matter->inertia : 0.0);
}

/// Whether a straight line meets no more than two corners of the outline at once, however it lies: a convex one, of which
/// any three corners span a triangle higher than a contact may be deep.
bool meets_with_two(const state::Wall& outline) {
    constexpr std::size_t most_corners = 16; // beyond, hardly any has such triangles
    const std::vector<Vec2>& path = outline.path;
    const std::vector<state::Corner>& corners = outline.matter->corners;
    if (path.size() > most_corners) return false;
    double rounding = 0.0;
    for (const state::Corner& corner : corners) {
        if (!corner.meets) return false;
        rounding = std::max(rounding, corner.radius);
    }
    for (std::size_t i = 0; i < path.size(); ++i) {
        for (std::size_t j = i + 1; j < path.size(); ++j) {
            for (std::size_t k = j + 1; k < path.size(); ++k) {
                const double longest =
                    std::max({norm(path[j] - path[i]), norm(path[k] - path[j]), norm(path[i] - path[k])});
                if (std::fabs(cross(path[j] - path[i], path[k] - path[i])) < 2.0 * rounding * longest) return false;
            }
        }
    }
    return true;
}

/// The hardest contacts of an outline's corners and of those that meet it.
struct Company {
    double most = 0.0; ///< contacts at once
    Hardest contact;
};

/// Two of each of its own corners, and of each of as many others as find room round it two where all are convex, else four.
Company company_of(const state::State& state, std::size_t o, bool convex) {
    constexpr double own = 2.0;
    constexpr double room_beside_corners = 6.0;
    const double others_own = convex ? 2.0 : 4.0;
    const state::Wall& outline = state.walls[o];
    const auto corners = static_cast<double>(outline.matter->corners.size());
    Company company;
    double others = 0.0;
    for (std::size_t w = 0; w < state.walls.size(); ++w) {
        if (w == o) continue;
        const std::optional<state::Matter>& matter = state.walls[w].matter;
        others += matter ? 1.0 : 0.0;
        company.contact.meet(state::outline_rule(state, w, o),
                             1.0 / (1.0 / outline.matter->mass + (matter ? 1.0 / matter->mass : 0.0)));
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
    const double spacing = 1.8 * *std::min_element(elements.radius.begin(), elements.radius.end());
    const double heaviest = 1.0 / *std::min_element(elements.inverse_mass.begin(), elements.inverse_mass.end());
    const bool convex = std::all_of(state.walls.begin(), state.walls.end(),
                                    [](const state::Wall& wall) { return !wall.matter || meets_with_two(wall); });
    for (std::size_t w = 0; w < state.walls.size(); ++w) {
        const state::Wall& outline = state.walls[w];
        if (!outline.matter || !outline.moves_freely()) continue;
        Hardest contact;
        for (const state::Body& body : state.bodies) {
            contact.meet(outline.rules[body.material], 1.0 / (1.0 / heaviest + 1.0 / outline.matter->mass));
        }
        const double one = farthest(outline);
        const double all_elements = 2.0 * static_cast<double>(elements.size()) * one;
        const double K = std::min(all_elements * contact.K(), all_round(outline, spacing, contact.Kn, contact.Kt));
        const double C = std::min(all_elements * contact.C(), all_round(outline, spacing, contact.Cn, contact.Ct));
        const Company company = company_of(state, w, convex);
        tightest.offer(law::stable_step(sides * (K + company.most * one * company.contact.K()),
                                        sides * (C + company.most * one * company.contact.C())),
                       w, fmt::format("outline {} with contacts all round", outline.name));
    }
    return tightest;
}

} // namespace demlua::step
