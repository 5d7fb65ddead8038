// Plane figures bounded by straight sides: corners, and integrals over the area.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/region.hpp"
#include "engine/model/scene.hpp"

#include <string>
#include <vector>

namespace demlua::model {

struct Figure {
    double area = 0.0;  ///< m^2
    Vec2 centre;        ///< of area, m
    double polar = 0.0; ///< integral of the squared distance from the centre, m^4
};

/// Of a polygon whose corners go round once, in either sense, m.
Figure figure_of(const std::vector<Vec2>& corners);

/// A path without its last point where that is the first, to rounding.
std::vector<Vec2> without_return(std::vector<Vec2> path);

/// What is wrong with an outline's path or region, as a rule it breaks; empty when nothing is.
std::string outline_fault(const Outline& outline);

/// The corners of an outline that has no fault, m.
std::vector<Vec2> corners_of(const Outline& outline);

/// The points of a line with teeth as high as `height` (m) to the left of the way from `from` to `to`, which differ. The
/// number of teeth is whole, their width the nearest to `pitch` (m).
std::vector<Vec2> sawtooth(Vec2 from, Vec2 to, double height, double pitch);

} // namespace demlua::model
