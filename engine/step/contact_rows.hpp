// Forces in contacts between elements, row by row: the same arithmetic for one row or for as many as a register holds.
//
//   d = x_j - x_i,  n = d/|d|,  t = n turned left,  overlap = reference - |d|
//   a_i = |d| R_i/(R_i + R_j),  a_j = |d| - a_i                              lever arms
//   closing = -(v_j - v_i).n,  sliding = (v_j - v_i).t - a_i w_i - a_j w_j
//
// and law/coulomb.hpp, law/rolling.hpp. Arms that add up to the distance exchange linear and angular momentum exactly.
#pragma once

#include "engine/base/lanes.hpp"
#include "engine/base/period.hpp"
#include "engine/base/vec2.hpp"
#include "engine/law/coulomb.hpp"
#include "engine/law/rolling.hpp"
#include "engine/step/bond_rows.hpp"

#include <array>
#include <cstddef>

namespace demlua::step {

/// Where the columns of elements begin that a contact asks for.
struct PlaceRows {
    const double *reference_x, *reference_y;
    ElementRows moving;
};

/// Where the columns begin of what pairs of materials have.
struct RuleRows {
    const double *Kn, *Kt, *mu, *rolling_friction;
};

/// Where the columns of contacts begin.
struct ContactRows {
    const Index *i, *j;
    const Index* rule; ///< null where there is one rule
    const double *reference, *share_i, *Cn, *Ct;
    double *overlap, *fx, *fy, *moment_i, *moment_j;
    std::array<double*, law::Coulomb::History<double>::members.size()> history;
    RuleRows rules;

    // only where contacts resist rolling
    const double *turning_stiffness, *turning_dashpot, *turning_radius;
    std::array<double*, law::Rolling::History<double>::members.size()> turning_history;
};

/// Fills overlap .. moment_j of the contacts [begin, end), a whole multiple of the kernel's width.
using ContactKernel = void (*)(const ContactRows& contacts, const PlaceRows& elements, Period period, double dt,
                               std::size_t begin, std::size_t end);

template <class Lane, class Struct>
DEMLUA_INLINE void store_members(const std::array<double*, Struct::members.size()>& columns, std::size_t k,
                                 const Struct& whole) {
    for (std::size_t m = 0; m < columns.size(); ++m) Lane::store(columns[m] + k, whole.*Struct::members[m]);
}

/// Of each row, what its pair of materials has in `column`.
template <class Lane>
DEMLUA_INLINE typename Lane::Number of_rule(const ContactRows& contacts, std::size_t k, const double* column) {
    if (contacts.rule == nullptr) return *column;
    return typename Lane::Picked(contacts.rule + k).of(column);
}

/// Adds the couples against rolling to the moments of rows.
template <class Lane, class T>
DEMLUA_INLINE void resist_rolling(const ContactRows& contacts, std::size_t k, T pressure, T rolling, double dt) {
    using History = law::Rolling::History<T>;
    auto history = loaded_members<Lane, History>(contacts.turning_history, k);
    const T cap = of_rule<Lane>(contacts, k, contacts.rules.rolling_friction) *
                  Lane::load(contacts.turning_radius + k) * pressure;
    const T couple = law::Rolling::respond<T>(
        {Lane::load(contacts.turning_stiffness + k), Lane::load(contacts.turning_dashpot + k), cap, rolling}, dt,
        history);
    store_members<Lane>(contacts.turning_history, k, history);
    Lane::store(contacts.moment_i + k, Lane::load(contacts.moment_i + k) + couple);
    Lane::store(contacts.moment_j + k, Lane::load(contacts.moment_j + k) - couple);
}

template <class Lane, bool rolls, bool repeats>
void contact_forces(const ContactRows& contacts, const PlaceRows& elements, Period period, double dt, std::size_t begin,
                    std::size_t end) {
    using T = typename Lane::Number;
    using History = law::Coulomb::History<T>;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const typename Lane::Picked i(contacts.i + k);
        const typename Lane::Picked j(contacts.j + k);
        const auto between = [&](const double* column) { return j.of(column) - i.of(column); };
        const auto place = [](const auto& picked, const double* at, const double* moved) {
            return picked.of(at) + picked.of(moved);
        };
        const ElementRows& moving = elements.moving;
        Vector2<T> span{place(j, elements.reference_x, moving.ux) - place(i, elements.reference_x, moving.ux),
                        place(j, elements.reference_y, moving.uy) - place(i, elements.reference_y, moving.uy)};
        if constexpr (repeats) span = period.shortest(span);
        const T d = norm(span);
        const T overlap = Lane::load(contacts.reference + k) - d;
        Lane::store(contacts.overlap + k, overlap);
        auto history = loaded_members<Lane, History>(contacts.history, k);
        const T spin_i = i.of(moving.spin);
        const T spin_j = j.of(moving.spin);
        const bool idle =
            !any(either(overlap > 0.0, either(magnitude(history.force) > 0.0, magnitude(history.damping) > 0.0)));
        if (idle) {
            for (double* column : {contacts.fx, contacts.fy, contacts.moment_i, contacts.moment_j}) {
                Lane::store(column + k, T{});
            }
            if constexpr (rolls) resist_rolling<Lane, T>(contacts, k, T{}, spin_j - spin_i, dt);
            continue;
        }
        const Vector2<T> normal = span / d;
        const Vector2<T> tangent = turned_left(normal);
        const Vector2<T> v{between(moving.vx), between(moving.vy)};
        const T a_i = d * Lane::load(contacts.share_i + k);
        const T a_j = d - a_i;
        const law::Coulomb::Constants<T> constants{of_rule<Lane>(contacts, k, contacts.rules.Kn),
                                                   of_rule<Lane>(contacts, k, contacts.rules.Kt),
                                                   of_rule<Lane>(contacts, k, contacts.rules.mu)};
        const law::Coulomb::Input<T> in{overlap, -dot(v, normal), dot(v, tangent) - a_i * spin_i - a_j * spin_j,
                                        Lane::load(contacts.Cn + k), Lane::load(contacts.Ct + k)};
        const law::Coulomb::Force<T> force = law::Coulomb::respond<T>(constants, in, dt, history);
        store_members<Lane>(contacts.history, k, history);
        const Vector2<T> f = force.shear * tangent - force.pressure * normal;
        Lane::store(contacts.fx + k, f.x);
        Lane::store(contacts.fy + k, f.y);
        Lane::store(contacts.moment_i + k, force.shear * a_i);
        Lane::store(contacts.moment_j + k, force.shear * a_j);
        if constexpr (rolls) resist_rolling<Lane, T>(contacts, k, force.pressure, spin_j - spin_i, dt);
    }
}

} // namespace demlua::step
