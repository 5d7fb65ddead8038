#include "engine/step/contact_room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace demlua::step {

namespace {

/// The most `count` contacts at least 60 degrees apart add up to along one direction, in units of one stiffness.
double along_one_direction(double count) { return count <= 2.0 ? count : 1.5 + 0.25 * count; }

/// The stiffest contact and the hardest dashpots an element can meet.
struct HardestContact {
    double Kn = 0.0, Kt = 0.0, Cn = 0.0, Ct = 0.0;
    double levers = 1.0; ///< squares of arms over those of the radius: rolling adds its own as if at the rim
};

/// `heaviest`: the greatest mass that moves with an element of each body, kg; empty where partners may be of any mass.
HardestContact hardest_contact(const state::State& state, std::size_t element, bool with_own_body,
                               std::span<const double> heaviest) {
    const std::size_t own = state.elements.body[element];
    const std::size_t material = state.bodies[own].material;
    HardestContact hardest;
    const auto meet = [&](const law::Coulomb::Params& params, double fraction, double mass) {
        hardest.Kn = std::max(hardest.Kn, params.Kn);
        hardest.Kt = std::max(hardest.Kt, params.Kt);
        hardest.Cn = std::max(hardest.Cn, 2.0 * fraction * std::sqrt(params.Kn * mass));
        hardest.Ct = std::max(hardest.Ct, 2.0 * fraction * std::sqrt(params.Kt * mass));
    };
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double m = state.pushed_mass(element);
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        if (b == own && !with_own_body) continue;
        const state::PairRule rule =
            state.contacts.rules[material * state.contacts.materials + state.bodies[b].material];
        const double partner = heaviest.empty() ? (b == own ? m : infinite) : heaviest[b];
        meet(rule.params(), rule.damping_fraction, 1.0 / (1.0 / m + 1.0 / partner));
    }
    const state::MaterialFacts& facts = state.materials[material];
    if (!state.walls.empty()) meet({facts.stiffness.normal, facts.stiffness.shear, 0.0}, facts.damping_fraction, m);
    if (state.contacts.rolls) hardest.levers = 2.0;
    return hardest;
}

} // namespace

double room_around(double R, double smallest) { return std::numbers::pi / std::asin(smallest / (R + smallest)); }

Felt hardest_contacts(const state::State& state, std::size_t k, double count, bool with_own_body) {
    constexpr double sides = 2.0;
    const HardestContact contact = hardest_contact(state, k, with_own_body, {});
    const state::Elements& elements = state.elements;
    const double along = sides * along_one_direction(count) * elements.inverse_mass[k];
    const double turn =
        contact.levers * sides * count * elements.radius[k] * elements.radius[k] * elements.inverse_inertia[k];
    const Eigen::Vector3d normal{along, along, 0.0};
    const Eigen::Vector3d shear{along, along, turn};
    return {contact.Kn * normal + contact.Kt * shear, contact.Cn * normal + contact.Ct * shear};
}

RigidlyFelt hardest_contacts_on(const state::State& state, const state::RigidBody& rigid, std::size_t k, double count,
                                std::span<const double> heaviest) {
    constexpr double sides = 2.0;
    const bool among_themselves = state.bodies[state.elements.body[k]].in_clusters;
    const HardestContact contact = hardest_contact(state, k, among_themselves, heaviest);
    const double arm = norm(state.elements.position(k) - rigid.middle());
    const double lever = arm + state.elements.radius[k];
    const double along = sides * along_one_direction(count) / rigid.mass;
    const double normal = along + sides * count * arm * arm / rigid.inertia;
    const double shear = along + contact.levers * sides * count * lever * lever / rigid.inertia;
    return {contact.Kn * normal + contact.Kt * shear, contact.Cn * normal + contact.Ct * shear};
}

} // namespace demlua::step
