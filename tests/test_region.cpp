// Regions: areas, distances and boxes against closed forms; no seam or hidden edge of a combination is felt.
#include "engine/base/random.hpp"
#include "engine/model/region.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace {

using Catch::Approx;
using demlua::Box;
using demlua::Vec2;
using demlua::model::Boundary;
using demlua::model::Region;
using std::numbers::pi;

constexpr double infinity = std::numeric_limits<double>::infinity();

Region unit_disc() { return Region::disc({0.0, 0.0}, 1.0); }
Region unit_square() { return Region::rectangle({0.0, 0.0}, {1.0, 1.0}); }

/// Area common to two unit discs with centres `gap` apart.
double lens_area(double gap) { return 2.0 * std::acos(0.5 * gap) - 0.5 * gap * std::sqrt(4.0 - gap * gap); }

/// Five arms, ten corners, every other one re-entrant.
Region star() {
    std::vector<Vec2> corners(10);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        corners[k] = demlua::turned({k % 2 == 0 ? 1.0 : 0.4, 0.0}, 0.2 * pi * static_cast<double>(k));
    }
    return Region::polygon(corners);
}

/// Share of a box that lies in the region, by points spread at random.
double sampled_area(const Region& region, const Box& box, std::uint64_t samples) {
    std::uint64_t inside = 0;
    for (std::uint64_t k = 0; k < samples; ++k) {
        const Vec2 share{demlua::uniform(5, 0, k), demlua::uniform(5, 1, k)};
        const Vec2 size = box.size();
        if (region.contains(box.lower + Vec2{share.x * size.x, share.y * size.y})) ++inside;
    }
    return box.size().x * box.size().y * static_cast<double>(inside) / static_cast<double>(samples);
}

void check_box(const Region& region, Vec2 lower, Vec2 upper) {
    const Box box = region.bounds();
    CHECK(box.lower.x == Approx(lower.x).margin(1e-12));
    CHECK(box.lower.y == Approx(lower.y).margin(1e-12));
    CHECK(box.upper.x == Approx(upper.x).margin(1e-12));
    CHECK(box.upper.y == Approx(upper.y).margin(1e-12));
}

} // namespace

TEST_CASE("areas of single shapes", "[region]") {
    CHECK(Region::rectangle({-3.0, 7.0}, {2.0, 0.5}).area() == Approx(1.0).epsilon(1e-14));
    CHECK(Region::disc({4.0, -1.0}, 2.0).area() == Approx(4.0 * pi).epsilon(1e-14));
    const double triangle = star().area() / 10.0; // two sides of 1 and 0.4 with 36 degrees between them
    CHECK(triangle == Approx(0.5 * 0.4 * std::sin(0.2 * pi)).epsilon(1e-14));
    CHECK(Region::polygon({{0.0, 0.0}, {0.0, 2.0}, {1.0, 0.0}}).area() == Approx(1.0)); // clockwise
    CHECK(Region().area() == 0.0);
    CHECK(Region::half_plane({0.0, 0.0}, {1.0, 2.0}).area() == infinity);
}

TEST_CASE("areas of combinations", "[region]") {
    const Region disc = unit_disc();
    for (const double gap : {0.3, 1.0, 1.9}) {
        const Region other = disc.translated({0.6 * gap, 0.8 * gap});
        const double lens = lens_area(gap);
        CHECK(disc.intersected(other).area() == Approx(lens).epsilon(1e-12));
        CHECK(disc.united(other).area() == Approx(2.0 * pi - lens).epsilon(1e-12));
        CHECK(disc.without(other).area() == Approx(pi - lens).epsilon(1e-12));
    }
    const Region ring = disc.without(Region::disc({0.0, 0.0}, 0.5));
    CHECK(ring.area() == Approx(0.75 * pi).epsilon(1e-14));
    CHECK(disc.intersected(Region::half_plane({0.0, 0.0}, {1.0, 3.0})).area() == Approx(0.5 * pi).epsilon(1e-14));
    CHECK(disc.without(Region::disc({0.5, 0.0}, 0.5)).area() == Approx(0.75 * pi)); // touching from inside
    CHECK(disc.united(Region::disc({2.0, 0.0}, 1.0)).area() == Approx(2.0 * pi));   // and from outside
}

