// Packings: lattices against counting by hand, consolidated packs against what a pack must be.
#include "engine/base/cell_grid.hpp"
#include "engine/base/problems.hpp"
#include "engine/base/random.hpp"
#include "engine/packing/packing.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace {

using Catch::Approx;
using demlua::CellGrid;
using demlua::Index;
using demlua::Vec2;
using demlua::model::Region;
using demlua::packing::close_packed;
using demlua::packing::consolidated;
using demlua::packing::consolidated_radius;
using demlua::packing::Consolidation;
using demlua::packing::Fit;
using demlua::packing::Packing;
using demlua::packing::Rows;
using std::numbers::pi;
using std::numbers::sqrt3;

/// Elements in each row or column of a packing numbered row by row; `height` is the coordinate rows share.
std::vector<int> row_counts(const Packing& packing, double Vec2::*height) {
    std::vector<int> counts;
    for (std::size_t k = 0; k < packing.centre.size(); ++k) {
        const bool new_row =
            k == 0 || std::abs(packing.centre[k].*height - packing.centre[k - 1].*height) > 0.1 * packing.radius[k];
        if (new_row) counts.push_back(0);
        ++counts.back();
    }
    return counts;
}

/// How many elements have their centre within `reach` of each.
std::vector<int> neighbours(const Packing& packing, double reach) {
    CellGrid grid;
    grid.build(packing.centre, reach);
    std::vector<int> counts(packing.centre.size(), 0);
    grid.for_each_pair(reach, [&](Index i, Index j) {
        ++counts[i];
        ++counts[j];
    });
    return counts;
}

/// Largest overlap of two disks, and of a disk with the outside, in radii.
struct Overlaps {
    double pairs = 0.0;
    double walls = 0.0;
};

Overlaps overlaps(const Packing& packing, const Region& region) {
    Overlaps largest;
    if (packing.centre.empty()) return largest;
    const double radius = packing.radius.front();
    CellGrid grid;
    grid.build(packing.centre, 2.0 * radius);
    grid.for_each_pair(2.0 * radius, [&](Index i, Index j) {
        const double gap = demlua::norm(packing.centre[j] - packing.centre[i]) - 2.0 * radius;
        largest.pairs = std::max(largest.pairs, -gap / radius);
    });
    for (const Vec2 p : packing.centre) {
        largest.walls = std::max(largest.walls, 1.0 + region.distance(p) / radius);
    }
    return largest;
}

/// Area of the part of a disk that lies below a line `height` above its centre.
double area_below(double radius, double height) {
    const double h = std::clamp(height, -radius, radius);
    return radius * radius * (pi - std::acos(h / radius)) + h * std::sqrt(radius * radius - h * h);
}

/// Share of the strip low < y < high of a rectangle as long as `length` that disks cover.
double solid_fraction(const Packing& packing, double length, double low, double high) {
    double sum = 0.0;
    for (std::size_t k = 0; k < packing.centre.size(); ++k) {
        const double y = packing.centre[k].y;
        sum += area_below(packing.radius[k], high - y) - area_below(packing.radius[k], low - y);
    }
    return sum / (length * (high - low));
}

void check_pack(const Packing& packing, const Region& region, const Consolidation& settings, std::size_t count) {
    REQUIRE(packing.centre.size() == count);
    REQUIRE(packing.radius.size() == count);
    REQUIRE(packing.cluster.size() == count);
    REQUIRE(packing.cell_area.size() == count);
    const double radius = std::sqrt(settings.solid_fraction * region.area() / (pi * static_cast<double>(count)));
    CHECK(consolidated_radius(region, settings) == Approx(radius).epsilon(1e-12));
    CHECK(std::all_of(packing.radius.begin(), packing.radius.end(),
                      [radius](double r) { return r == Approx(radius).epsilon(1e-12); }));
    CHECK(std::accumulate(packing.cell_area.begin(), packing.cell_area.end(), 0.0) == Approx(region.area()));
}

