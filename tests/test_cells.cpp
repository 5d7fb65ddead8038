// Cells of elements: lattices against their closed forms, random packs against what any tiling of a region keeps.
#include "engine/base/random.hpp"
#include "engine/packing/cells.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

namespace {

using Catch::Approx;
using demlua::cross;
using demlua::dot;
using demlua::norm;
using demlua::Vec2;
using demlua::model::Region;
using demlua::packing::Cells;
using demlua::packing::cells_of;
using demlua::packing::Facet;
using std::numbers::pi;
using std::numbers::sqrt3;

struct Elements {
    std::vector<Vec2> centre;
    std::vector<double> radius;
};

/// `count` elements anywhere in `region`, their radii up to `spread` above `radius`.
Elements scattered(const Region& region, std::size_t count, double radius, double spread, std::uint64_t seed) {
    Elements made;
    const demlua::Box box = region.bounds();
    for (std::uint64_t k = 0; made.centre.size() < count; ++k) {
        const Vec2 share{demlua::uniform(seed, 0, k), demlua::uniform(seed, 1, k)};
        const Vec2 point = box.lower + Vec2{share.x * box.size().x, share.y * box.size().y};
        if (!region.contains(point)) continue;
        made.centre.push_back(point);
        made.radius.push_back(radius * (1.0 + spread * demlua::uniform(seed, 2, k)));
    }
    return made;
}

struct Example {
    std::string name;
    Region region;
    double area; ///< m^2, by hand
};

std::vector<Example> examples() {
    const Region angle = Region::polygon({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}});
    const Region disc = Region::disc({0.3, -0.2}, 0.8);
    const Region slab = Region::rectangle({-1.0, 0.0}, {2.0, 1.0});
    return {{"rectangle", slab, 2.0},
            {"disc", disc, 0.64 * pi},
            {"annulus", disc.without(Region::disc({0.3, -0.2}, 0.5)), 0.39 * pi},
            {"L", angle, 3.0},
            {"turned L", angle.rotated(0.7, {0.1, 0.2}).translated({10.0, -20.0}), 3.0},
            {"triangle", Region::polygon({{0.0, 0.0}, {1.0, 0.2}, {0.3, 0.9}}), 0.42},
            {"plate with holes",
             slab.without(Region::disc({-0.5, 0.5}, 0.2)).without(Region::rectangle({0.3, 0.4}, {0.2, 0.3})),
             2.0 - 0.04 * pi - 0.06},
            {"slit slab", slab.without(Region::rectangle({-0.001, 0.0}, {0.002, 0.5})), 1.999},
            {"half disc", Region::disc({0.0, 0.0}, 0.5).intersected(slab), 0.125 * pi},
            {"two parts", slab.without(Region::rectangle({0.2, -1.0}, {0.3, 3.0})), 1.7}};
}

