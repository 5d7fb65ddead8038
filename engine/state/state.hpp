// Everything that changes while a scene runs, and the few numbers beside it that never do.
#pragma once

#include "engine/state/bonds.hpp"
#include "engine/state/contacts.hpp"
#include "engine/state/cracks.hpp"
#include "engine/state/elements.hpp"
#include "engine/state/outline_contacts.hpp"
#include "engine/state/walls.hpp"
#include "engine/state/wear.hpp"

#include "engine/base/period.hpp"
#include "engine/base/signal.hpp"
#include "engine/law/stiffness.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace demlua::state {

/// What a material means for the elements made of it.
struct MaterialFacts {
    law::ContactStiffness stiffness; ///< N/m
    double friction = 0.0;
    double rolling_friction = 0.0;
    double damping_fraction = 0.0; ///< of critical, of contact dashpots
};

struct Body {
    std::string name;
    std::size_t material = 0;
    std::size_t first = 0;    ///< rows of its elements
    std::size_t last = 0;     ///< one past them
    bool rigid = false;       ///< its elements move with rigid bodies, but for those in State::single
    bool in_clusters = false; ///< what holds elements together does so in each cluster alone

    [[nodiscard]] std::size_t size() const { return last - first; }
};

/// Elements that move as one: a whole body, or a cluster. Their own rows follow from it.
struct RigidBody {
    std::size_t first = 0; ///< rows of State::rigid_members
    std::size_t last = 0;
    double mass = 0.0;    ///< kg
    double inertia = 0.0; ///< about the centre of mass, kg m^2
    Vec2 centre;          ///< at the start, m
    Vec2 displacement;    ///< m
    double rotation = 0.0;
    Vec2 velocity; ///< of the half step before the present instant, m/s
    double spin = 0.0;
    Vec2 force; ///< N
    double moment = 0.0;

    [[nodiscard]] Vec2 middle() const { return centre + displacement; }
    [[nodiscard]] bool empty() const { return first == last; }
};

/// Forces on elements that do not come from other elements. Sums over the elements are `x` and `y`; an element's part
/// is its `share`.
struct Load {
    Column<Index> element;
    Column<double> share; ///< 1/n of a force, or the length of side (times thickness) of a traction, m^2
    Signal x, y;          ///< N, or Pa
};

/// A degree of freedom of some elements, or of a rigid body, whose velocity is given.
enum class Freedom { x, y, rotation };
struct Drive {
    Column<Index> element;          ///< free elements driven
    Column<double> reaction;        ///< force it took at the present instant, N or N m
    std::vector<std::size_t> rigid; ///< rigid bodies driven
    std::vector<double> rigid_reaction;
    Freedom freedom = Freedom::x;
    Signal value;                 ///< m/s or rad/s; or m (rad) when it gives displacement
    bool is_displacement = false; ///< counted from its value when the motion begins
    Column<double> begin;         ///< then the displacement of each element at that instant, m; else empty
};

/// Two elements that were in one rigid cluster, and the distance from which they touch now that they are not.
struct FormerMates {
    Index i = 0; ///< below j
    Index j = 0;
    double reference = 0.0; ///< m
};

/// Work booked at the two halves of each kick, J.
struct Booked {
    double loads = 0.0;
    double drives = 0.0;
    double walls = 0.0;
    double mass_damping = 0.0;
    double removed = 0.0; ///< energy of elements taken out
};

struct State {
    double time = 0.0; ///< s
    std::uint64_t step = 0;
    double dt = 0.0; ///< s

    Elements elements;
    std::vector<Body> bodies;
    std::vector<MaterialFacts> materials;
    std::vector<AnyBondSet> bond_sets;
    std::vector<Crack> cracks; ///< in the order of breaking, of one step in the order of the bond sets and their rows
    Contacts contacts;
    std::vector<Wall> walls;
    WallContacts wall_contacts;
    OutlineContacts outline_contacts;
    std::vector<RigidBody> rigid_bodies;
    Column<Index> rigid_members; ///< elements of the rigid bodies, one body after the other
    Column<Index> rigid_row;     ///< of each element its rigid body, or `no_rigid`; empty without rigid bodies
    Column<Index> single;        ///< elements of bodies called rigid that move on their own
    std::vector<Load> loads;     ///< forces first, then tractions, in the scene's order
    std::vector<Drive> drives;

    Wear wear;                               ///< of clusters; columns empty where no material wears
    std::vector<FormerMates> former_mates;   ///< in rising order
    Column<std::uint8_t> gone;               ///< 1 for elements taken out; empty where nothing can leave
    std::optional<std::size_t> holding_gone; ///< first of three drives that hold these still

    double thickness = 1.0;       ///< m
    bool mixed_precision = false; ///< whether bonds keep in single precision what steps read
    Period period;
    Vec2 gravity;       ///< m/s^2
    double alpha = 0.0; ///< mass-proportional damping, 1/s
    Booked booked;

    static constexpr Index no_rigid = static_cast<Index>(-1);
    /// Row of the rigid body that element `k` moves with, if any.
    [[nodiscard]] std::optional<std::size_t> rigid_of(std::size_t k) const {
        if (rigid_row.empty() || rigid_row[k] == no_rigid) return std::nullopt;
        return rigid_row[k];
    }
    /// By how much the pair of contact `c` overlaps now, m; below zero while it does not touch.
    [[nodiscard]] double overlap(std::size_t c) const {
        return contacts.reference[c] - distance(contacts.i[c], contacts.j[c]);
    }
    /// From the centre of element i to that of the nearest image of element j, m.
    [[nodiscard]] Vec2 between(std::size_t i, std::size_t j) const {
        const Vec2 apart = elements.position(j) - elements.position(i);
        return period.repeats() ? period.shortest(apart) : apart;
    }
    [[nodiscard]] double distance(std::size_t i, std::size_t j) const { return norm(between(i, j)); }
    [[nodiscard]] bool is_gone(std::size_t k) const { return !gone.empty() && gone[k] != 0; }
    /// Mass that moves with element `k` when it is pushed, kg.
    [[nodiscard]] double pushed_mass(std::size_t k) const {
        const std::optional<std::size_t> rigid = rigid_of(k);
        return rigid ? rigid_bodies[*rigid].mass : elements.mass(k);
    }
    /// The elements of a rigid body.
    [[nodiscard]] std::span<const Index> members(const RigidBody& rigid) const {
        return {rigid_members.data() + rigid.first, rigid.last - rigid.first};
    }
};

/// Law of the contacts of an element with a wall.
inline const PairRule& wall_rule(const State& state, std::size_t wall, std::size_t element) {
    return state.walls[wall].rules[state.bodies[state.elements.body[element]].material];
}

/// Law of the contacts of an outline's corners with a wall or with another outline.
inline PairRule outline_rule(const State& state, std::size_t wall, std::size_t outline) {
    const Matter& matter = state.walls[outline].matter.value();
    PairRule rule = state.walls[wall].rules[matter.material];
    rule.mu = std::min(rule.mu, matter.friction);
    return rule;
}

} // namespace demlua::state
