// Rigid clusters of disks, grown inside a region until they press against each other and against its boundary
// (Tavarez & Plesha 2007, section 4; growing inside fixed walls is pressing walls inward, seen in other
// units).
//
// Disks that overlap, and disks that reach over the boundary, push apart with a force equal to the overlap.
// The clusters slide without friction down the energy of all overlaps (FIRE: Bitzek, Koskinen, Gaehler,
// Moseler & Gumbsch, Phys. Rev. Lett. 97, 170201, 2006) after every small step of growth.
#include "engine/base/cell_grid.hpp"
#include "engine/base/problems.hpp"
#include "engine/base/random.hpp"
#include "engine/packing/packing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

namespace demlua::packing {
namespace {

// Overlaps are in radii throughout. The figures below were found by trial on packs of 1 to 12,000 elements.
constexpr double spread_coverage = 0.75; ///< share of the region that circles around the clusters cover first
constexpr double first_size = 0.3;       ///< size at which those are put down, as a share
constexpr double fastest_growth = 0.1;   ///< growth of the radius in one step, as a share of the radius
constexpr double slowest_growth = 0.005; ///< the same near the end
constexpr double growth_to_go = 0.3;     ///< and in between, as a share of what is missing
constexpr double growing_overlap = 0.05; ///< the next step may come once no overlap exceeds this,
constexpr int growing_moves = 10;        ///< and comes after this many moves in any case
constexpr double final_overlap = 0.03;   ///< the pack is done once no overlap exceeds this
constexpr double largest_overlap = 0.1;  ///< above this it is no pack
constexpr int final_moves = 350;         ///< in one attempt at the end
constexpr int attempts = 60;             ///< with a squeeze and a shake before each but the first
constexpr double squeeze = 0.12;         ///< by which radii are too large for a while, as a share
constexpr double shake = 1.0;            ///< farthest that a shake throws a cluster along each axis
constexpr double fading = 0.95;          ///< strength of a squeeze and shake over that of the one before
constexpr double setback = 0.05;         ///< a shake that makes the largest overlap grow by more is undone
constexpr int squeeze_moves = 100;       ///< how long a squeeze lasts
constexpr double shrinking = 0.005;      ///< steps of the radius when looking for what does fit, as a share
constexpr int most_shrinks = 100;        ///< after which the search ends
constexpr double list_skin = 0.3;        ///< in final radii: what the lists of near disks hold beyond touching

/// Disk centres of a cluster about its middle, in radii; every disk touches its neighbours.
std::vector<Vec2> cluster_shape(int disks) {
    constexpr double root = std::numbers::sqrt3;
    switch (disks) {
    case 1:
        return {{0.0, 0.0}};
    case 2:
        return {{-1.0, 0.0}, {1.0, 0.0}};
    case 3:
        return {{-1.0, -1.0 / root}, {1.0, -1.0 / root}, {0.0, 2.0 / root}};
    case 4:
        return {{-1.0, 0.0}, {1.0, 0.0}, {0.0, root}, {0.0, -root}};
    case 7:
        return {{0.0, 0.0}, {2.0, 0.0}, {1.0, root}, {-1.0, root}, {-2.0, 0.0}, {-1.0, -root}, {1.0, -root}};
    default:
        break;
    }
    throw RunError("a consolidated pack is made of clusters of 1, 2, 3, 4 or 7 elements");
}

/// Radius of the circle around a cluster, in radii of its disks.
double circle_around(const std::vector<Vec2>& shape) {
    double farthest = 0.0;
    for (const Vec2 p : shape) farthest = std::max(farthest, norm(p));
    return 1.0 + farthest;
}

double bounded_area(const model::Region& region) {
    const double area = region.area();
    if (std::isfinite(area)) return area;
    throw RunError("a consolidated pack needs a bounded region; cut the half-plane with a rectangle");
}

std::size_t cluster_count(double area, const Consolidation& settings) {
    const auto size = static_cast<std::size_t>(settings.cluster);
    if (settings.count > 0) return (settings.count + size - 1) / size;
    if (!(settings.radius > 0.0)) return 0;
    const double disks = settings.solid_fraction * area / (std::numbers::pi * settings.radius * settings.radius);
    return static_cast<std::size_t>(disks * (1.0 + 1e-12)) / size;
}

/// Streams of random numbers.
enum Stream : std::uint64_t { offsets, across, upwards, angles, shakes };

/// Where a cluster is, or how fast it moves, or what pushes it: x, y (m) and the turn as an arc length (m) at
/// the radius of gyration, so that all three weigh the same.
struct Motion {
    Vec2 shift;
    double turn = 0.0;
};

double product(const Motion& a, const Motion& b) { return dot(a.shift, b.shift) + a.turn * b.turn; }

/// Clusters and the disks they carry. Disk k belongs to cluster k / shape.size().
class Growth {
public:
    Growth(const model::Region& region, std::vector<Vec2> shape, std::size_t clusters, double radius)
        : region_(region), shape_(std::move(shape)), final_radius_(radius), places_(clusters), speeds_(clusters),
          forces_(clusters), disks_(clusters * shape_.size()), listed_(disks_.size()), pushes_(disks_.size()) {
        double sum = 0.5 * static_cast<double>(shape_.size());
        for (const Vec2 p : shape_) sum += dot(p, p);
        gyration_ = radius * std::sqrt(sum / static_cast<double>(shape_.size()));
    }