double total(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

Vec2 middle(const Facet& facet) { return 0.5 * (facet.from + facet.to); }

/// Across the facet, from i to j, times its length.
Vec2 length_normal(const Facet& facet) { return -turned_left(facet.to - facet.from); }

bool ends_inside(const Facet& facet) { return facet.outward_from == Vec2{} && facet.outward_to == Vec2{}; }

/// Sums over each cell's facets, outward normals n: of A n, and of A n (x_m - x_i)^T.
struct Identities {
    std::vector<Vec2> closure;
    std::vector<Vec2> along_x; ///< first row: A n_x (x_m - x_i)
    std::vector<Vec2> along_y;
    std::vector<bool> interior;
};

Identities identities(const Elements& elements, const Cells& cells, const Region& region) {
    const std::size_t count = elements.centre.size();
    Identities sums{std::vector<Vec2>(count), std::vector<Vec2>(count), std::vector<Vec2>(count),
                    std::vector<bool>(count, true)};
    std::vector<double> reach(count, 0.0);
    for (const Facet& facet : cells.facets) {
        for (const auto& [k, sign] : {std::pair{facet.i, 1.0}, std::pair{facet.j, -1.0}}) {
            const Vec2 normal = sign * length_normal(facet);
            const Vec2 arm = middle(facet) - elements.centre[k];
            sums.closure[k] += normal;
            sums.along_x[k] += normal.x * arm;
            sums.along_y[k] += normal.y * arm;
            if (!ends_inside(facet)) sums.interior[k] = false;
            for (const Vec2 end : {facet.from, facet.to}) {
                reach[k] = std::max(reach[k], norm(end - elements.centre[k]));
            }
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (region.distance(elements.centre[k]) > -reach[k]) sums.interior[k] = false;
        if (cells.area[k] == 0.0) sums.interior[k] = false;
    }
    return sums;
}

/// What must hold for any elements in any region.
void check_cells(const Elements& elements, const Cells& cells, const Region& region) {
    const double size = norm(region.bounds().size());
    const double rounding = 1e-12 * size;
    REQUIRE(cells.area.size() == elements.centre.size());
    REQUIRE(cells.centroid.size() == elements.centre.size());
    CHECK(*std::min_element(cells.area.begin(), cells.area.end()) >= 0.0);
    const auto in_order = [](const Facet& a, const Facet& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; };
    CHECK(std::is_sorted(cells.facets.begin(), cells.facets.end(), in_order));
    CHECK(std::adjacent_find(cells.facets.begin(), cells.facets.end(), [](const Facet& a, const Facet& b) {
              return a.i == b.i && a.j == b.j;
          }) == cells.facets.end());
    double largest_tilt = 0.0;
    double largest_difference = 0.0;
    double largest_distance = 0.0;
    for (const Facet& facet : cells.facets) {
        REQUIRE(facet.i < facet.j);
        const Vec2 between = elements.centre[facet.j] - elements.centre[facet.i];
        const Vec2 along = facet.to - facet.from;
        REQUIRE(cross(between, along) > 0.0); // turned_left(n) points from `from` to `to`
        largest_tilt = std::max(largest_tilt, std::abs(dot(between, along)) / norm(between));
        for (const Vec2 end : {facet.from, facet.to}) {
            const auto power = [&](std::size_t k) {
                const Vec2 arm = end - elements.centre[k];
                return dot(arm, arm) - elements.radius[k] * elements.radius[k];
            };
            largest_difference =
                std::max(largest_difference, std::abs(power(facet.i) - power(facet.j)) / norm(between));
            REQUIRE(region.distance(end) <= rounding);
        }
        for (const auto& [end, outward] :
             {std::pair{facet.from, facet.outward_from}, std::pair{facet.to, facet.outward_to}}) {
            if (outward == Vec2{}) continue;
            largest_distance = std::max(largest_distance, std::abs(region.distance(end)));
            CHECK(norm(outward) == Approx(1.0).epsilon(1e-12));
        }
    }
    CHECK(largest_tilt <= rounding);
    CHECK(largest_difference <= rounding);
    CHECK(largest_distance <= rounding);
}

void check_identities(const Elements& elements, const Cells& cells, const Region& region) {
    const Identities sums = identities(elements, cells, region);
    const double size = norm(region.bounds().size());
    double gap = 0.0;
    double error = 0.0;
    int interior = 0;
    for (std::size_t k = 0; k < elements.centre.size(); ++k) {
        if (!sums.interior[k]) continue;
        ++interior;
        gap = std::max(gap, norm(sums.closure[k]));
        error = std::max({error, norm(sums.along_x[k] - Vec2{cells.area[k], 0.0}),
                          norm(sums.along_y[k] - Vec2{0.0, cells.area[k]})});
    }
    CHECK(gap <= 1e-12 * size);
    CHECK(error <= 1e-12 * size * size);
    CHECK(interior > 0);
}

/// First moment of a region from its boundary alone: of a rectangle, a disc and so on, summed by hand.
Vec2 first_moment(const Cells& cells) {
    Vec2 sum;
    for (std::size_t k = 0; k < cells.area.size(); ++k) sum += cells.area[k] * cells.centroid[k];
    return sum;
}

} // namespace

TEST_CASE("cells of a square lattice are squares", "[cells]") {
    constexpr int side = 7;
    Elements elements;
    for (int k = 0; k < side * side; ++k) {
        const int row = k / side;
        elements.centre.push_back({k % side + 0.5, row + 0.5});
        elements.radius.push_back(0.5);
    }
    const Region region = Region::rectangle({0.0, 0.0}, {7.0, 7.0});
    const Cells cells = cells_of(elements.centre, elements.radius, region);
    check_cells(elements, cells, region);
    CHECK(cells.facets.size() == 2 * side * (side - 1)); // none across the corners
    for (const Facet& facet : cells.facets) CHECK(norm(facet.to - facet.from) == Approx(1.0).epsilon(1e-12));
    for (std::size_t k = 0; k < elements.centre.size(); ++k) {
        CHECK(cells.area[k] == Approx(1.0).epsilon(1e-12));
        CHECK(norm(cells.centroid[k] - elements.centre[k]) < 1e-12);
    }
}

TEST_CASE("elements on the boundary have half cells, in its corners quarter cells", "[cells]") {
    constexpr int side = 6;
    Elements elements;
    for (int k = 0; k < side * side; ++k) {
        const int row = k / side;
        elements.centre.push_back({double(k % side), double(row)});
        elements.radius.push_back(0.5);
    }
    const Region square = Region::rectangle({0.0, 0.0}, {5.0, 5.0});
    for (const double angle : {0.0, 0.3}) {
        const Region region = square.rotated(angle, {0.0, 0.0});
        Elements turned = elements;
        for (Vec2& p : turned.centre) p = demlua::turned(p, angle);
        const Cells cells = cells_of(turned.centre, turned.radius, region);
        check_cells(turned, cells, region);
        CHECK(cells.facets.size() == 2 * side * (side - 1));
        for (int k = 0; k < side * side; ++k) {
            const double width = k % side == 0 || k % side == side - 1 ? 0.5 : 1.0;
            const double height = k / side == 0 || k / side == side - 1 ? 0.5 : 1.0;
            CHECK(cells.area[static_cast<std::size_t>(k)] == Approx(width * height).epsilon(1e-12));
        }
        CHECK(norm(cells.centroid.front() - demlua::turned({0.25, 0.25}, angle)) < 1e-12);
    }
}

TEST_CASE("cells of a hexagonal lattice are hexagons", "[cells]") {
    constexpr double radius = 0.5;
    Elements elements;
    for (int row = 0; row < 12; ++row) {
        for (int place = 0; place < 12; ++place) {
            elements.centre.push_back({place + (row % 2 == 0 ? 0.0 : 0.5), 0.5 * sqrt3 * row});
            elements.radius.push_back(radius);
        }
    }
    const Region region = Region::rectangle({-0.5, -0.5}, {12.5, 11.0 * 0.5 * sqrt3 + 1.0});
    const Cells cells = cells_of(elements.centre, elements.radius, region);
    check_cells(elements, cells, region);
    check_identities(elements, cells, region);
    const auto deep = [&](std::size_t k) { return region.distance(elements.centre[k]) <= -1.2; };
    for (const Facet& facet : cells.facets) {
        if (deep(facet.i) || deep(facet.j))
            CHECK(norm(facet.to - facet.from) == Approx(2.0 * radius / sqrt3).epsilon(1e-12));
    }
    std::vector<int> sides(elements.centre.size(), 0);
    for (const Facet& facet : cells.facets) {
        ++sides[facet.i];
        ++sides[facet.j];
    }
    for (std::size_t k = 0; k < elements.centre.size(); ++k) {
        if (!deep(k)) continue;
        CHECK(sides[k] == 6);
        CHECK(cells.area[k] == Approx(2.0 * sqrt3 * radius * radius).epsilon(1e-12));
        CHECK(norm(cells.centroid[k] - elements.centre[k]) < 1e-12);
    }
}

TEST_CASE("cells share out any region", "[cells]") {
    for (const Example& example : examples()) {
        INFO(example.name);
        for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{7}, std::size_t{1500}}) {
            const double spacing = std::sqrt(example.area / static_cast<double>(count));
            for (const double spread : {0.0, 0.5, 3.0}) {
                const Elements elements = scattered(example.region, count, 0.5 * spacing, spread, count + 5);
                const Cells cells = cells_of(elements.centre, elements.radius, example.region);
                INFO(count << " elements, radii up to " << spread << " larger");
                check_cells(elements, cells, example.region);
                CHECK(total(cells.area) == Approx(example.area).epsilon(1e-12));
                if (count == 1500) check_identities(elements, cells, example.region);
            }
        }
    }
}

