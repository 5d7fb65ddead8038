// What can be seen of a simulation at a settled instant, as plain copies that outlive it.
#pragma once

#include "engine/base/column.hpp"
#include "engine/base/vec2.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace demlua::observe {

/// A named quantity, `components` numbers to a row (1, 2 for plane vectors, 3 for a stress as xx, yy, xy).
struct Field {
    std::string name;
    std::string unit; ///< SI, empty for pure numbers
    int components = 1;
    std::variant<std::vector<double>, std::vector<std::int32_t>> values;
};

/// Elements as points with fields, bonds as lines between them with fields of their own, the pieces of crack where bonds
/// have broken, and walls. A field that the scene has no use for is not there. Elements stand in the order of their ids.
struct Snapshot {
    double time = 0.0; ///< s
    std::uint64_t step = 0;
    std::vector<Vec2> position; ///< of elements, m
    std::vector<Field> element_fields;
    std::vector<std::array<Index, 2>> bond_ends; ///< rows of `position`
    std::vector<Field> bond_fields;
    std::vector<std::array<Vec2, 2>> crack_ends; ///< where they broke, in the order of breaking, m
    std::vector<Field> crack_fields;             ///< none when no bond can break
    std::vector<std::string> wall_names;         ///< walls, then outlines
    std::vector<std::vector<Vec2>> wall_paths;   ///< a closed one ends where it began, m
    std::vector<Field> wall_fields;              ///< none without walls
};

/// Where the energy is and where it went, joules. Stored energies are what is there now; the others have been summed
/// since the start. `error` is what the start, the work done and the rest leave unexplained.
struct Ledger {
    double kinetic = 0.0;
    double bonds = 0.0;           ///< stored in bonds
    double contacts = 0.0;        ///< stored in contacts, walls included
    double potential = 0.0;       ///< in gravity, zero at the start
    double plastic = 0.0;         ///< spent by yielding bonds
    double fracture = 0.0;        ///< stored in bonds when they broke
    double friction = 0.0;        ///< spent by sliding contacts
    double bond_damping = 0.0;    ///< spent by the bonds' dashpots
    double contact_damping = 0.0; ///< spent by the contacts' dashpots
    double mass_damping = 0.0;    ///< spent by mass-proportional damping
    double removed = 0.0;         ///< energy of elements taken out
    double work = 0.0;            ///< done on the elements by loads, prescribed motions, supports and walls
    double error = 0.0;           ///< sum of all but work, less work, less the same at the start
};

struct Momentum {
    Vec2 linear;          ///< kg m/s
    double angular = 0.0; ///< about the origin of the plane, kg m^2/s
};

/// Motion of a body as a whole.
struct BodyMotion {
    double mass = 0.0; ///< kg
    Vec2 centre;       ///< of mass, m
    Vec2 velocity;     ///< of the centre of mass, m/s
    double spin = 0.0; ///< angular momentum about the centre over moment of inertia, rad/s
    Box extent;        ///< of its disks, m
};

/// Motion of a wall or an outline, and what elements do to it.
struct WallMotion {
    Vec2 position;       ///< of the point it turns about, of an outline the centre of mass, m
    Vec2 velocity;       ///< m/s
    double angle = 0.0;  ///< turned since the start, rad
    double spin = 0.0;   ///< rad/s
    Vec2 force;          ///< of the elements on it, N
    double moment = 0.0; ///< likewise, about `position`, N m
    Vec2
        stress; ///< with which it presses on what it meets: over its height along x and its width along y, Pa; 0 without
    double mass = 0.0;    ///< of an outline, kg
    double inertia = 0.0; ///< of an outline, about its centre of mass, kg m^2
};

/// One line of the history: names and values in the order of the columns.
using HistoryRow = std::vector<std::pair<std::string, double>>;

} // namespace demlua::observe