    [[nodiscard]] double radius() const { return radius_; }
    [[nodiscard]] const std::vector<Vec2>& disks() const { return disks_; }
    [[nodiscard]] const std::vector<Motion>& places() const { return places_; }
    void put_back(const std::vector<Motion>& places);

    /// Puts clusters of disks of `radius` (m) with their middles at `middles`, turned at random.
    void put_down(const std::vector<Vec2>& middles, double radius, std::uint64_t seed);

    /// Gives the disks another radius, m; clusters keep their middles and grow or shrink about them.
    void grow_to(double radius);

    /// Throws every cluster up to `reach` (m) along each axis, and as far along its turn; `round` counts the
    /// shakes.
    void throw_about(double reach, std::uint64_t seed, std::uint64_t round);

    /// Moves until no overlap exceeds `overlap` (in radii), at most `moves` times; returns the largest left
    /// (in radii).
    double settle(double overlap, int moves);

    /// How many pairs of touching disks of one cluster have a wall pass between them.
    [[nodiscard]] std::size_t torn_pairs() const;

private:
    struct Pair {
        Index first;
        Index second;
    };

    void set_disks();
    void refresh_lists();
    [[nodiscard]] bool lists_hold() const;
    double push();
    double push_pairs();
    double push_walls();
    void gather_forces();
    void step();

    const model::Region& region_;
    std::vector<Vec2> shape_;
    double final_radius_;
    double radius_ = 0.0;
    double gyration_ = 0.0;
    std::vector<Motion> places_;
    std::vector<Motion> speeds_;
    std::vector<Motion> forces_;
    std::vector<Vec2> disks_;
    std::vector<Vec2> listed_;           ///< the disks when the lists were made
    double listed_radius_ = -1.0;        ///< the radius then; negative before the first time
    std::vector<Vec2> pushes_;           ///< force on each disk
    std::vector<Pair> pairs_;            ///< disks of different clusters that may touch
    std::vector<Index> rim_;             ///< disks that may touch the boundary
    std::vector<model::Boundary> walls_; ///< scratch: those one disk meets
    CellGrid grid_;
    double time_step_ = 0.0;
    double mixing_ = 0.0;
    int downhill_ = 0;
};

void Growth::put_down(const std::vector<Vec2>& middles, double radius, std::uint64_t seed) {
    radius_ = radius;
    for (std::size_t k = 0; k < places_.size(); ++k) {
        const double angle = 2.0 * std::numbers::pi * uniform(seed, angles, k);
        places_[k] = {middles[k], gyration_ * angle};
    }
    set_disks();
}

void Growth::put_back(const std::vector<Motion>& places) {
    places_ = places;
    set_disks();
}

void Growth::set_disks() {
    std::size_t disk = 0;
    for (const Motion& place : places_) {
        const double angle = place.turn / gyration_;
        const Vec2 axis{radius_ * std::cos(angle), radius_ * std::sin(angle)};
        for (const Vec2 p : shape_) disks_[disk++] = place.shift + p.x * axis + p.y * turned_left(axis);
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
        places_[k].shift += 2.0 * reach * share;
        places_[k].turn += 2.0 * reach * (uniform(seed, stream + 2, k) - 0.5);
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
                if (norm(disks_[a] - disks_[b]) > 2.1 * radius_) continue;
                if (region_.distance(0.5 * (disks_[a] + disks_[b])) > -least * radius_) ++torn;
            }
        }
    }
    return torn;
}

