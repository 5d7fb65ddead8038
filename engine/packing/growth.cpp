#include "engine/packing/growth.hpp"

#include "engine/base/problems.hpp"
#include "engine/base/random.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

namespace demlua::packing {

using model::Disk;

namespace {

// Like `growing_overlap`, found by trial on packs of 1 to 12,000 elements.
constexpr double fastest_growth = 0.1;   ///< growth of the radius in one step, as a share of the radius
constexpr double slowest_growth = 0.005; ///< the same near the end
constexpr double growth_to_go = 0.3;     ///< and in between, as a share of what is missing
constexpr int growing_moves = 10;        ///< the next step comes after this many moves in any case
constexpr double list_skin = 0.3;        ///< in final radii: what the lists of near disks hold beyond touching

double product(const Motion& a, const Motion& b) { return dot(a.shift, b.shift) + a.turn * b.turn; }

} // namespace

std::vector<Disk> cluster_shape(int disks) {
    constexpr double root = std::numbers::sqrt3;
    const auto touching = [](std::initializer_list<Vec2> centres) {
        std::vector<Disk> shape;
        for (const Vec2 centre : centres) shape.push_back({centre, 1.0});
        return shape;
    };
    switch (disks) {
    case 1:
        return touching({{0.0, 0.0}});
    case 2:
        return touching({{-1.0, 0.0}, {1.0, 0.0}});
    case 3:
        return touching({{-1.0, -1.0 / root}, {1.0, -1.0 / root}, {0.0, 2.0 / root}});
    case 4:
        return touching({{-1.0, 0.0}, {1.0, 0.0}, {0.0, root}, {0.0, -root}});
    case 7:
        return touching({{0.0, 0.0}, {2.0, 0.0}, {1.0, root}, {-1.0, root}, {-2.0, 0.0}, {-1.0, -root}, {1.0, -root}});
    default:
        break;
    }
    throw RunError("clusters by number are made of 1, 2, 3, 4 or 7 elements");
}

double circle_around(const std::vector<Disk>& shape) {
    double farthest = 0.0;
    for (const Disk& disk : shape) farthest = std::max(farthest, disk.radius + norm(disk.centre));
    return farthest;
}

Growth::Growth(const model::Region& region, const std::vector<Disk>& shape, std::vector<double> sizes, double radius)
    : region_(region), sizes_(std::move(sizes)), final_radius_(radius), places_(sizes_.size()), speeds_(sizes_.size()),
      forces_(sizes_.size()), disks_(sizes_.size() * shape.size()), listed_(disks_.size()), pushes_(disks_.size()) {
    double sum = 0.0;
    for (const Disk& disk : shape) sum += 0.5 * disk.radius * disk.radius;
    for (const Disk& disk : shape) {
        shape_.push_back(disk.centre);
        sum += dot(disk.centre, disk.centre);
    }
    gyration_ = radius * std::sqrt(sum / static_cast<double>(shape_.size()));
    relative_.reserve(disks_.size());
    for (const double size : sizes_) {
        for (const Disk& disk : shape) relative_.push_back(size * disk.radius);
    }
    for (const double each : relative_) largest_ = std::max(largest_, each);
}

void Growth::put_down(const std::vector<Vec2>& middles, double radius, std::uint64_t seed) {
    radius_ = radius;
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const double angle = 2.0 * std::numbers::pi * uniform(seed, angles, k);
        places_[k] = {middles[k], gyration(k) * angle};
    }
    set_disks();
}

void Growth::put_back(const std::vector<Motion>& places) {
    places_ = places;
    set_disks();
}

void Growth::set_disks() {
    std::size_t disk = 0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const double unit = radius_ * sizes_[k];
        const Vec2 axis{unit * std::cos(angle(k)), unit * std::sin(angle(k))};
        for (const Vec2 p : shape_) disks_[disk++] = places_[k].shift + p.x * axis + p.y * turned_left(axis);
    }
}

void Growth::grow_to(double radius) {
    radius_ = radius;
    set_disks();
    time_step_ = 0.0;
}

void Growth::throw_about(double reach, std::uint64_t seed, std::uint64_t round) {
    const std::uint64_t stream = shakes + 3 * round;
    const std::vector<Motion> places = places_;
    const std::vector<Vec2> disks = disks_;
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const Vec2 share{uniform(seed, stream, k) - 0.5, uniform(seed, stream + 1, k) - 0.5};
        const double far = 2.0 * reach * sizes_[k];
        places_[k].shift += far * share;
        places_[k].turn += far * (uniform(seed, stream + 2, k) - 0.5);
    }
    set_disks();
    for (std::size_t k = 0; k < disks.size(); ++k) {
        const bool may_cross = norm(disks_[k] - disks[k]) > -region_.distance(disks[k]);
        if (may_cross) places_[k / shape_.size()] = places[k / shape_.size()];
    }
    set_disks();
}

std::size_t Growth::torn_pairs() const {
    std::size_t torn = 0;
    constexpr double least = 0.1; // in radii: where disks touch, only the tip of a wall can come this near
    for (std::size_t first = 0; first < disks_.size(); first += shape_.size()) {
        for (std::size_t a = first; a < first + shape_.size(); ++a) {
            for (std::size_t b = first; b < a; ++b) {
                const double apart = radius_of(a) + radius_of(b);
                if (norm(disks_[a] - disks_[b]) > 1.05 * apart) continue;
                const Vec2 between = disks_[b] + (radius_of(b) / apart) * (disks_[a] - disks_[b]);
                if (region_.distance(between) > -least * std::min(radius_of(a), radius_of(b))) ++torn;
            }
        }
    }
    return torn;
}

