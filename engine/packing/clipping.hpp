// What of a convex cell lies inside a region, by Green's theorem over its sides and the region's boundary.
#pragma once

#include "engine/model/region.hpp"
#include "engine/packing/convex_cell.hpp"

#include <cstddef>
#include <vector>

namespace demlua::packing {

/// The part of a side inside the region, the longest where there are several; as seen from the element, m. An end on
/// the boundary carries the unit vector out of the region.
struct SidePart {
    std::size_t side = 0;
    Vec2 from;
    Vec2 to;
    Vec2 outward_from;
    Vec2 outward_to;
};

/// Area (m^2) and first moment about the element (m^3) of a cell inside the region, and its sides there.
struct ClippedCell {
    model::Swept swept;
    std::vector<SidePart> sides;
};

/// Clips cells to one region, which must be bounded and outlive the clipper.
class Clipper {
public:
    explicit Clipper(const model::Region& region);

    /// Box around the region, with room to spare.
    [[nodiscard]] const Box& box() const { return box_; }
    /// Length below which two places are the same, m.
    [[nodiscard]] double near() const { return near_; }

    /// Clips `cell` of the element at `centre`.
    void clip(const ConvexCell& cell, Vec2 centre, ClippedCell& clipped);

private:
    [[nodiscard]] bool inside(Vec2 point) const;
    void find_pieces(double reach);
    void clip_side(std::size_t side, Vec2 to, ClippedCell& clipped);
    void follow_boundary(const ConvexCell& cell, ClippedCell& clipped) const;
    [[nodiscard]] Vec2 outward_at(Vec2 point) const;

    const model::Region& region_;
    Box box_;
    double near_;
    Vec2 centre_;          ///< of the element at hand
    model::Pieces pieces_; ///< of the boundary that its cell may reach, as seen from it
    model::Pieces lines_;  ///< the cell's sides
};

} // namespace demlua::packing