bool Growth::lists_hold() const {
    if (listed_radius_ < 0.0) return false;
    const double room = 0.5 * (list_skin * final_radius_) - (radius_ - listed_radius_);
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
    const double reach = 2.0 * radius_ + skin;
    const std::size_t size = shape_.size();
    pairs_.clear();
    grid_.build(disks_, reach);
    grid_.for_each_pair(reach, [&](Index i, Index j) {
        if (i / size != j / size) pairs_.push_back({i, j});
    });
    rim_.clear();
    for (std::size_t k = 0; k < disks_.size(); ++k) {
        if (region_.distance(disks_[k]) > -(radius_ + skin)) rim_.push_back(static_cast<Index>(k));
    }
}

/// Returns the largest overlap, m; so do the two that follow.
double Growth::push() {
    refresh_lists();
    std::fill(pushes_.begin(), pushes_.end(), Vec2{});
    const double pairs = push_pairs(); // in this order on every compiler, for forces add up in it
    const double walls = push_walls();
    gather_forces();
    return std::max(pairs, walls);
}

double Growth::push_pairs() {
    const double touching = 2.0 * radius_;
    double largest = 0.0;
    for (const auto [i, j] : pairs_) {
        const Vec2 between = disks_[j] - disks_[i];
        const double square = dot(between, between);
        if (square >= touching * touching || square == 0.0) continue;
        const double distance = std::sqrt(square);
        const double overlap = touching - distance;
        largest = std::max(largest, overlap);
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
        region_.walls_near(disks_[k], radius_, walls_);
        for (const model::Boundary& wall : walls_) {
            const double overlap = radius_ + wall.distance;
            largest = std::max(largest, overlap);
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
        forces_[k] = {share * force, share * torque / gyration_};
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

/// Places one after another, spread evenly over a region and yet at random: every part of the region gets its
/// share, so that no part ends up with more than fits. They follow the R2 sequence (Roberts 2018: steps by
/// the powers of the root of x^3 = x + 1), each shaken by up to half the distance of neighbours.
class Sprinkler {
public:
    Sprinkler(const model::Region& region, double area, std::size_t count, std::uint64_t seed)
        : region_(region), box_(region.bounds()), seed_(seed), shake_(std::sqrt(area / static_cast<double>(count))) {}

    /// The next place at least `clearance` (m) from the boundary; where none comes by, the roomiest that did.
    Vec2 next(double clearance) {
        constexpr int tries = 2000;
        Vec2 best;
        double depth = -std::numeric_limits<double>::infinity();
        for (int k = 0; k < tries && depth < clearance; ++k) {
            const Vec2 point = trial(drawn_++);
            const double inside = -region_.distance(point);
            if (inside <= depth) continue;
            best = point;
            depth = inside;
        }
        return best;
    }

private:
    [[nodiscard]] Vec2 trial(std::uint64_t number) const {
        constexpr Vec2 stride{0.7548776662466927, 0.5698402909980532};
        const auto n = static_cast<double>(number);
        const Vec2 even{std::fmod(uniform(seed_, offsets, 0) + n * stride.x, 1.0),
                        std::fmod(uniform(seed_, offsets, 1) + n * stride.y, 1.0)};
        const Vec2 shaken{uniform(seed_, across, number) - 0.5, uniform(seed_, upwards, number) - 0.5};
        return box_.lower + Vec2{even.x * box_.size().x, even.y * box_.size().y} + shake_ * shaken;
    }

    const model::Region& region_;
    Box box_;
    std::uint64_t seed_;
    double shake_;
    std::uint64_t drawn_ = 0;
};

/// Neighbours get near numbers, so that the loops over pairs find them in the cache.
std::vector<Vec2> sorted_by_cell(const std::vector<Vec2>& points, double cell) {
    CellGrid grid;
    grid.build(points, cell);
    std::vector<Vec2> sorted;
    for (const Index k : grid.order()) sorted.push_back(points[k]);
    return sorted;
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

/// Middles for clusters, none nearer to another or to the boundary than the circles around them, which have
/// the returned radius (m). Growing clusters at once would leave some locked into each other.
struct Middles {
    std::vector<Vec2> at;
    double circle;
};

Middles spread(const model::Region& region, double area, std::size_t count, double circle, std::uint64_t seed) {
    circle = std::min(circle, std::sqrt(spread_coverage * area / (std::numbers::pi * static_cast<double>(count))));
    Sprinkler sprinkler(region, area, count, seed);
    std::vector<Vec2> at;
    for (std::size_t k = 0; k < count; ++k) at.push_back(sprinkler.next(first_size * circle));
    Growth circles(region, cluster_shape(1), count, circle);
    circles.put_down(sorted_by_cell(at, 4.0 * circle), first_size * circle, seed);
    grow(circles, circle);
    return {circles.disks(), circle};
}

/// Settles a pack grown to `radius` and returns the largest overlap left. A pack that has jammed is squeezed, shaken
/// and let go, which rearranges it and keeps it from ordering. A shake may also lock clusters into each other or
/// push one astride a thin wall; then it did not happen.
double press(Growth& pack, double radius, std::uint64_t seed) {
    double left = pack.settle(final_overlap, final_moves);
    std::size_t torn = pack.torn_pairs();
    double strength = 1.0;
    for (std::uint64_t k = 1; k < attempts && left > final_overlap; ++k, strength *= fading) {
        const std::vector<Motion> before = pack.places();
        pack.grow_to((1.0 + strength * squeeze) * radius);
        pack.throw_about(strength * shake * radius, seed, k);
        pack.settle(0.0, squeeze_moves);
        pack.grow_to(radius);
        const double now = pack.settle(final_overlap, final_moves);
        const std::size_t torn_now = pack.torn_pairs();
        if (now > left + setback || torn_now > torn) {
            pack.put_back(before);
        } else {
            left = now;
            torn = torn_now;
        }
    }
    return left;
}

/// Shrinks a pack until it fits and says what it came to.
[[noreturn]] void report_jam(Growth& pack, double left, double solid_fraction) {
    const double wanted = pack.radius();
    for (int k = 0; k < most_shrinks && pack.settle(growing_overlap, final_moves) > growing_overlap; ++k) {
        pack.grow_to((1.0 - shrinking) * pack.radius());
    }
    const double share = pack.radius() / wanted;
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(),
                  "consolidated pack: at solid fraction %.3g elements overlap by up to %.2g radii; "
                  "about %.3g fits; lower solid_fraction or take smaller clusters or more elements",
                  solid_fraction, left, solid_fraction * share * share);
    throw RunError(text.data());
}

/// Order of the disks by bands across the longer side of the box, and within a band along the shorter.
std::vector<std::size_t> order_by_bands(const std::vector<Vec2>& disks, const Box& box, double band) {
    const bool wide = box.size().x >= box.size().y;
    struct Key {
        double band;
        double along;
    };
    std::vector<Key> keys;
    for (const Vec2 p : disks) {
        const Vec2 q = p - box.lower;
        keys.push_back({std::floor((wide ? q.x : q.y) / band), wide ? q.y : q.x});
    }
    std::vector<std::size_t> order(disks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&keys](std::size_t a, std::size_t b) {
        return std::tie(keys[a].band, keys[a].along, a) < std::tie(keys[b].band, keys[b].along, b);
    });
    return order;
}

Packing numbered(const std::vector<Vec2>& disks, std::size_t cluster, const Box& box, double radius, double area) {
    constexpr Index none = std::numeric_limits<Index>::max();
    std::vector<Index> number(disks.size() / cluster, none);
    Index clusters = 0;
    Packing packing;
    for (const std::size_t k : order_by_bands(disks, box, 4.0 * radius)) {
        Index& mine = number[k / cluster];
        if (mine == none) mine = clusters++;
        packing.centre.push_back(disks[k]);
        packing.cluster.push_back(mine);
    }
    packing.radius.assign(disks.size(), radius);
    packing.cell_area.assign(disks.size(), area / static_cast<double>(disks.size()));
    return packing;
}

} // namespace

double consolidated_radius(const model::Region& region, const Consolidation& settings) {
    if (settings.count == 0) return settings.radius;
    const double area = bounded_area(region);
    const std::size_t count = cluster_count(area, settings) * static_cast<std::size_t>(settings.cluster);
    return std::sqrt(settings.solid_fraction * area / (std::numbers::pi * static_cast<double>(count)));
}

Packing consolidated(const model::Region& region, const Consolidation& settings) {
    const std::vector<Vec2> shape = cluster_shape(settings.cluster);
    const double area = bounded_area(region);
    const std::size_t clusters = cluster_count(area, settings);
    const double radius = consolidated_radius(region, settings);
    if (clusters == 0 || !(radius > 0.0)) return {};

    const double around = circle_around(shape);
    const Middles middles = spread(region, area, clusters, around * radius, settings.seed);
    Growth pack(region, shape, clusters, radius);
    pack.put_down(middles.at, middles.circle / around, settings.seed);
    grow(pack, radius);
    const double left = press(pack, radius, settings.seed);
    if (left > largest_overlap) report_jam(pack, left, settings.solid_fraction);
    return numbered(pack.disks(), shape.size(), region.bounds(), radius, area);
}

} // namespace demlua::packing
