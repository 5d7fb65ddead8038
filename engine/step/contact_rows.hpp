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
#include "engine/state/lane_sums.hpp"
#include "engine/step/bond_rows.hpp"

#include <array>
#include <cstddef>

namespace demlua::step {

/// Where the columns of elements begin that a contact asks for.
struct PlaceRows {
    const double *reference_x, *reference_y;
    ElementRows moving;
};

/// What contacts ask of an element, in one line of memory: scattered elements then cost one line each.
namespace record {
enum Entry : std::size_t { x, y, vx, vy, spin };
inline constexpr std::size_t width = 8;
} // namespace record

/// Fills the records of elements [begin, end).
using RecordKernel = void (*)(const PlaceRows& elements, double* records, std::size_t begin, std::size_t end);

template <class Lane>
void fill_records(const PlaceRows& elements, double* records, std::size_t begin, std::size_t end) {
    const ElementRows& moving = elements.moving;
    for (std::size_t e = begin; e < end; e += Lane::width) {
        typename Lane::Record filled{};
        filled[record::x] = Lane::load(elements.reference_x + e) + Lane::load(moving.ux + e);
        filled[record::y] = Lane::load(elements.reference_y + e) + Lane::load(moving.uy + e);
        filled[record::vx] = Lane::load(moving.vx + e);
        filled[record::vy] = Lane::load(moving.vy + e);
        filled[record::spin] = Lane::load(moving.spin + e);
        Lane::put_records(records + record::width * e, filled);
    }
}

/// Where the columns begin of what pairs of materials have.
struct RuleRows {
    const double *Kn, *Kt, *mu, *rolling_friction, *shear_damping;
};

/// Where the columns of contacts begin.
struct ContactRows {
    const Index *i, *j;
    const Index* rule; ///< null where there is one rule
    const double *reference, *share_i, *Cn;
    state::ForceTargets forces;
    std::array<double*, law::Coulomb::History<double>::members.size()> history;
    double *friction, *damped; ///< of state::LaneSums
    double* slid;              ///< null where no element wears
    RuleRows rules;

    // only where contacts resist rolling
    const double *turning_stiffness, *turning_dashpot, *turning_radius;
    std::array<double*, law::Rolling::History<double>::members.size()> turning_history;
    std::array<double*, law::Spent<double>::members.size()> turning_spent;
};

/// Fills the forces of the contacts [begin, end), a whole multiple of the kernel's width, from the elements' records.
using ContactKernel = void (*)(const ContactRows& contacts, const double* records, Period period, double dt,
                               std::size_t begin, std::size_t end);

template <class Lane, class Struct>
DEMLUA_INLINE void store_members(const std::array<double*, Struct::members.size()>& columns, std::size_t k,
                                 const Struct& whole) {
    for (std::size_t m = 0; m < columns.size(); ++m) Lane::store(columns[m] + k, whole.*Struct::members[m]);
}

template <class Lane, class T>
DEMLUA_INLINE void add_to(double* place, T value) {
    Lane::store(place, Lane::load(place) + value);
}

/// Of each row, what its pair of materials has in `column`.
template <class Lane>
DEMLUA_INLINE typename Lane::Number of_rule(const ContactRows& contacts, std::size_t k, const double* column) {
    if (contacts.rule == nullptr) return *column;
    return typename Lane::Picked(contacts.rule + k).of(column);
}

/// The couples against rolling, on i.
template <class Lane, class T>
DEMLUA_INLINE T resist_rolling(const ContactRows& contacts, std::size_t k, T pressure, T rolling, double dt) {
    auto history = loaded_members<Lane, law::Rolling::History<T>>(contacts.turning_history, k);
    auto spent = loaded_members<Lane, law::Spent<T>>(contacts.turning_spent, k);
    const T cap = of_rule<Lane>(contacts, k, contacts.rules.rolling_friction) *
                  Lane::load(contacts.turning_radius + k) * pressure;
    const T couple = law::Rolling::respond<T>(
        {Lane::load(contacts.turning_stiffness + k), Lane::load(contacts.turning_dashpot + k), cap, rolling}, dt,
        history, spent);
    store_members<Lane>(contacts.turning_history, k, history);
    store_members<Lane>(contacts.turning_spent, k, spent);
    return couple;
}

/// How some contacts move; in the nearest memory between the two loops of a kernel.
struct ContactBlock {
    static constexpr std::size_t rows = 64;
    alignas(64) double overlap[rows], distance[rows], normal_x[rows], normal_y[rows], arm_i[rows], closing[rows],
        sliding[rows], rolling[rows];
};

template <class Lane, bool rolls, bool repeats>
void measure_contacts(const ContactRows& contacts, const double* records, Period period, std::size_t begin,
                      std::size_t end, ContactBlock& block) {
    using T = typename Lane::Number;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const auto i = Lane::pick_records(records, contacts.i + k);
        const auto j = Lane::pick_records(records, contacts.j + k);
        Vector2<T> span{j[record::x] - i[record::x], j[record::y] - i[record::y]};
        if constexpr (repeats) span = period.shortest(span);
        const T d = norm(span);
        const Vector2<T> n = (1.0 / d) * span;
        const Vector2<T> v{j[record::vx] - i[record::vx], j[record::vy] - i[record::vy]};
        const T a_i = d * Lane::load(contacts.share_i + k);
        const T a_j = d - a_i;
        const std::size_t at = k - begin;
        Lane::store(block.overlap + at, Lane::load(contacts.reference + k) - d);
        Lane::store(block.distance + at, d);
        Lane::store(block.normal_x + at, n.x);
        Lane::store(block.normal_y + at, n.y);
        Lane::store(block.arm_i + at, a_i);
        Lane::store(block.closing + at, -dot(v, n));
        Lane::store(block.sliding + at, dot(v, turned_left(n)) - a_i * i[record::spin] - a_j * j[record::spin]);
        if constexpr (rolls) Lane::store(block.rolling + at, j[record::spin] - i[record::spin]);
    }
}

