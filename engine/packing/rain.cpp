#include "engine/base/problems.hpp"
#include "engine/base/random.hpp"
#include "engine/packing/disk_grid.hpp"
#include "engine/packing/grains.hpp"
#include "engine/packing/growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace demlua::packing {
namespace {

using model::Disk;

// Lengths are in radii of the smallest element there may be.
constexpr double overlap_left = 1e-3; ///< what pushing apart may leave
constexpr double longest_step = 0.2;  ///< downwards, before what overlaps is pushed apart
constexpr double last_step = 2e-4;    ///< a grain that such a step does not lower lies still
constexpr double least_gain = 1e-6;   ///< of a step, what must have been gained in height
constexpr double near_contact = 0.02; ///< gap at which falling ends and sliding begins
constexpr int sweeps = 20;            ///< over all contacts, to push them apart
constexpr std::uint64_t tries = 300;  ///< places for one grain; after as many the region is full

/// One grain on its way down.
class Falling {
public:
    Falling(const model::Region& region, const DiskGrid& grid, const GrainOrder& order)
        : region_(region), grid_(grid), shape_(order.shape), unit_(order.shape.least_radius * order.sizes.least()) {}

    /// Puts it inside the region as high as it can be there, and tells whether that place is free.
    bool start(double x, double angle, double size);
    void settle();

    [[nodiscard]] const Grain& grain() const { return grain_; }
    [[nodiscard]] const std::vector<Disk>& disks() const { return disks_; }

private:
    void put(const Grain& grain) {
        grain_ = grain;
        put_disks(shape_, grain_, disks_);
    }
    void lower(double by) { put({grain_.at - Vec2{0.0, by}, grain_.angle, grain_.size}); }
    /// How far the grain reaches out of the region, m; negative inside.
    [[nodiscard]] double sticks_out() const;
    [[nodiscard]] bool walls_in_reach();
    [[nodiscard]] double room() const;
    void fall();
    double push(std::size_t disk, Vec2 out, double overlap);
    double push_off_disks();
    double push_off_walls();
    bool push_out();

