// What grains look like and how large they are.
#pragma once

#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace demlua::packing {

/// Disks of a grain about the centroid of what they cover, in mean radii; `area` and `gyration` (radius of gyration) of
/// what they cover in the same unit, `around` the radius of the circle that holds them.
struct GrainShape {
    std::vector<model::Disk> disks;
    double area = 0.0;
    double gyration = 0.0;
    double around = 0.0;
    double least_radius = 0.0;
    double greatest_radius = 0.0;
};

/// Throws RunError for a number of elements that no template has.
GrainShape shape_of(const model::GrainPacking& settings);

/// Where a grain lies: its centroid (m), its angle (rad) and the mean radius of its elements (m).
struct Grain {
    Vec2 at;
    double angle = 0.0;
    double size = 0.0;
};

/// The disks of a grain, m, in the order of its shape.
void put_disks(const GrainShape& shape, const Grain& grain, std::vector<model::Disk>& disks);

/// Sizes of grains by number, m.
class SizeSpread {
public:
    explicit SizeSpread(const std::vector<model::SizeClass>& classes);

    /// The size that the share `part`, in [0, 1), of the grains stays below, where classes stand one after another.
    [[nodiscard]] double at(double part) const;
    [[nodiscard]] double mean() const;
    [[nodiscard]] double mean_square() const; ///< m^2
    [[nodiscard]] double least() const;
    [[nodiscard]] double greatest() const;

    /// `count` sizes in random order, one from each of as many equal parts of the spread.
    [[nodiscard]] std::vector<double> draw(std::size_t count, std::uint64_t seed) const;

private:
    std::vector<model::SizeClass> classes_; ///< shares add up to 1
};

/// Which of `count` things stay, in order, when the share `removed` of them goes at random.
std::vector<std::size_t> kept_at_random(std::size_t count, double removed, std::uint64_t seed);

} // namespace demlua::packing
