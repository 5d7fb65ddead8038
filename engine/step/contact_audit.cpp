#include "engine/step/contact_audit.hpp"

#include "engine/base/problems.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <utility>

namespace demlua::step {

namespace {

constexpr double almost = 1.0 - 1e-9; // of the greatest shear force that friction bears

/// What a pair does now, and the forces between its elements.
struct Pair {
    Vec2 normal;
    double distance = 0.0;
    double closing = 0.0; ///< m/s
    double along = 0.0;   ///< speed of j against i along the tangent, m/s
    double sliding = 0.0; ///< m/s
    double rolling = 0.0; ///< rad/s
    double pressure = 0.0, shear = 0.0, couple = 0.0;
    double dashpot = 0.0, shear_dashpot = 0.0; ///< their part in these
};

Pair pair_of(const state::State& state, std::size_t c) {
    const state::Contacts& contacts = state.contacts;
    const state::Elements& elements = state.elements;
    const std::size_t i = contacts.i[c];
    const std::size_t j = contacts.j[c];
    const Vec2 span = state.between(i, j);
    Pair pair;
    pair.distance = norm(span);
    pair.normal = span / pair.distance;
    const Vec2 tangent = turned_left(pair.normal);
    const Vec2 v = elements.velocity(j) - elements.velocity(i);
    const double a_i = pair.distance * contacts.share_i[c];
    pair.closing = -dot(v, pair.normal);
    pair.along = dot(v, tangent);
    pair.sliding = pair.along - a_i * elements.spin[i] - (pair.distance - a_i) * elements.spin[j];
    pair.rolling = elements.spin[j] - elements.spin[i];
    const Vec2 f = contacts.forces.at(c).f;
    pair.pressure = -dot(f, pair.normal);
    pair.shear = dot(f, tangent);
    const state::ContactHistory history = contacts.history.at(c);
    pair.dashpot = history.damping;
    pair.shear_dashpot = pair.shear - contacts.rules[contacts.rule[c]].Kt * history.shear;
    if (contacts.rolls) pair.couple = contacts.forces.at(c).moment_i - pair.shear * a_i;
    return pair;
}

void book_step(ContactAudit::Account& account, const Pair& pair, const law::Coulomb::Params& p, double dt) {
    const double across = 0.5 * (account.pressure + pair.pressure) * pair.closing * dt;
    const double aside = 0.5 * (account.shear + pair.shear) * pair.sliding * dt;
    const double turning = 0.5 * (account.couple + pair.couple) * pair.rolling * dt;
    account.given -= across + aside + turning;
    account.exchanged += std::fabs(across) + std::fabs(aside) + std::fabs(turning);
    const double slid = pair.along * dt;
    account.allowed += 0.5 * (account.pressure + pair.pressure) * slid * slid / (2.0 * pair.distance);
    const double step = pair.closing * dt;
    if (account.pressure > 0.0 && pair.pressure <= 0.0) {
        account.allowed += p.Kn * step * step / 8.0 + 0.5 * std::fabs(account.dashpot * step);
    }
    const double slide = pair.sliding * dt;
    const bool slips = std::fabs(pair.shear) >= almost * p.mu * pair.pressure;
    if (slips && account.shear * slide < 0.0) {
        account.allowed += p.Kt * slide * slide / 8.0 + 0.5 * std::fabs(account.shear_dashpot * slide);
    }
    account.dashpot = pair.dashpot;
    account.shear_dashpot = pair.shear_dashpot;
    account.pressure = pair.pressure;
    account.shear = pair.shear;
    account.couple = pair.couple;
}

/// A contact that a bond has left stores more than the step has brought: that it may give.
ContactAudit::Account opened(const state::State& state, std::size_t c, const Pair& pair) {
    const state::Contacts& contacts = state.contacts;
    const law::Coulomb::Params params = contacts.rules[contacts.rule[c]].params();
    ContactAudit::Account account;
    book_step(account, pair, params, state.dt);
    const double stored = law::Coulomb::stored_energy(params, state.overlap(c), contacts.history.at(c));
    account.allowed += std::max(0.0, stored + account.given);
    return account;
}

/// What rounding may bring: of the work, and of the places between which an overlap is the difference, J.
double rounding_of(const state::State& state, std::size_t c, const ContactAudit::Account& account) {
    const double apart = 1e-15 * (norm(state.elements.position(state.contacts.i[c])) + state.contacts.reference[c]);
    return 1e-9 * account.exchanged + state.contacts.rules[state.contacts.rule[c]].Kn * apart * apart;
}

} // namespace

void ContactAudit::book(const state::State& state) {
    const state::Contacts& contacts = state.contacts;
    std::unordered_map<std::uint64_t, Account> now;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const Pair pair = pair_of(state, c);
        const std::uint64_t key = std::uint64_t{contacts.i[c]} * state.elements.size() + contacts.j[c];
        const auto found = accounts_.find(key);
        const bool idle = pair.pressure == 0.0 && pair.shear == 0.0 && pair.couple == 0.0;
        if (found == accounts_.end()) {
            if (!idle) now.emplace(key, opened(state, c, pair));
            continue;
        }
        Account account = found->second;
        book_step(account, pair, contacts.rules[contacts.rule[c]].params(), state.dt);
        if (account.given > account.allowed + rounding_of(state, c, account)) {
            throw RunError(
                fmt::format("the contact of elements {} and {} has given {:.4g} J more than it took, of {:.4g} J "
                            "exchanged, by step {} (t = {:.6g} s)",
                            contacts.i[c], contacts.j[c], account.given - account.allowed, account.exchanged,
                            state.step, state.time));
        }
        if (!idle) now.emplace(key, account);
    }
    accounts_ = std::move(now);
}

} // namespace demlua::step
