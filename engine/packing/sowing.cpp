#include "engine/packing/sowing.hpp"

#include "engine/base/problems.hpp"
#include "engine/base/random.hpp"
#include "engine/packing/growth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demlua::packing {

namespace {

constexpr double coarseness = 0.5; ///< widest square, in distances of neighbours

/// Area of a hexagonal cell over the square of the distance of neighbours.
constexpr double hexagon = 0.5 * std::numbers::sqrt3;

} // namespace

Field::Field(const model::Region& region, const model::Spacing& size, double margin)
    : region_(region), size_(size), margin_(margin) {
    const Box box = region.bounds();
    if (box.empty()) return;
    const double side = std::max(box.size().x, box.size().y);
    largest_side_ = side / 64.0; // so that no small spot of fine elements is stepped over
    smallest_side_ = std::sqrt(region.area() / most_elements);
    cover(0.5 * (box.lower + box.upper), side, 0.0);
}

/// `known_size` is the size (m) at the middle of the smallest square around this one whose middle lies inside, or 0:
/// outside the region nobody may be asked.
void Field::cover(Vec2 middle, double side, double known_size) {
    const double distance = region_.distance(middle);
    if (distance > side / std::numbers::sqrt2) return;
    const bool inside = distance <= 0.0;
    const double size = inside && side <= largest_side_ ? size_(middle) : known_size;
    if (side > std::max(coarseness * size, smallest_side_) || side > largest_side_) {
        for (const Vec2 quarter : {Vec2{-0.25, -0.25}, Vec2{0.25, -0.25}, Vec2{-0.25, 0.25}, Vec2{0.25, 0.25}}) {
            cover(middle + side * quarter, 0.5 * side, size);
        }
        return;
    }
    if (!inside || distance > -margin_ * size) return;
    squares_.push_back({middle, side, side * side / (hexagon * size * size)});
    elements_ += squares_.back().elements;
    if (elements_ > most_elements) {
        throw RunError("relaxed pack: more than ten million elements would fit; ask for larger ones");
    }
}

std::vector<Vec2> Field::sow(std::size_t count, std::uint64_t seed) const {
    std::vector<Vec2> places;
    const double share = elements_ / static_cast<double>(count);
    double passed = 0.0; // elements in the squares so far
    for (const Square& square : squares_) {
        passed += square.elements;
        while (places.size() < count && passed > (static_cast<double>(places.size()) + 0.5) * share) {
            places.push_back(place_in(square, seed, places.size()));
        }
    }
    return places;
}

Vec2 Field::place_in(const Square& square, std::uint64_t seed, std::uint64_t number) const {
    constexpr std::uint64_t tries = 16;
    for (std::uint64_t k = tries * number; k < tries * (number + 1); ++k) {
        const Vec2 shaken{uniform(seed, across, k) - 0.5, uniform(seed, upwards, k) - 0.5};
        const Vec2 place = square.middle + square.side * shaken;
        if (region_.distance(place) < 0.0) return place;
    }
    return square.middle;
}

} // namespace demlua::packing
