#include "engine/packing/grain_shapes.hpp"

#include "engine/base/random.hpp"
#include "engine/packing/disk_union.hpp"
#include "engine/packing/growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace demlua::packing {

using model::Disk;
using model::SizeClass;

GrainShape shape_of(const model::GrainPacking& settings) {
    GrainShape shape;
    shape.disks = settings.disks.empty() ? cluster_shape(settings.elements) : settings.disks;
    double sum = 0.0;
    for (const Disk& disk : shape.disks) sum += disk.radius;
    const double unit = sum / static_cast<double>(shape.disks.size());
    const Vec2 centroid = union_of(shape.disks).centroid;
    shape.least_radius = std::numeric_limits<double>::infinity();
    for (Disk& disk : shape.disks) {
        disk = {(disk.centre - centroid) / unit, disk.radius / unit};
        shape.least_radius = std::min(shape.least_radius, disk.radius);
        shape.greatest_radius = std::max(shape.greatest_radius, disk.radius);
    }
    const Lamina lamina = union_of(shape.disks);
    shape.area = lamina.area;
    shape.gyration = std::sqrt(lamina.polar / lamina.area);
    shape.around = circle_around(shape.disks);
    return shape;
}

void put_disks(const GrainShape& shape, const Grain& grain, std::vector<Disk>& disks) {
    const Vec2 axis{grain.size * std::cos(grain.angle), grain.size * std::sin(grain.angle)};
    disks.clear();
    for (const Disk& disk : shape.disks) {
        const Vec2 arm = disk.centre.x * axis + disk.centre.y * turned_left(axis);
        disks.push_back({grain.at + arm, grain.size * disk.radius});
    }
}

SizeSpread::SizeSpread(const std::vector<SizeClass>& classes) : classes_(classes) {
    double sum = 0.0;
    for (const SizeClass& each : classes_) sum += each.share;
    for (SizeClass& each : classes_) each.share /= sum;
}

double SizeSpread::at(double part) const {
    std::size_t k = 0;
    while (k + 1 < classes_.size() && part >= classes_[k].share) part -= classes_[k++].share;
    const double within = std::clamp(part / classes_[k].share, 0.0, 1.0);
    return classes_[k].least + within * (classes_[k].greatest - classes_[k].least);
}

double SizeSpread::mean() const {
    return std::accumulate(classes_.begin(), classes_.end(), 0.0, [](double sum, const SizeClass& each) {
        return sum + each.share * 0.5 * (each.least + each.greatest);
    });
}

double SizeSpread::mean_square() const {
    return std::accumulate(classes_.begin(), classes_.end(), 0.0, [](double sum, const SizeClass& each) {
        const double a = each.least;
        const double b = each.greatest;
        return sum + each.share * (a * a + a * b + b * b) / 3.0;
    });
}

double SizeSpread::least() const {
    const auto smaller = [](const SizeClass& a, const SizeClass& b) { return a.least < b.least; };
    return std::min_element(classes_.begin(), classes_.end(), smaller)->least;
}

double SizeSpread::greatest() const {
    const auto smaller = [](const SizeClass& a, const SizeClass& b) { return a.greatest < b.greatest; };
    return std::max_element(classes_.begin(), classes_.end(), smaller)->greatest;
}

namespace {

/// The numbers below `count` in random order.
std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed, std::uint64_t stream) {
    std::vector<double> key(count);
    for (std::size_t k = 0; k < count; ++k) key[k] = uniform(seed, stream, k);
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&key](std::size_t a, std::size_t b) { return key[a] < key[b]; });
    return order;
}

} // namespace

std::vector<double> SizeSpread::draw(std::size_t count, std::uint64_t seed) const {
    std::vector<double> drawn;
    drawn.reserve(count);
    for (const std::size_t part : shuffled(count, seed, ranks)) {
        drawn.push_back(at((static_cast<double>(part) + uniform(seed, sizes, part)) / static_cast<double>(count)));
    }
    return drawn;
}

std::vector<std::size_t> kept_at_random(std::size_t count, double removed, std::uint64_t seed) {
    std::vector<std::size_t> kept = shuffled(count, seed, removals);
    const auto gone = static_cast<std::size_t>(std::llround(removed * static_cast<double>(count)));
    kept.resize(count - std::min(gone, count));
    std::sort(kept.begin(), kept.end());
    return kept;
}

} // namespace demlua::packing