template <class Lane, bool rolls>
void press_contacts(const ContactRows& contacts, double dt, std::size_t begin, std::size_t end,
                    const ContactBlock& block) {
    using T = typename Lane::Number;
    using law::Coulomb;
    for (std::size_t k = begin; k < end; k += Lane::width) {
        const std::size_t at = k - begin;
        const T overlap = Lane::load(block.overlap + at);
        auto history = loaded_members<Lane, Coulomb::History<T>>(contacts.history, k);
        T pressure{};
        Vector2<T> f{};
        T moment_i{};
        T moment_j{};
        if (any(either(overlap > 0.0, either(magnitude(history.force) > 0.0, magnitude(history.damping) > 0.0)))) {
            const Coulomb::Constants<T> constants{of_rule<Lane>(contacts, k, contacts.rules.Kn),
                                                  of_rule<Lane>(contacts, k, contacts.rules.Kt),
                                                  of_rule<Lane>(contacts, k, contacts.rules.mu)};
            const T Cn = Lane::load(contacts.Cn + k);
            const Coulomb::Input<T> in{overlap, Lane::load(block.closing + at), Lane::load(block.sliding + at), Cn,
                                       Cn * of_rule<Lane>(contacts, k, contacts.rules.shear_damping)};
            law::Spent<T> spent;
            const Coulomb::Force<T> force = Coulomb::respond<T>(constants, in, dt, history, spent);
            store_members<Lane>(contacts.history, k, history);
            add_to<Lane, T>(contacts.friction + state::LaneSums::place(k), spent.friction);
            add_to<Lane, T>(contacts.damped + state::LaneSums::place(k), spent.damped);
            if (contacts.slid != nullptr) add_to<Lane, T>(contacts.slid + k, spent.friction);
            const Vector2<T> n{Lane::load(block.normal_x + at), Lane::load(block.normal_y + at)};
            f = force.shear * turned_left(n) - force.pressure * n;
            const T a_i = Lane::load(block.arm_i + at);
            moment_i = force.shear * a_i;
            moment_j = force.shear * (Lane::load(block.distance + at) - a_i);
            pressure = force.pressure;
        }
        if constexpr (rolls) {
            const T couple = resist_rolling<Lane, T>(contacts, k, pressure, Lane::load(block.rolling + at), dt);
            moment_i += couple;
            moment_j -= couple;
        }
        contacts.forces.template store<Lane>(k, f, moment_i, moment_j);
    }
}

/// A kernel, in two short loops: a processor overlaps more rows where fewer operations wait for each other.
template <class Lane, bool rolls, bool repeats>
void contact_forces(const ContactRows& contacts, const double* records, Period period, double dt, std::size_t begin,
                    std::size_t end) {
    ContactBlock block;
    while (begin < end) {
        const std::size_t stop = begin + ContactBlock::rows < end ? begin + ContactBlock::rows : end;
        measure_contacts<Lane, rolls, repeats>(contacts, records, period, begin, stop, block);
        press_contacts<Lane, rolls>(contacts, dt, begin, stop, block);
        begin = stop;
    }
}

} // namespace demlua::step