/// Every cluster has its size, its disks touch as in its template, and clusters are numbered as they first
/// appear.
void check_clusters(const Packing& packing, std::size_t size, int touching) {
    const double reach = 2.0 * packing.radius.front() * (1.0 + 1e-9);
    std::vector<std::vector<Vec2>> members(packing.centre.size() / size);
    Index next = 0;
    for (std::size_t k = 0; k < packing.centre.size(); ++k) {
        REQUIRE(packing.cluster[k] <= next);
        next = std::max(next, packing.cluster[k] + 1);
        members[packing.cluster[k]].push_back(packing.centre[k]);
    }
    CHECK(next == members.size());
    for (const std::vector<Vec2>& disks : members) {
        REQUIRE(disks.size() == size);
        int contacts = 0;
        for (std::size_t a = 0; a < size; ++a) {
            for (std::size_t b = 0; b < a; ++b) contacts += demlua::norm(disks[a] - disks[b]) <= reach ? 1 : 0;
        }
        CHECK(contacts == touching);
    }
}

Consolidation settings_for(std::size_t count, int cluster, double solid_fraction, std::uint64_t seed) {
    Consolidation settings;
    settings.count = count;
    settings.cluster = cluster;
    settings.solid_fraction = solid_fraction;
    settings.seed = seed;
    return settings;
}

} // namespace

// --- the grid ---------------------------------------------------------------------------------------------

TEST_CASE("the cell grid finds every near pair once", "[packing]") {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{500}}) {
        std::vector<Vec2> points;
        for (std::uint64_t k = 0; k < count; ++k) {
            points.push_back({3.0 * demlua::uniform(1, 0, k), demlua::uniform(1, 1, k)});
        }
        for (const double reach : {0.01, 0.1, 0.5, 10.0}) {
            CellGrid grid;
            grid.build(points, reach);
            std::vector<std::pair<Index, Index>> found;
            grid.for_each_pair(reach, [&](Index i, Index j) { found.emplace_back(std::min(i, j), std::max(i, j)); });
            std::sort(found.begin(), found.end());
            std::vector<std::pair<Index, Index>> expected;
            for (Index i = 0; i < count; ++i) {
                for (Index j = i + 1; j < count; ++j) {
                    if (demlua::norm(points[j] - points[i]) <= reach) expected.emplace_back(i, j);
                }
            }
            CHECK(found == expected);
        }
    }
}

TEST_CASE("the cell grid stays small around a point far away", "[packing]") {
    CellGrid grid;
    grid.build(std::vector<Vec2>{{0.0, 0.0}, {0.5e-3, 0.0}, {1e6, 1e6}}, 1e-3);
    int pairs = 0;
    grid.for_each_pair(1e-3, [&pairs](Index /*i*/, Index /*j*/) { ++pairs; });
    CHECK(pairs == 1);
}

// --- close packing ----------------------------------------------------------------------------------------

TEST_CASE("a close-packed beam has rows of 17 and 16 across its height", "[packing]") {
    const double radius = 7.8125e-3; // 16 diameters in 0.25 m
    const Region beam = Region::rectangle({0.0, 0.0}, {2.6, 0.25});
    const Packing packing = close_packed(beam, radius, Rows::vertical, Fit::centres, std::nullopt);
    const std::vector<int> counts = row_counts(packing, &Vec2::x);
    REQUIRE(counts.size() == static_cast<std::size_t>(2.6 / (sqrt3 * radius)) + 1);
    for (std::size_t k = 0; k < counts.size(); ++k) CHECK(counts[k] == (k % 2 == 0 ? 17 : 16));
    CHECK(packing.centre.front() == Vec2{0.0, 0.0});
    CHECK(packing.centre[16].y == Approx(0.25));
    CHECK(packing.cell_area.front() == Approx(2.0 * sqrt3 * radius * radius));
}