    const model::Region& region_;
    const DiskGrid& grid_;
    const GrainShape& shape_;
    double unit_;
    Grain grain_;
    std::vector<Disk> disks_;
    bool touching_ = false;
    Vec2 measured_at_; ///< where the region's boundary was `wall_distance_` away, m
    double wall_distance_ = 0.0;
    std::vector<Disk> others_;           ///< scratch
    std::vector<model::Boundary> walls_; ///< scratch
};

double Falling::sticks_out() const {
    double most = -std::numeric_limits<double>::infinity();
    for (const Disk& disk : disks_) most = std::max(most, region_.distance(disk.centre) + disk.radius);
    return most;
}

bool Falling::start(double x, double angle, double size) {
    const Box box = region_.bounds();
    put({{x, box.upper.y}, angle, size});
    wall_distance_ = 0.0;
    double out = sticks_out();
    while (out > 0.0) {
        if (grain_.at.y < box.lower.y) return false;
        lower(std::max(out, 0.05 * unit_));
        out = sticks_out();
    }
    if (grid_.top(x, shape_.around * size) < grain_.at.y - shape_.around * size) return true;
    return room() > 0.0;
}

/// How far it can go without meeting anything, at most its own diameter, m; negative where it overlaps something.
double Falling::room() const {
    double least = std::min(-sticks_out(), 2.0 * shape_.around * grain_.size);
    for (const Disk& disk : disks_) {
        grid_.for_each_near(disk.centre, disk.radius, std::max(least, 0.0), [&](const Disk& other) {
            least = std::min(least, norm(other.centre - disk.centre) - disk.radius - other.radius);
        });
    }
    return least;
}

void Falling::fall() {
    const double around = shape_.around * grain_.size;
    while (true) {
        const double above = grain_.at.y - around - grid_.top(grain_.at.x, around);
        const double way = above > around ? std::min(above, -sticks_out()) : room();
        if (way < near_contact * unit_) return;
        lower(way);
    }
}

bool Falling::walls_in_reach() {
    const double reach = shape_.around * grain_.size;
    if (wall_distance_ - norm(grain_.at - measured_at_) > reach) return false;
    measured_at_ = grain_.at;
    wall_distance_ = -region_.distance(grain_.at);
    return wall_distance_ <= reach;
}

/// Moves the grain, as free to turn as to shift, until `disk` has gone `overlap` (m) along `out`.
double Falling::push(std::size_t disk, Vec2 out, double overlap) {
    touching_ = true;
    const Vec2 arm = disks_[disk].centre - grain_.at;
    const double lever = cross(arm, out) / (shape_.gyration * grain_.size);
    const double shift = overlap / (1.0 + lever * lever);
    const double turn = shift * lever / (shape_.gyration * grain_.size);
    put({grain_.at + shift * out, grain_.angle + turn, grain_.size});
    return overlap;
}

double Falling::push_off_disks() {
    double largest = 0.0;
    for (std::size_t k = 0; k < disks_.size(); ++k) {
        others_.clear();
        grid_.for_each_near(disks_[k].centre, disks_[k].radius, 0.0,
                            [this](const Disk& other) { others_.push_back(other); });
        for (const Disk& other : others_) {
            const Vec2 between = disks_[k].centre - other.centre;
            const double distance = norm(between);
            const double overlap = disks_[k].radius + other.radius - distance;
            if (overlap > 0.0 && distance > 0.0) largest = std::max(largest, push(k, between / distance, overlap));
        }
    }
    return largest;
}

double Falling::push_off_walls() {
    double largest = 0.0;
    for (std::size_t k = 0; k < disks_.size(); ++k) {
        region_.walls_near(disks_[k].centre, disks_[k].radius, walls_);
        for (const model::Boundary& wall : walls_) {
            const double overlap = disks_[k].radius + wall.distance;
            if (overlap > 0.0) largest = std::max(largest, push(k, -wall.outward, overlap));
        }
    }
    return largest;
}

/// Whether pushing has left no more overlap than it may.
bool Falling::push_out() {
    touching_ = false;
    double largest = 0.0;
    for (int k = 0; k < sweeps; ++k) {
        largest = push_off_disks();
        if (walls_in_reach()) largest = std::max(largest, push_off_walls());
        if (largest <= overlap_left * unit_) return true;
    }
    return false;
}

void Falling::settle() {
    fall();
    double step = longest_step * unit_;
    while (step > last_step * unit_) {
        const Grain before = grain_;
        lower(step);
        if (push_out() && grain_.at.y < before.at.y - least_gain * step) {
            step = std::min(2.0 * step, longest_step * unit_);
            if (!touching_) fall();
        } else {
            put(before);
            step *= 0.5;
        }
    }
}

double middle_within(double low, double high, double share) {
    return low < high ? low + share * (high - low) : 0.5 * (low + high);
}

std::string shortfall(const GrainOrder& order, std::size_t put, double covered) {
    const double reached = 1.0 - covered / order.region_area;
    const std::string full = fmt::format("rained grains: the region is full at porosity {:.3g}", reached);
    if (order.count > 0) {
        return fmt::format("{}, after {} of {} grains; ask for fewer", full, put, order.count);
    }
    return fmt::format("{}; {:.3g} was asked for; ask for more, or take \"consolidation\"", full,
                       1.0 - order.solid_area / order.region_area);
}

} // namespace

std::vector<Grain> rained(const model::Region& region, const GrainOrder& order) {
    const Box box = region.bounds();
    const GrainShape& shape = order.shape;
    DiskGrid grid(box, shape.greatest_radius * order.sizes.greatest());
    Falling falling(region, grid, order);
    std::vector<Grain> put;
    double covered = 0.0;
    std::uint64_t tried = 0;
    const auto drop = [&](double size) {
        const double around = shape.around * size;
        for (const std::uint64_t last = tried + tries; tried < last;) {
            const double share = uniform(order.seed, across, tried);
            const double angle = 2.0 * std::numbers::pi * uniform(order.seed, angles, tried);
            ++tried;
            if (falling.start(middle_within(box.lower.x + around, box.upper.x - around, share), angle, size))
                return true;
        }
        return false;
    };
    const auto done = [&](double next) {
        if (order.count > 0) return put.size() == order.count;
        return order.solid_area > 0.0 && covered + 0.5 * next > order.solid_area;
    };
    while (true) {
        const double size = order.sizes.at(uniform(order.seed, sizes, put.size()));
        const double next = shape.area * size * size;
        if (done(next)) return put;
        if (!drop(size)) break;
        falling.settle();
        put.push_back(falling.grain());
        for (const Disk& disk : falling.disks()) grid.add(disk);
        covered += next;
    }
    if (order.count > 0 || order.solid_area > 0.0) throw RunError(shortfall(order, put.size(), covered));
    return put;
}

} // namespace demlua::packing
