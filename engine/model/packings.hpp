// How a body is to be filled with elements, as the user said it.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/region.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

namespace demlua::model {

enum class Rows { horizontal, vertical };
enum class Fit {
    centres, ///< an element is kept when its centre lies in the region or on its boundary
    inside   ///< an element is kept when its whole disk lies in the region
};

/// Hexagonal lattice of equal elements.
struct ClosePacking {
    double radius = 0.0; ///< m
    Rows rows = Rows::horizontal;
    Fit fit = Fit::inside;
    std::optional<Vec2> origin; ///< a lattice point, m
    double removed = 0.0;       ///< share of the elements that are taken away at random
    std::uint64_t seed = 1;     ///< says which
};

/// A pack consolidated from clusters (Tavarez & Plesha 2007, section 4).
struct Consolidation {
    int cluster = 3;              ///< elements in a cluster: 1, 2, 3, 4 or 7, touching each other
    std::uint64_t count = 0;      ///< elements wanted (made up to whole clusters); 0: as many as `radius` gives
    double radius = 0.0;          ///< element radius, m; 0: what `count` gives
    double solid_fraction = 0.82; ///< area of the disks over the area of the region
    int relax = 0;                ///< steps of Lloyd's method after the pack is pressed
    double removed = 0.0;         ///< share of the elements that are taken away at random in the end
    std::uint64_t seed = 1;
};

/// Distance between neighbouring elements wanted at a place, m. Throws SceneError where it is no positive number.
using Spacing = std::function<double(Vec2)>;

/// An irregular pack of elements at even distances (Lloyd 1982). One of `count`, `spacing` and `size` says how fine it
/// is.
struct Relaxation {
    std::uint64_t count = 0;  ///< elements; 0 if not given
    double spacing = 0.0;     ///< between neighbouring elements, m; 0 if not given
    Spacing size;             ///< the same from place to place; empty if not given
    int steps = 50;           ///< of Lloyd's method
    bool on_boundary = false; ///< whether a row of elements stands on the region's boundary
    Region boundary_within;   ///< only on the part of the boundary that lies in here; empty: on all of it
    std::uint64_t seed = 1;
};

/// Disks put down one by one.
struct Disk {
    Vec2 centre;         ///< m
    double radius = 0.0; ///< m
};
struct ListedDisks {
    std::vector<Disk> disks;
    std::vector<std::uint32_t> clusters = {}; ///< each disk's, numbered from zero; empty: each is its own
};

/// Element radii spread evenly between two, of a share of the grains by number.
struct SizeClass {
    double least = 0.0;    ///< m
    double greatest = 0.0; ///< m
    double share = 1.0;    ///< beside those of the other classes, which need not add up to 1
};

/// How grains are put down.
enum class Placing {
    consolidation, ///< grown inside the region, sliding without friction, until they fill it
    insertion,     ///< one by one at random places where they overlap nothing, the largest first
    rain           ///< dropped one by one, each sliding and turning on those below until it lies as low as it can
};

/// Grains of one shape and any sizes, each a disk or a cluster of disks, turned at random.
struct GrainPacking {
    int elements = 1;             ///< of a grain, touching each other: 1, 2, 3, 4 or 7
    std::vector<Disk> disks = {}; ///< or a grain disk by disk, in any unit of length
    std::vector<SizeClass> sizes; ///< mean radius of a grain's elements
    Placing method = Placing::consolidation;
    std::optional<double> porosity = std::nullopt; ///< 1 - area of the grains over area of the region
    std::uint64_t count = 0;                       ///< grains; 0: what `porosity` asks for, or all that find a place
    double removed = 0.0;                          ///< share of the grains that are taken away at random in the end
    std::uint64_t seed = 1;
};

using PackingChoice = std::variant<std::monostate, ClosePacking, Consolidation, Relaxation, ListedDisks, GrainPacking>;

} // namespace demlua::model