TEST_CASE("areas of shapes that share edges or all of themselves", "[region]") {
    const Region disc = unit_disc();
    CHECK(disc.united(disc).area() == Approx(pi));
    CHECK(disc.intersected(disc).area() == Approx(pi));
    CHECK(disc.without(disc).area() == 0.0);
    CHECK(disc.united(Region()).area() == Approx(pi));
    const Region square = unit_square();
    const Region next = square.translated({1.0, 0.5});
    CHECK(square.united(next).area() == Approx(2.0).epsilon(1e-14));
    CHECK(square.intersected(next).area() == 0.0);
    CHECK(square.without(next).area() == Approx(1.0).epsilon(1e-14));
    CHECK(square.without(Region::rectangle({0.25, 0.0}, {0.5, 0.75})).area() == Approx(0.625).epsilon(1e-14));
}

TEST_CASE("an area does not change when the region is moved and turned", "[region]") {
    const Region shape = star().without(Region::disc({0.3, 0.1}, 0.25)).united(Region::disc({0.8, 0.2}, 0.3));
    const Region moved = shape.rotated(0.7, {3.0, -2.0}).translated({10.0, 5.0});
    CHECK(moved.area() == Approx(shape.area()).epsilon(1e-12));
    const Region turned_first = star().rotated(0.4, {0.0, 0.0}).intersected(unit_square().rotated(0.4, {0.0, 0.0}));
    CHECK(turned_first.area() == Approx(star().intersected(unit_square()).area()).epsilon(1e-12));
    const double sampled = sampled_area(shape, shape.bounds(), 200000);
    CHECK(shape.area() == Approx(sampled).epsilon(0.01));
}

TEST_CASE("boxes are tight", "[region]") {
    check_box(unit_square().rotated(0.25 * pi, {0.0, 0.0}), {-std::sqrt(0.5), 0.0}, {std::sqrt(0.5), std::sqrt(2.0)});
    check_box(unit_disc().intersected(unit_disc().translated({1.0, 0.0})), {0.0, -std::sqrt(0.75)},
              {1.0, std::sqrt(0.75)});
    check_box(unit_disc().without(Region::rectangle({0.0, -2.0}, {2.0, 4.0})), {-1.0, -1.0}, {0.0, 1.0});
    CHECK(Region().bounds().empty());
    CHECK(unit_disc().without(unit_disc()).bounds().empty());
}

