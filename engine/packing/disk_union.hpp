// What disks that overlap cover together.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"

#include <span>

namespace demlua::packing {

/// A thin plate: its area (m^2), its centroid (m) and its polar second moment of area about the centroid (m^4).
struct Lamina {
    double area = 0.0;
    Vec2 centroid;
    double polar = 0.0;
};

/// The union of disks of positive radius, which may overlap, touch, hide each other or lie apart; no disks give nothing.
/// Exact but for rounding, by Green's theorem over the arcs that bound it. The work grows with the square of the number
/// of disks.
Lamina union_of(std::span<const model::Disk> disks);

} // namespace demlua::packing