TEST_CASE("every element inside a lattice touches six others", "[packing]") {
    const double radius = 0.02;
    const Region region = Region::rectangle({-0.3, 0.1}, {1.0, 0.8});
    for (const Rows rows : {Rows::horizontal, Rows::vertical}) {
        const Packing packing = close_packed(region, radius, rows, Fit::inside, std::nullopt);
        CHECK(overlaps(packing, region).pairs < 1e-9);
        CHECK(overlaps(packing, region).walls < 1e-8);
        const std::vector<int> touching = neighbours(packing, 2.0 * radius * (1.0 + 1e-9));
        for (std::size_t k = 0; k < packing.centre.size(); ++k) {
            CHECK(touching[k] <= 6);
            if (region.distance(packing.centre[k]) < -4.0 * radius) CHECK(touching[k] == 6);
        }
        const double cells = static_cast<double>(packing.centre.size()) * packing.cell_area.front();
        CHECK(cells == Approx(0.8).epsilon(0.1));
        CHECK(packing.centre.front().x == Approx(-0.3 + radius));
        CHECK(packing.centre.front().y == Approx(0.1 + radius));
    }
}

TEST_CASE("a lattice runs through the origin it is given", "[packing]") {
    const Vec2 origin{0.013, -0.4};
    const Packing packing = close_packed(Region::disc({0.0, 0.0}, 0.5), 0.03, Rows::horizontal, Fit::centres, origin);
    const auto nearest = std::min_element(packing.centre.begin(), packing.centre.end(), [origin](Vec2 a, Vec2 b) {
        return demlua::norm(a - origin) < demlua::norm(b - origin);
    });
    CHECK(demlua::norm(*nearest - origin) < 1e-12);
}

TEST_CASE("a wedge of 60 degrees has rows of 1, 2, 3 and so on", "[packing]") {
    const double radius = 0.01;
    constexpr int rows = 12;
    // the triangle around that many rows of disks, standing on its tip: its sides lie R outside the lattice
    const double height = (rows - 1) * sqrt3 * radius + 3.0 * radius;
    const Region wedge = Region::polygon({{0.0, 0.0}, {height / sqrt3, height}, {-height / sqrt3, height}});
    const Packing packing = close_packed(wedge, radius, Rows::horizontal, Fit::inside, Vec2{0.0, 2.0 * radius});
    const std::vector<int> counts = row_counts(packing, &Vec2::y);
    REQUIRE(counts.size() == rows);
    for (int k = 0; k < rows; ++k) CHECK(counts[static_cast<std::size_t>(k)] == k + 1);
}

TEST_CASE("a lattice that does not fit is empty, one without end is refused", "[packing]") {
    CHECK(close_packed(Region::disc({0.0, 0.0}, 1.0), 1.1, Rows::horizontal, Fit::inside, std::nullopt).centre.empty());
    CHECK(close_packed(Region(), 1.0, Rows::horizontal, Fit::centres, std::nullopt).centre.empty());
    const Region half = Region::half_plane({0.0, 0.0}, {0.0, 1.0});
    CHECK_THROWS_AS(close_packed(half, 1.0, Rows::horizontal, Fit::centres, std::nullopt), demlua::RunError);
}

TEST_CASE("a lattice runs on over the seam of a union", "[packing]") {
    const Region whole = Region::rectangle({0.0, 0.0}, {1.0, 1.0});
    const Region halves =
        Region::rectangle({0.0, 0.0}, {0.37, 1.0}).united(Region::rectangle({0.37, 0.0}, {0.63, 1.0}));
    const Packing one = close_packed(whole, 0.02, Rows::horizontal, Fit::inside, std::nullopt);
    const Packing two = close_packed(halves, 0.02, Rows::horizontal, Fit::inside, std::nullopt);
    CHECK(one.centre.size() == two.centre.size());
}

// --- consolidated packs -----------------------------------------------------------------------------------

