// Places for elements, at random and yet evenly, as densely as their size asks.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"
#include "engine/model/region.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace demlua::packing {

/// A pack of more is taken for a slip of the pen.
inline constexpr double most_elements = 1e7;

/// Squares that cover a region, about half an element wide, along a space-filling curve (Morton 1966); `elements` is how
/// many full cells of the size asked for fit into each.
class Field {
public:
    /// `size` (m) gives the distance of neighbours; the region must be bounded. Squares nearer to the boundary than
    /// `margin` times the size hold nothing. Throws RunError where more than ten million elements would fit.
    Field(const model::Region& region, const model::Spacing& size, double margin);

    [[nodiscard]] double elements() const { return elements_; }

    /// `count` places inside the region, none if no square holds anything. Each stretch of the curve gets its share to
    /// within one.
    [[nodiscard]] std::vector<Vec2> sow(std::size_t count, std::uint64_t seed) const;

private:
    struct Square {
        Vec2 middle;
        double side;
        double elements;
    };

    void cover(Vec2 middle, double side, double known_size);
    [[nodiscard]] Vec2 place_in(const Square& square, std::uint64_t seed, std::uint64_t number) const;

    const model::Region& region_;
    const model::Spacing& size_;
    double margin_;
    double largest_side_ = 0.0;
    double smallest_side_ = 0.0;
    std::vector<Square> squares_;
    double elements_ = 0.0;
};

} // namespace demlua::packing