bool Growth::lists_hold() const {
    if (listed_radius_ < 0.0) return false;
    const double room = 0.5 * (list_skin * final_radius_) - (radius_ - listed_radius_) * largest_;
    if (room <= 0.0) return false;
    double farthest = 0.0;
    for (std::size_t k = 0; k < disks_.size(); ++k) {
        const Vec2 way = disks_[k] - listed_[k];
        farthest = std::max(farthest, dot(way, way));
    }
    return farthest <= room * room;
}

void Growth::refresh_lists() {
    if (lists_hold()) return;
    listed_ = disks_;
    listed_radius_ = radius_;
    const double skin = list_skin * final_radius_;
    const double reach = 2.0 * radius_ * largest_ + skin;
    const std::size_t size = shape_.size();
    pairs_.clear();
    grid_.build(disks_, reach);
    grid_.for_each_pair(reach, [&](Index i, Index j) {
        if (i / size == j / size) return;
        const Vec2 between = disks_[j] - disks_[i];
        const double near = radius_of(i) + radius_of(j) + skin;
        if (dot(between, between) <= near * near) pairs_.push_back({i, j});
    });
    rim_.clear();
    for (std::size_t k = 0; k < disks_.size(); ++k) {
        if (region_.distance(disks_[k]) > -(radius_of(k) + skin)) rim_.push_back(static_cast<Index>(k));
    }
}

/// Returns the largest overlap, in radii times radius_; so do the two that follow.
double Growth::push() {
    refresh_lists();
    std::fill(pushes_.begin(), pushes_.end(), Vec2{});
    const double pairs = push_pairs(); // in this order on every compiler, for forces add up in it
    const double walls = push_walls();
    gather_forces();
    return std::max(pairs, walls);
}

double Growth::push_pairs() {
    double largest = 0.0;
    for (const auto [i, j] : pairs_) {
        const double touching = radius_of(i) + radius_of(j);
        const Vec2 between = disks_[j] - disks_[i];
        const double square = dot(between, between);
        if (square >= touching * touching || square == 0.0) continue;
        const double distance = std::sqrt(square);
        const double overlap = touching - distance;
        largest = std::max(largest, overlap / std::min(relative_[i], relative_[j]));
        const Vec2 force = (overlap / distance) * between;
        pushes_[i] -= force;
        pushes_[j] += force;
    }
    return largest;
}

/// A wall pushes like the mirror image of the disk.
double Growth::push_walls() {
    double largest = 0.0;
    for (const Index k : rim_) {
        region_.walls_near(disks_[k], radius_of(k), walls_);
        for (const model::Boundary& wall : walls_) {
            const double overlap = radius_of(k) + wall.distance;
            largest = std::max(largest, overlap / relative_[k]);
            pushes_[k] -= (2.0 * overlap) * wall.outward;
        }
    }
    return largest;
}

void Growth::gather_forces() {
    const double share = 1.0 / static_cast<double>(shape_.size());
    std::size_t disk = 0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
        Vec2 force;
        double torque = 0.0;
        for (std::size_t n = 0; n < shape_.size(); ++n, ++disk) {
            force += pushes_[disk];
            torque += cross(disks_[disk] - places_[k].shift, pushes_[disk]);
        }
        forces_[k] = {share * force, share * torque / gyration(k)};
    }
}

/// One move of FIRE. The unit of time is that of a disk of unit mass on a spring of unit stiffness.
void Growth::step() {
    constexpr double first_step = 0.2;
    constexpr double longest_step = 0.6;
    constexpr double first_mixing = 0.1;
    constexpr int patience = 5;

    double power = 0.0;
    double speed = 0.0;
    double force = 0.0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
        power += product(forces_[k], speeds_[k]);
        speed += product(speeds_[k], speeds_[k]);
        force += product(forces_[k], forces_[k]);
    }
    if (time_step_ == 0.0 || power < 0.0) {
        std::fill(speeds_.begin(), speeds_.end(), Motion{});
        time_step_ = time_step_ == 0.0 ? first_step : 0.5 * time_step_;
        mixing_ = first_mixing;
        downhill_ = 0;
        speed = 0.0;
    } else if (++downhill_ > patience) {
        time_step_ = std::min(1.1 * time_step_, longest_step);
        mixing_ *= 0.99;
    }
    const double keep = 1.0 - mixing_;
    const double pull = force > 0.0 ? mixing_ * std::sqrt(speed / force) : 0.0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
        Motion& v = speeds_[k];
        const Motion& f = forces_[k];
        v.shift = keep * v.shift + (pull + time_step_) * f.shift;
        v.turn = keep * v.turn + (pull + time_step_) * f.turn;
        places_[k].shift += time_step_ * v.shift;
        places_[k].turn += time_step_ * v.turn;
    }
    set_disks();
}

double Growth::settle(double overlap, int moves) {
    double largest = push();
    for (int k = 0; k < moves && largest > overlap * radius_; ++k) {
        step();
        largest = push();
    }
    return largest / radius_;
}

void grow(Growth& pack, double radius) {
    pack.settle(growing_overlap, growing_moves);
    while (pack.radius() < radius) {
        const double missing = radius / pack.radius() - 1.0;
        const double share = std::clamp(growth_to_go * missing, slowest_growth, fastest_growth);
        pack.grow_to(std::min(radius, pack.radius() * (1.0 + share)));
        pack.settle(growing_overlap, growing_moves);
    }
}

} // namespace demlua::packing