TEST_CASE("a consolidated pack has the count, the size and the solid fraction asked for", "[packing]") {
    const Region beam = Region::rectangle({0.0, 0.0}, {1.5, 0.25});
    const Consolidation settings = settings_for(2998, 3, 0.82, 1);
    const Packing packing = consolidated(beam, settings);
    check_pack(packing, beam, settings, 3000);
    check_clusters(packing, 3, 3);
    const Overlaps found = overlaps(packing, beam);
    CHECK(found.pairs < 0.1);
    CHECK(found.walls < 0.1);

    // Contact bonds: surfaces within a tenth of a radius. Six neighbours would be a crystal.
    const std::vector<int> near = neighbours(packing, 2.1 * packing.radius.front());
    const double coordination = std::accumulate(near.begin(), near.end(), 0.0) / static_cast<double>(near.size());
    CHECK(coordination > 4.3);
    CHECK(coordination < 4.9);
    const auto ordered = std::count_if(near.begin(), near.end(), [](int n) { return n >= 6; });
    CHECK(static_cast<double>(ordered) < 0.3 * static_cast<double>(near.size()));
}

TEST_CASE("a consolidated pack is dense right up to its walls", "[packing]") {
    const double length = 1.5;
    const double height = 0.25;
    const Region beam = Region::rectangle({0.0, 0.0}, {length, height});
    const Packing packing = consolidated(beam, settings_for(3000, 3, 0.82, 1));
    const double strip = 2.0 * packing.radius.front();
    const double inside = solid_fraction(packing, length, 3.0 * strip, height - 3.0 * strip);
    const double bottom = solid_fraction(packing, length, 0.0, strip);
    const double top = solid_fraction(packing, length, height - strip, height);
    // No disk reaches across a wall, so even an unbroken row of touching disks fills only pi/4 = 0.785 of the
    // strip next to it. Measured: 0.74 to 0.80 beside 0.82 inside.
    CHECK(bottom > 0.85 * inside);
    CHECK(top > 0.85 * inside);
    CHECK(solid_fraction(packing, length, strip, 2.0 * strip) == Approx(inside).epsilon(0.05));
    // and along the beam
    for (int k = 0; k < 5; ++k) {
        const auto here = std::count_if(packing.centre.begin(), packing.centre.end(), [&](Vec2 p) {
            return p.x >= 0.2 * k * length && p.x < 0.2 * (k + 1) * length;
        });
        CHECK(static_cast<double>(here) == Approx(600.0).epsilon(0.05));
    }
}

TEST_CASE("the same seed gives the same pack, another seed another", "[packing]") {
    const Region beam = Region::rectangle({0.0, 0.0}, {0.3, 0.1});
    const Packing first = consolidated(beam, settings_for(300, 3, 0.8, 7));
    const Packing again = consolidated(beam, settings_for(300, 3, 0.8, 7));
    const Packing other = consolidated(beam, settings_for(300, 3, 0.8, 8));
    CHECK(first.centre == again.centre);
    CHECK(first.cluster == again.cluster);
    CHECK_FALSE(first.centre == other.centre);
}

TEST_CASE("elements near each other have near numbers", "[packing]") {
    const Packing packing = consolidated(Region::rectangle({0.0, 0.0}, {0.2, 1.0}), settings_for(1500, 3, 0.8, 1));
    const double band = 4.0 * packing.radius.front();
    for (std::size_t k = 1; k < packing.centre.size(); ++k) {
        CHECK(packing.centre[k].y > packing.centre[k - 1].y - band);
    }
}

TEST_CASE("consolidated packs fit regions of any shape", "[packing]") {
    const Region disc = Region::disc({0.2, -0.1}, 0.5);
    const Region ring = disc.without(Region::disc({0.2, -0.1}, 0.25));
    const Region angle = Region::polygon({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}});
    const Region joined = Region::rectangle({0.0, 0.0}, {2.0, 1.0}).united(Region::rectangle({0.0, 1.0}, {1.0, 1.0}));
    const Region notched =
        Region::rectangle({0.0, 0.0}, {2.0, 1.0}).without(Region::rectangle({0.999, 0.0}, {0.002, 0.5}));
    for (const Region& region : {disc, ring, angle, joined, notched, angle.rotated(0.4, {0.0, 0.0})}) {
        const Consolidation settings = settings_for(900, 3, 0.79, 3);
        const Packing packing = consolidated(region, settings);
        check_pack(packing, region, settings, 900);
        CHECK(overlaps(packing, region).pairs < 0.05);
        CHECK(overlaps(packing, region).walls < 0.05);
    }
}

