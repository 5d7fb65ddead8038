#include "engine/step/time_step.hpp"

#include "engine/law/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <type_traits>
#include <vector>

namespace demlua::step {

namespace {

using Block = Eigen::Matrix3d;

/// Stiffness and damping that an element feels when all others stand still, scaled by its masses.
struct Held {
    Block stiffness = Block::Zero();
    Block damping = Block::Zero();
    int pairs = 0;
};

/// Scaled row of an element's displacements to the stretch (shear == false) or the shear of a pair.
Eigen::Vector3d row(const state::Elements& elements, std::size_t k, Vec2 direction, double arm) {
    const double m = std::sqrt(elements.inverse_mass[k]);
    return {direction.x * m, direction.y * m, -arm * std::sqrt(elements.inverse_inertia[k])};
}

template <class Law>
void add_bonds(const state::BondSet<Law>& bonds, const state::Elements& elements, std::vector<Held>& held) {
    const auto add = [&](std::size_t bond, std::size_t k, double arm) {
        const Vec2 n = Vec2{bonds.Dx[bond], bonds.Dy[bond]} / bonds.length[bond];
        const Eigen::Vector3d stretch = row(elements, k, n, 0.0);
        const Eigen::Vector3d shear = row(elements, k, turned_left(n), arm);
        const Block nn = stretch * stretch.transpose();
        const Block ss = shear * shear.transpose();
        held[k].stiffness += bonds.params.Kn * nn + bonds.params.Kt * ss;
        if (bonds.dashpots.present()) {
            held[k].damping += bonds.dashpots.Cn[bond] * nn + bonds.dashpots.Ct[bond] * ss;
        }
        ++held[k].pairs;
    };
    for (std::size_t bond = 0; bond < bonds.size(); ++bond) {
        if (bonds.is_broken(bond)) continue;
        const double arm = bonds.length[bond] * bonds.share_i[bond];
        add(bond, bonds.i[bond], arm);
        add(bond, bonds.j[bond], -(bonds.length[bond] - arm));
    }
}

/// Rows of an element's displacements to stretch, shear and turn of a bond. `toward` is +1 for j, -1 for i.
Eigen::Matrix3d rows(const state::Elements& elements, std::size_t k, Vec2 n, double arm, double toward) {
    Eigen::Matrix3d B;
    B.row(0) = toward * row(elements, k, n, 0.0);
    B.row(1) = toward * row(elements, k, turned_left(n), toward * arm);
    B.row(2) = Eigen::Vector3d{0.0, 0.0, toward * std::sqrt(elements.inverse_inertia[k])};
    return B;
}

Eigen::Vector3d as_vector(const law::FacetVector<double>& v) { return {v.normal, v.shear, v.turn}; }

Eigen::Matrix3d as_matrix(const law::FacetSprings<double>& K) {
    Eigen::Matrix3d matrix;
    matrix << K.nn, K.nt, K.nw, K.nt, K.tt, K.tw, K.nw, K.tw, K.ww;
    return matrix;
}

/// A cell's energy is bounded by that of as many cells as it touches elements, each moved by one element alone.
template <class Law>
void add_bonds(const state::FacetSet<Law>& bonds, const state::Elements& elements, std::vector<Held>& held) {
    const std::size_t first = bonds.incidence.first;
    std::vector<Eigen::Vector3d> own(bonds.pressure.size(), Eigen::Vector3d::Zero());
    const auto sides = [&](std::size_t e) { return static_cast<double>(bonds.incidence.start[e + 1] - bonds.incidence.start[e]); };
    const auto press = [&](std::size_t e, std::size_t k, const Eigen::Vector3d& g) {
        held[k].stiffness += 0.5 * (sides(e) + 1.0) * bonds.pressure_per_growth[e] * g * g.transpose();
    };
    for (std::size_t bond = 0; bond < bonds.size(); ++bond) {
        if (bonds.is_broken(bond)) continue;
        const std::size_t i = bonds.i[bond];
        const std::size_t j = bonds.j[bond];
        const Vec2 n = Vec2{bonds.Dx[bond], bonds.Dy[bond]} / bonds.length[bond];
        const double arm = bonds.length[bond] * bonds.share_i[bond];
        const Eigen::Matrix3d Bi = rows(elements, i, n, arm, -1.0);
        const Eigen::Matrix3d Bj = rows(elements, j, n, bonds.length[bond] - arm, 1.0);
        const Eigen::Matrix3d K = as_matrix(bonds.springs[bond]);
        held[i].stiffness += Bi.transpose() * K * Bi;
        held[j].stiffness += Bj.transpose() * K * Bj;
        press(i - first, j, Bj.transpose() * as_vector(bonds.growth_i[bond]));
        press(j - first, i, Bi.transpose() * as_vector(bonds.growth_j[bond]));
        own[i - first] += Bi.transpose() * as_vector(bonds.growth_i[bond]);
        own[j - first] += Bj.transpose() * as_vector(bonds.growth_j[bond]);
        ++held[i].pairs;
        ++held[j].pairs;
    }
    for (std::size_t e = 0; e < own.size(); ++e) press(e, first + e, own[e]);
}

double largest_eigenvalue(const Block& block) {
    return Eigen::SelfAdjointEigenSolver<Block>(block, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

/// The most `count` contacts at least 60 degrees apart add up to along one direction, in units of one stiffness.
double along_one_direction(double count) { return count <= 2.0 ? count : 1.5 + 0.25 * count; }

/// How many of the smallest disks fit around one of radius `R`.
double room_around(double R, double smallest) { return std::numbers::pi / std::asin(smallest / (R + smallest)); }

/// The stiffest contact and the hardest dashpots an element can meet.
struct HardestContact {
    double Kn = 0.0, Kt = 0.0, Cn = 0.0, Ct = 0.0;
};

HardestContact hardest_contact(const state::State& state, std::size_t element, bool with_own_body) {
    const std::size_t own = state.elements.body[element];
    const std::size_t material = state.bodies[own].material;
    HardestContact hardest;
    const auto meet = [&](const law::Coulomb::Params& params, double fraction, double mass) {
        hardest.Kn = std::max(hardest.Kn, params.Kn);
        hardest.Kt = std::max(hardest.Kt, params.Kt);
        hardest.Cn = std::max(hardest.Cn, 2.0 * fraction * std::sqrt(params.Kn * mass));
        hardest.Ct = std::max(hardest.Ct, 2.0 * fraction * std::sqrt(params.Kt * mass));
    };
    const double m = state.elements.mass(element);
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        if (b == own && !with_own_body) continue;
        const state::PairRule& rule =
            state.contacts.rules[material * state.contacts.materials + state.bodies[b].material];
        meet(rule.params, rule.damping_fraction, b == own ? 0.5 * m : m);
    }
    const state::MaterialFacts& facts = state.materials[material];
    if (!state.walls.empty()) meet({facts.stiffness.normal, facts.stiffness.shear, 0.0}, facts.damping_fraction, m);
    return hardest;
}

/// Adds `count` contacts to what an element feels, whichever way they lie.
void add_contacts(const state::Elements& elements, std::size_t k, double count, const HardestContact& contact,
                  Held& held) {
    const double along = along_one_direction(count);
    const double m = elements.inverse_mass[k];
    const double turn = count * elements.radius[k] * elements.radius[k] * elements.inverse_inertia[k];
    const Eigen::Vector3d normal{along * m, along * m, 0.0};
    const Eigen::Vector3d shear{along * m, along * m, turn};
    held.stiffness.diagonal() += contact.Kn * normal + contact.Kt * shear;
    held.damping.diagonal() += contact.Cn * normal + contact.Ct * shear;
}

double step_of(const Held& held) {
    return law::stable_step(2.0 * largest_eigenvalue(held.stiffness), 2.0 * largest_eigenvalue(held.damping));
}

struct Tightest {
    double step = std::numeric_limits<double>::infinity();
    std::size_t element = 0;
    std::string why;

    void offer(double candidate, std::size_t k, const char* reason) {
        if (candidate >= step) return;
        step = candidate;
        element = k;
        why = reason;
    }
};

std::vector<bool> bodies_that_break(const state::State& state) {
    std::vector<bool> breaks(state.bodies.size(), true);
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit([&](const auto& bonds) { breaks[bonds.body] = std::decay_t<decltype(bonds)>::law::breaks; }, any);
    }
    return breaks;
}

} // namespace

StableStep safe_step(const state::State& state) {
    const state::Elements& elements = state.elements;
    std::vector<Held> held(elements.size());
    for (const state::AnyBondSet& any : state.bond_sets) {
        std::visit([&](const auto& bonds) { add_bonds(bonds, elements, held); }, any);
    }
    const std::vector<bool> breaks = bodies_that_break(state);
    const double smallest = *std::min_element(elements.radius.begin(), elements.radius.end());
    const bool has_company = state.bodies.size() > 1 || !state.walls.empty();
    Tightest tightest;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const std::size_t body = elements.body[k];
        if (state.bodies[body].rigid) continue;
        const double room = room_around(elements.radius[k], smallest);
        const double free_room = std::max(room - held[k].pairs, 0.0);
        const HardestContact contact = hardest_contact(state, k, breaks[body]);
        Held now = held[k];
        if (has_company) add_contacts(elements, k, free_room, contact, now);
        tightest.offer(step_of(now), k, has_company && free_room > 0.0 ? "its bonds and contacts" : "its bonds");
        if (breaks[body] && state.bodies[body].size() > 1) {
            Held loose;
            add_contacts(elements, k, room, contact, loose);
            tightest.offer(step_of(loose), k, "contacts all round once its bonds are gone");
        }
    }
    if (!std::isfinite(tightest.step)) return {tightest.step, "nothing stiff: no bound"};
    return {tightest.step, fmt::format("pair-energy bound, tightest at element {} of {} with {}", tightest.element,
                                       state.bodies[elements.body[tightest.element]].name, tightest.why)};
}

StableStep paper_step(const state::State& state, const Place& place) {
    Tightest tightest;
    for (std::size_t k = 0; k < state.elements.size(); ++k) {
        const law::ContactStiffness& stiffness =
            state.materials[state.bodies[state.elements.body[k]].material].stiffness;
        if (stiffness.shear > 2.0 / 3.0 * stiffness.normal) {
            throw SceneError(Problem{
                place, "simulation.time_step", "\"paper\"",
                fmt::format("eq. 19 is unstable for Kt/Kn above 2/3, here {:.3f}", stiffness.shear / stiffness.normal),
                "use \"bound\""});
        }
        tightest.offer(law::paper_step(state.elements.mass(k), stiffness.normal, 0.0), k, "");
    }
    return {tightest.step, fmt::format("eq. 19 of the paper, which is no bound, at element {} of {}", tightest.element,
                                       state.bodies[state.elements.body[tightest.element]].name)};
}

} // namespace demlua::step
