// Rigid clusters of disks, all of one shape and each of its own size, that grow inside a region and push each other apart.
//
// Disks that overlap, and disks that reach over the boundary, push apart with a force equal to the overlap.
// The clusters slide without friction down the energy of all overlaps (FIRE: Bitzek, Koskinen, Gaehler,
// Moseler & Gumbsch, Phys. Rev. Lett. 97, 170201, 2006) after every small step of growth.
#pragma once

#include "engine/base/cell_grid.hpp"
#include "engine/base/column.hpp"
#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"
#include "engine/model/region.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace demlua::packing {

/// Largest overlap, in radii of the smaller disk, with which clusters still grow.
inline constexpr double growing_overlap = 0.05;

/// Streams of random numbers of a pack.
enum Stream : std::uint64_t { offsets, across, upwards, angles, shakes };

/// Streams beyond all that shakes use.
enum FarStream : std::uint64_t { sizes = 1U << 20U, ranks, removals };

/// Where a cluster is, or how fast it moves, or what pushes it: x, y (m) and the turn as an arc length (m) at
/// the radius of gyration, so that all three weigh the same.
struct Motion {
    Vec2 shift;
    double turn = 0.0;
};

/// Disks of a cluster about its middle, in radii; every disk touches its neighbours.
std::vector<model::Disk> cluster_shape(int disks);

/// Radius of the circle about the origin that holds the disks.
double circle_around(const std::vector<model::Disk>& shape);

/// Clusters and the disks they carry. Disk k belongs to cluster k / shape.size() and has `radius` times its radius in the
/// shape times the size of its cluster; overlaps are in radii of the smaller disk.
class Growth {
public:
    /// A cluster for each of `sizes`; `radius` (m) is the one they will grow to.
    Growth(const model::Region& region, const std::vector<model::Disk>& shape, std::vector<double> sizes,
           double radius);

    [[nodiscard]] double radius() const { return radius_; }
    [[nodiscard]] double angle(std::size_t cluster) const { return places_[cluster].turn / gyration(cluster); }
    [[nodiscard]] const std::vector<Vec2>& disks() const { return disks_; }
    [[nodiscard]] const std::vector<Motion>& places() const { return places_; }
    void put_back(const std::vector<Motion>& places);

    /// Puts clusters that have come to `radius` (m) with their middles at `middles`, turned at random.
    void put_down(const std::vector<Vec2>& middles, double radius, std::uint64_t seed);

    /// Gives the disks another radius, m; clusters keep their middles and grow or shrink about them.
    void grow_to(double radius);

    /// Throws every cluster up to `reach` (m) times its size along each axis, and as far along its turn; `round` counts
    /// the shakes.
    void throw_about(double reach, std::uint64_t seed, std::uint64_t round);

    /// Moves until no overlap exceeds `overlap`, at most `moves` times; returns the largest left.
    double settle(double overlap, int moves);

    /// How many pairs of touching disks of one cluster have a wall pass between them.
    [[nodiscard]] std::size_t torn_pairs() const;

private:
    struct Pair {
        Index first;
        Index second;
    };

    [[nodiscard]] double gyration(std::size_t cluster) const { return gyration_ * sizes_[cluster]; }
    [[nodiscard]] double radius_of(std::size_t disk) const { return radius_ * relative_[disk]; }
    void set_disks();
    void refresh_lists();
    [[nodiscard]] bool lists_hold() const;
    double push();
    double push_pairs();
    double push_walls();
    void gather_forces();
    void step();

    const model::Region& region_;
    std::vector<Vec2> shape_; ///< centres
    std::vector<double> sizes_;
    std::vector<double> relative_; ///< radius of each disk over radius_
    double largest_ = 0.0;         ///< of those
    double final_radius_;
    double radius_ = 0.0;
    double gyration_ = 0.0; ///< radius of gyration of a cluster of size 1 in the end, m
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

/// Grows the disks of `pack` to `radius` (m) in small steps and settles it after each.
void grow(Growth& pack, double radius);

} // namespace demlua::packing