TEST_CASE("every point belongs to the element with the least power", "[cells]") {
    const Region region = Region::disc({0.0, 0.0}, 1.0).without(Region::rectangle({0.0, 0.0}, {2.0, 2.0}));
    const Elements elements = scattered(region, 40, 0.1, 1.0, 3);
    const Cells cells = cells_of(elements.centre, elements.radius, region);
    std::vector<double> hits(elements.centre.size(), 0.0);
    constexpr int across = 1000;
    for (int k = 0; k < across * across; ++k) {
        const int row = k / across;
        const Vec2 point{2.0 * (k % across + 0.5) / across - 1.0, 2.0 * (row + 0.5) / across - 1.0};
        const bool in_quarter = point.x >= 0.0 && point.y >= 0.0;
        if (norm(point) > 1.0 || in_quarter) continue;
        std::size_t owner = 0;
        double least = 1e300;
        for (std::size_t n = 0; n < elements.centre.size(); ++n) {
            const Vec2 arm = point - elements.centre[n];
            const double power = dot(arm, arm) - elements.radius[n] * elements.radius[n];
            if (power >= least) continue;
            least = power;
            owner = n;
        }
        hits[owner] += 4.0 / (across * across);
    }
    // A counted area is off by less than half its outline, at most 2 m here, times the diagonal of a grid cell.
    for (std::size_t n = 0; n < hits.size(); ++n) CHECK(std::abs(hits[n] - cells.area[n]) < 2.0 * 2.0 / across);
}