TEST_CASE("boxes of unbounded regions are open on the right sides", "[region]") {
    const Box below = Region::half_plane({0.0, 2.0}, {0.0, 3.0}).bounds();
    CHECK((below.lower.x == -infinity && below.lower.y == -infinity && below.upper.x == infinity));
    CHECK(below.upper.y == 2.0);
    const Region strip = Region::half_plane({0.0, 1.0}, {0.0, 1.0}).without(Region::half_plane({0.0, 0.0}, {0.0, 1.0}));
    CHECK((strip.bounds().lower.y == 0.0 && strip.bounds().upper.y == 1.0));
    CHECK((strip.bounds().lower.x == -infinity && strip.bounds().upper.x == infinity));
    const Region outside = Region::half_plane({0.0, 0.0}, {0.0, 1.0})
                               .united(Region::half_plane({0.0, 0.0}, {0.0, -1.0}))
                               .without(unit_disc());
    CHECK((outside.bounds().lower.y == -infinity && outside.area() == infinity));
    CHECK(outside.distance({0.0, 0.0}) == Approx(1.0));
    const Region triangle = Region::half_plane({0.0, 0.0}, {0.0, -1.0})
                                .intersected(Region::half_plane({1.0, 0.0}, {1.0, 1.0}))
                                .intersected(Region::half_plane({-1.0, 0.0}, {-1.0, 1.0}));
    check_box(triangle, {-1.0, 0.0}, {1.0, 1.0});
    CHECK(triangle.area() == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("distances to single shapes", "[region]") {
    const Region square = unit_square();
    CHECK(square.distance({0.5, 0.4}) == Approx(-0.4));
    CHECK(square.distance({0.5, -0.4}) == Approx(0.4));
    CHECK(square.distance({4.0, 5.0}) == Approx(5.0));
    CHECK(unit_disc().distance({0.3, 0.4}) == Approx(-0.5));
    CHECK(unit_disc().distance({3.0, 4.0}) == Approx(4.0));
    CHECK(unit_disc().distance({0.0, 0.0}) == Approx(-1.0));
    CHECK(Region::half_plane({0.0, 1.0}, {0.0, 5.0}).distance({7.0, 3.0}) == Approx(2.0));
    CHECK(star().distance({1.5, 0.0}) == Approx(0.5));
    CHECK(Region().distance({0.0, 0.0}) == infinity);
}

TEST_CASE("distances know the true boundary of a combination", "[region]") {
    const Region seam = unit_square().united(Region::rectangle({1.0, 0.0}, {1.0, 1.0}));
    CHECK(seam.distance({1.0, 0.5}) == Approx(-0.5));
    // 0.1 + 0.2 is not 0.3: a gap of one rounding is no gap
    const Region narrow =
        Region::rectangle({0.0, 0.0}, {1.0, 0.3}).united(Region::rectangle({0.0, 0.1 + 0.2}, {1.0, 1.0}));
    CHECK(narrow.distance({0.5, 0.3}) == Approx(-0.3));
    const Region corner = Region::rectangle({0.0, 0.0}, {2.0, 1.0}).united(Region::rectangle({0.0, 0.0}, {1.0, 2.0}));
    CHECK(corner.distance({0.9, 0.9}) == Approx(-0.1 * std::sqrt(2.0)));
    const Region lens = unit_disc().intersected(unit_disc().translated({1.0, 0.0}));
    CHECK(lens.distance({0.5, 2.0}) == Approx(2.0 - std::sqrt(0.75)));
    const Region ring = unit_disc().without(Region::disc({0.0, 0.0}, 0.5));
    CHECK(ring.distance({0.0, 0.0}) == Approx(0.5));
    CHECK(ring.distance({0.0, 0.7}) == Approx(-0.2));
}

TEST_CASE("a seam bounds nothing when the union is cut or cuts", "[region]") {
    const Region seam = unit_square().united(Region::rectangle({1.0, 0.0}, {1.0, 1.0}));
    const Region disc = Region::disc({1.0, 0.5}, 0.25);
    CHECK(seam.without(disc).area() == Approx(2.0 - pi / 16.0).epsilon(1e-12));
    CHECK(seam.without(disc).distance({1.0, 0.5}) == Approx(0.25));
    CHECK(seam.intersected(disc).area() == Approx(pi / 16.0).epsilon(1e-12));
    const Region frame = Region::rectangle({-1.0, -1.0}, {4.0, 3.0}).without(seam);
    CHECK(frame.area() == Approx(10.0).epsilon(1e-12));
    CHECK(frame.distance({1.0, 0.5}) == Approx(0.5));
    CHECK_FALSE(frame.contains({1.0, 0.5}));
    CHECK(frame.contains({1.0, 0.0}));
}

TEST_CASE("the boundary belongs to the region, wherever it lies", "[region]") {
    const Region tilted = unit_square().rotated(0.3, {5.0, -3.0});
    const Vec2 about{5.0, -3.0};
    for (int k = 0; k <= 10; ++k) {
        const Vec2 edge = about + demlua::turned(Vec2{0.1 * k, 0.0} - about, 0.3);
        CHECK(tilted.contains(edge));
        CHECK(unit_disc().contains({std::cos(0.6 * k), std::sin(0.6 * k)}));
    }
    const Region triangle = Region::polygon({{0.1, 0.2}, {1.3, 0.5}, {0.4, 1.7}});
    for (int k = 0; k <= 10; ++k) {
        CHECK(triangle.contains(0.1 * k * Vec2{0.1, 0.2} + (1.0 - 0.1 * k) * Vec2{1.3, 0.5}));
    }
    CHECK_FALSE(triangle.contains({0.1, 0.2 - 1e-9}));
    CHECK(unit_square().without(unit_disc()).contains({1.0, 0.0}));
}

TEST_CASE("outward is the direction of growing distance", "[region]") {
    const std::vector<Region> regions{unit_disc(), star(), unit_square().rotated(0.3, {0.0, 0.0}),
                                      star().without(Region::disc({0.3, 0.1}, 0.25)),
                                      unit_disc().united(unit_square())};
    constexpr double h = 1e-6;
    for (const Region& region : regions) {
        int near_ridges = 0; // where two walls are equally near the slope is not defined
        for (std::uint64_t k = 0; k < 500; ++k) {
            const Vec2 p{3.0 * demlua::uniform(1, 0, k) - 1.5, 3.0 * demlua::uniform(1, 1, k) - 1.5};
            const Vec2 slope{(region.distance({p.x + h, p.y}) - region.distance({p.x - h, p.y})) / (2.0 * h),
                             (region.distance({p.x, p.y + h}) - region.distance({p.x, p.y - h})) / (2.0 * h)};
            const Vec2 outward = region.outward(p);
            CHECK(demlua::norm(outward) == Approx(1.0));
            if (demlua::norm(slope - outward) > 1e-3) ++near_ridges;
        }
        CHECK(near_ridges <= 2);
    }
    CHECK(unit_square().outward({0.5, 0.0}).y == Approx(-1.0)); // on the boundary itself
    const Vec2 into_hole = unit_disc().without(Region::disc({0.0, 0.0}, 0.5)).outward({0.5, 0.0});
    CHECK(into_hole.x == Approx(-1.0));
}

TEST_CASE("a disk in a corner meets two walls, at a re-entrant corner and beside a slit one", "[region]") {
    std::vector<Boundary> walls;
    unit_square().walls_near({0.1, 0.2}, 0.3, walls);
    REQUIRE(walls.size() == 2);
    CHECK(walls[0].distance == Approx(-0.1));
    CHECK(walls[0].outward.x == Approx(-1.0));
    CHECK(walls[1].distance == Approx(-0.2));
    CHECK(walls[1].outward.y == Approx(-1.0));
    unit_square().walls_near({0.5, 0.5}, 0.3, walls);
    CHECK(walls.empty());
    unit_square().walls_near({0.5, -0.1}, 0.3, walls);
    REQUIRE(walls.size() == 1);
    CHECK(walls[0].distance == Approx(0.1));
    unit_square().without(Region::rectangle({0.5, 0.5}, {1.0, 1.0})).walls_near({0.4, 0.4}, 0.3, walls);
    REQUIRE(walls.size() == 1);
    CHECK(walls[0].distance == Approx(-0.1 * std::sqrt(2.0)));
    unit_square().without(Region::rectangle({0.5, -1.0}, {0.01, 2.5})).walls_near({0.45, 0.5}, 0.2, walls);
    REQUIRE(walls.size() == 1);
    CHECK(walls[0].outward.x == Approx(1.0));
}

TEST_CASE("copies share and nothing changes what it was made from", "[region]") {
    const Region disc = unit_disc();
    const Region moved = disc.translated({5.0, 0.0});
    CHECK(disc.contains({0.0, 0.0}));
    CHECK_FALSE(moved.contains({0.0, 0.0}));
    CHECK(moved.contains({5.0, 0.0}));
}