TEST_CASE("no cluster lies across a slit, however thin", "[packing]") {
    const Region slit = Region::rectangle({0.99999, -0.1}, {0.00002, 0.7});
    const Region body = Region::rectangle({0.0, 0.0}, {2.0, 1.0}).without(slit);
    const Packing packing = consolidated(body, settings_for(600, 3, 0.8, 1));
    std::vector<int> side(packing.centre.size() / 3, 0); // -1 left of the slit, 1 right of it, 0 not seen beside it
    for (std::size_t k = 0; k < packing.centre.size(); ++k) {
        if (packing.centre[k].y > 0.6) continue;
        const int here = packing.centre[k].x < 1.0 ? -1 : 1;
        int& seen = side[packing.cluster[k]];
        CHECK(seen * here >= 0);
        seen = here;
    }
}

TEST_CASE("consolidated packs are made of clusters of five kinds", "[packing]") {
    struct Kind {
        int size;
        int touching;
        double solid_fraction;
    };
    const Region region = Region::rectangle({0.0, 0.0}, {2.0, 1.0});
    for (const Kind kind : {Kind{1, 0, 0.82}, Kind{2, 1, 0.82}, Kind{3, 3, 0.8}, Kind{4, 5, 0.77}, Kind{7, 12, 0.74}}) {
        const Packing packing = consolidated(region, settings_for(840, kind.size, kind.solid_fraction, 1));
        CHECK(packing.centre.size() == 840);
        check_clusters(packing, static_cast<std::size_t>(kind.size), kind.touching);
        CHECK(overlaps(packing, region).pairs < 0.05);
        CHECK(overlaps(packing, region).walls < 0.05);
    }
    CHECK_THROWS_AS(consolidated(region, settings_for(100, 5, 0.5, 1)), demlua::RunError);
}

TEST_CASE("consolidated packs go down to one cluster", "[packing]") {
    const Region square = Region::rectangle({0.0, 0.0}, {1.0, 1.0});
    for (const std::size_t count : {1U, 3U, 4U, 7U, 12U, 30U}) {
        const Packing packing = consolidated(square, settings_for(count, 3, 0.5, 2));
        CHECK(packing.centre.size() == (count + 2) / 3 * 3);
        CHECK(overlaps(packing, square).pairs < 0.05);
        CHECK(overlaps(packing, square).walls < 0.05);
    }
    const Packing single = consolidated(square, settings_for(1, 1, 0.78, 1));
    REQUIRE(single.centre.size() == 1);
    CHECK(single.centre.front().x == Approx(0.5).margin(0.02));
}

TEST_CASE("a radius decides how many elements a consolidated pack has", "[packing]") {
    const Region square = Region::rectangle({0.0, 0.0}, {1.0, 1.0});
    Consolidation settings = settings_for(0, 3, 0.78, 1);
    settings.radius = 0.02;
    const Packing packing = consolidated(square, settings);
    CHECK(packing.centre.size() == static_cast<std::size_t>(0.78 / (pi * 0.02 * 0.02)) / 3 * 3);
    CHECK(packing.radius.front() == 0.02);
    CHECK(consolidated_radius(square, settings) == 0.02);
    settings.radius = 0.3; // less than one cluster
    CHECK(consolidated(square, settings).centre.empty());
    CHECK(consolidated(Region(), settings_for(30, 3, 0.8, 1)).centre.empty());
}

TEST_CASE("a solid fraction out of reach is refused with what does fit", "[packing]") {
    const Region square = Region::rectangle({0.0, 0.0}, {1.0, 1.0});
    CHECK_THROWS_WITH(consolidated(square, settings_for(600, 3, 0.95, 1)),
                      Catch::Matchers::ContainsSubstring("lower solid_fraction"));
    CHECK_THROWS_AS(consolidated(Region::half_plane({0.0, 0.0}, {0.0, 1.0}), settings_for(30, 3, 0.8, 1)),
                    demlua::RunError);
}