TEST_CASE("first moments of cells add up to the region's", "[cells]") {
    const Region disc = Region::disc({2.0, 3.0}, 0.8);
    const Region ring = disc.without(Region::disc({2.2, 3.0}, 0.5));
    const Vec2 of_ring = 0.64 * pi * Vec2{2.0, 3.0} - 0.25 * pi * Vec2{2.2, 3.0};
    const Region cap = Region::disc({0.0, 0.0}, 1.0).intersected(Region::rectangle({-1.0, 0.0}, {2.0, 2.0}));
    for (const std::size_t count : {std::size_t{1}, std::size_t{3}, std::size_t{700}}) {
        const auto moment = [count](const Region& region) {
            const Elements elements = scattered(region, count, 0.01, 0.5, 11);
            return first_moment(cells_of(elements.centre, elements.radius, region));
        };
        CHECK(norm(moment(disc) - 0.64 * pi * Vec2{2.0, 3.0}) < 1e-11);
        CHECK(norm(moment(ring) - of_ring) < 1e-11);
        CHECK(norm(moment(cap) - Vec2{0.0, 2.0 / 3.0}) < 1e-11); // half disc: 4/(3 pi) above its base
    }
}

TEST_CASE("facets that end on a disc's wall know the way out", "[cells]") {
    const Vec2 centre{0.4, -0.1};
    for (const bool hollow : {false, true}) {
        const Region disc = Region::disc(centre, 1.0);
        const Region region = hollow ? disc.without(Region::disc(centre, 0.4)) : disc;
        const Elements elements = scattered(region, 600, 0.03, 0.0, 2);
        const Cells cells = cells_of(elements.centre, elements.radius, region);
        int on_wall = 0;
        for (const Facet& facet : cells.facets) {
            for (const auto& [end, outward] :
                 {std::pair{facet.from, facet.outward_from}, std::pair{facet.to, facet.outward_to}}) {
                const Vec2 arm = end - centre;
                const bool outer = std::abs(norm(arm) - 1.0) < 1e-12;
                const bool inner = hollow && std::abs(norm(arm) - 0.4) < 1e-12;
                CHECK((outer || inner) == !(outward == Vec2{}));
                if (outer) CHECK(norm(outward - arm) < 1e-11);
                if (inner) CHECK(norm(outward + arm / 0.4) < 1e-11);
                if (outer || inner) ++on_wall;
            }
        }
        CHECK(on_wall > 50);
    }
}

TEST_CASE("hidden elements have no cell, elements in one place share none", "[cells]") {
    const Region region = Region::rectangle({0.0, 0.0}, {4.0, 2.0});
    const Cells hidden = cells_of({{1.0, 1.0}, {1.2, 1.0}, {3.0, 1.0}}, {0.9, 0.1, 0.5}, region);
    CHECK(hidden.area[1] == 0.0);
    CHECK(hidden.centroid[1] == Vec2{1.2, 1.0});
    REQUIRE(hidden.facets.size() == 1);
    CHECK((hidden.facets[0].i == 0 && hidden.facets[0].j == 2));
    // x^2 - 2 x + 1 - 0.81 = x^2 - 6 x + 9 - 0.25 at x = 8.56/4
    CHECK(hidden.area[0] == Approx(2.0 * 2.14).epsilon(1e-12));
    const Cells twins = cells_of({{1.0, 1.0}, {1.0, 1.0}}, {0.5, 0.5}, region);
    CHECK(twins.area[0] == Approx(8.0));
    CHECK(twins.area[1] == 0.0);
}
