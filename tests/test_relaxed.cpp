// Relaxed packs against what was asked for: how many, how large, where.
#include "engine/base/problems.hpp"
#include "engine/packing/boundary_row.hpp"
#include "engine/packing/cells.hpp"
#include "engine/packing/packing.hpp"
#include "tests/catch.hpp"
#include "tests/scene_language.hpp"

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
using demlua::Index;
using demlua::norm;
using demlua::Vec2;
using demlua::model::Region;
using demlua::model::Relaxation;
using demlua::model::Spacing;
using demlua::packing::boundary_row;
using demlua::packing::Cells;
using demlua::packing::cells_of;
using demlua::packing::consolidated;
using demlua::packing::Facet;
using demlua::packing::Packing;
using demlua::packing::relaxed;
using demlua::packing::relaxed_radius;
using std::numbers::pi;
using std::numbers::sqrt3;

Relaxation with_count(std::size_t count, bool on_boundary) {
    Relaxation settings;
    settings.count = count;
    settings.on_boundary = on_boundary;
    return settings;
}

Region beam() { return Region::rectangle({0.0, 0.0}, {1.5, 0.25}); }
Region disc() { return Region::disc({0.2, -0.1}, 0.5); }
Region ring() { return disc().without(Region::disc({0.2, -0.1}, 0.25)); }

std::vector<Region> regions() {
    const Region angle = Region::polygon({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}});
    const Region slab = Region::rectangle({0.0, 0.0}, {2.0, 1.0});
    return {beam(),
            disc(),
            ring(),
            angle,
            angle.rotated(0.4, {0.0, 0.0}).translated({20.0, -30.0}),
            slab.without(Region::rectangle({0.999, 0.0}, {0.002, 0.5})),
            slab.without(Region::rectangle({0.8, -1.0}, {0.3, 3.0}))};
}

/// Distance of neighbours in a lattice with cells of this area.
double distance_for(double area) { return std::sqrt(2.0 * area / sqrt3); }

bool on_boundary(const Packing& pack, std::size_t k, const Region& region) {
    return std::abs(region.distance(pack.centre[k])) <= 1e-12 * pack.radius[k];
}

void check_pack(const Packing& pack, const Region& region) {
    const std::size_t count = pack.centre.size();
    REQUIRE(pack.radius.size() == count);
    REQUIRE(pack.cell_area.size() == count);
    REQUIRE(pack.cluster.size() == count);
    CHECK(std::accumulate(pack.cell_area.begin(), pack.cell_area.end(), 0.0) == Approx(region.area()).epsilon(1e-12));
    const Cells cells = cells_of(pack.centre, pack.radius, region);
    CHECK(cells.area == pack.cell_area);
    for (std::size_t k = 0; k < count; ++k) {
        REQUIRE(pack.cluster[k] == k);
        REQUIRE(region.contains(pack.centre[k]));
        REQUIRE(pack.cell_area[k] > 0.0);
        if (on_boundary(pack, k, region)) continue;
        REQUIRE(pack.radius[k] <= -region.distance(pack.centre[k]) * (1.0 + 1e-12));
    }
}

/// Sizes of elements inside over those asked for.
std::vector<double> relative_sizes(const Packing& pack, const Region& region, const Spacing& size) {
    std::vector<double> found;
    for (std::size_t k = 0; k < pack.centre.size(); ++k) {
        if (on_boundary(pack, k, region)) continue;
        found.push_back(distance_for(pack.cell_area[k]) / size(pack.centre[k]));
    }
    std::sort(found.begin(), found.end());
    return found;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The area shared out by the function asked for: integral of dA / (sqrt(3)/2 h^2), midpoint rule.
double expected_count(const Region& region, const Spacing& size) {
    const demlua::Box box = region.bounds();
    constexpr int across = 1000;
    const Vec2 step = box.size() / double{across};
    double sum = 0.0;
    for (int row = 0; row < across; ++row) {
        for (int column = 0; column < across; ++column) {
            const Vec2 point = box.lower + Vec2{(column + 0.5) * step.x, (row + 0.5) * step.y};
            if (region.contains(point)) sum += step.x * step.y / (0.5 * sqrt3 * size(point) * size(point));
        }
    }
    return sum;
}

} // namespace

TEST_CASE("a relaxed pack fills any region with as many elements as were asked for", "[relaxed]") {
    for (const Region& region : regions()) {
        for (const bool row : {false, true}) {
            for (const std::size_t count : {std::size_t{40}, std::size_t{700}}) {
                const Packing pack = relaxed(region, with_count(count, row));
                CHECK(pack.centre.size() == count);
                check_pack(pack, region);
            }
        }
    }
}

TEST_CASE("cells of a relaxed pack are even", "[relaxed]") {
    const double size = distance_for(0.375 / 3000.0);
    const Packing pack = relaxed(beam(), with_count(3000, false));
    const std::vector<double> sizes = relative_sizes(pack, beam(), [size](Vec2 /*p*/) { return size; });
    CHECK(mean(sizes) == Approx(1.0).margin(0.01));
    // 15 % either way, but for a few in corners and where lattices of different directions meet
    CHECK(sizes[sizes.size() / 100] > 0.85);
    CHECK(sizes[sizes.size() - 1 - sizes.size() / 100] < 1.15);
    // Lloyd's method lowers the sum of second moments of cells; the hexagonal lattice, 5/(18 sqrt(3)) area^2, is the
    // least there is (Fejes Toth 1959), Poisson points have 1.5 times as much and more.
    double moment = 0.0;
    const Cells cells = cells_of(pack.centre, std::vector<double>(pack.centre.size(), 0.0), beam());
    for (const Facet& facet : cells.facets) { // triangles from the centres to a facet, both sides alike
        const double width = norm(facet.to - facet.from);
        const Vec2 between = pack.centre[facet.j] - pack.centre[facet.i];
        const double height = 0.5 * norm(between);
        const Vec2 middle = 0.5 * (facet.from + facet.to) - pack.centre[facet.i];
        const double offset = cross(between, middle) / norm(between);
        moment += width * height * (0.5 * height * height + 0.5 * offset * offset + width * width / 24.0);
    }
    const double cell = 0.375 / 3000.0;
    const double least = 3000.0 * 5.0 / (18.0 * sqrt3) * cell * cell;
    CHECK(moment < 1.05 * least);
}

TEST_CASE("spacing and size are met from place to place", "[relaxed]") {
    Relaxation equal;
    equal.spacing = 0.02;
    struct Graded {
        Region region;
        Spacing size;
    };
    const std::vector<Graded> examples{
        {beam(), [](Vec2) { return 0.012; }},
        {beam(), [](Vec2 p) { return 0.004 + 0.012 * p.y / 0.25; }},                   // 4x across the section
        {beam(), [](Vec2 p) { return 0.003 * std::exp(std::log(16.0) * p.x / 1.5); }}, // 16x along
        {ring(), [](Vec2 p) {
             return std::max(0.006, 0.03 - 0.1 * (0.5 - norm(p - Vec2{0.2, -0.1})));
         }}};
    for (const Graded& example : examples) {
        for (const bool row : {false, true}) {
            Relaxation settings;
            settings.size = example.size;
            settings.on_boundary = row;
            const Packing pack = relaxed(example.region, settings);
            check_pack(pack, example.region);
            const std::vector<double> sizes = relative_sizes(pack, example.region, example.size);
            CHECK(mean(sizes) == Approx(1.0).margin(0.02));
            CHECK(sizes[sizes.size() / 100] > 0.85);
            CHECK(sizes[sizes.size() - 1 - sizes.size() / 100] < 1.15);
            const auto row_count = static_cast<double>(pack.centre.size() - sizes.size());
            const double full_cells = static_cast<double>(sizes.size()) + 0.5 * row_count;
            CHECK(full_cells == Approx(expected_count(example.region, example.size)).epsilon(0.02));
            CHECK((row_count > 0.0) == row);

            std::vector<double> ratios;
            for (const Facet& facet : cells_of(pack.centre, pack.radius, example.region).facets) {
                const double ratio = pack.radius[facet.i] / pack.radius[facet.j];
                ratios.push_back(std::max(ratio, 1.0 / ratio));
            }
            std::sort(ratios.begin(), ratios.end());
            CHECK(ratios[ratios.size() - 1 - ratios.size() / 100] < 1.35);
        }
    }
}

TEST_CASE("a row on the boundary stands on it, in every corner, at even distances", "[relaxed]") {
    const Spacing size = [](Vec2 /*p*/) { return 0.05; };
    const auto has = [](const std::vector<Vec2>& places, Vec2 point) {
        return std::any_of(places.begin(), places.end(), [point](Vec2 p) { return norm(p - point) < 1e-14; });
    };
    const std::vector<Vec2> corners{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}};
    const std::vector<Vec2> angle = boundary_row(Region::polygon(corners), size, 1);
    CHECK(angle.size() == 160); // 8 m in steps of 0.05 m
    for (const Vec2 corner : corners) CHECK(has(angle, corner));
    for (std::size_t k = 0; k < angle.size(); ++k) {
        CHECK(norm(angle[(k + 1) % angle.size()] - angle[k]) == Approx(0.05));
    }

    const std::vector<Vec2> circle = boundary_row(disc(), size, 1);
    CHECK(circle.size() == 63); // pi / 0.05
    for (std::size_t k = 0; k < circle.size(); ++k) {
        CHECK(norm(circle[k] - Vec2{0.2, -0.1}) == Approx(0.5).epsilon(1e-14));
        CHECK(norm(circle[(k + 1) % circle.size()] - circle[k]) == Approx(2.0 * 0.5 * std::sin(pi / 63.0)));
    }
    CHECK(boundary_row(ring(), size, 1).size() == 63 + 31);

    const Region half = disc().intersected(Region::rectangle({-1.0, -0.1}, {3.0, 2.0}));
    const std::vector<Vec2> of_half = boundary_row(half, size, 1);
    CHECK(of_half.size() == 20 + 31);
    CHECK((has(of_half, {-0.3, -0.1}) && has(of_half, {0.7, -0.1})));

    // a slot with round ends has no corner: 2 m straight and 0.2 pi m round
    const Region slot = Region::rectangle({0.0, 0.0}, {1.0, 0.2})
                            .united(Region::disc({0.0, 0.1}, 0.1))
                            .united(Region::disc({1.0, 0.1}, 0.1));
    CHECK(boundary_row(slot, size, 1).size() == 53);

    // growing from 0.02 to 0.1 along an edge: the integral of dx / (0.02 + 0.08 x) is 12.5 ln 5 = 20.1
    const Spacing growing = [](Vec2 p) { return 0.02 + 0.08 * p.x; };
    const std::vector<Vec2> square = boundary_row(Region::rectangle({0.0, 0.0}, {1.0, 1.0}), growing, 1);
    CHECK(square.size() == 20 + 10 + 20 + 50);
    std::vector<double> along;
    for (const Vec2 p : square) {
        if (p.y == 0.0) along.push_back(p.x);
    }
    std::sort(along.begin(), along.end());
    REQUIRE(along.size() == 21);
    for (std::size_t k = 0; k <= 20; ++k) { // x where the integral is k/20 of the whole; trapezoids of a quarter step
        CHECK(along[k] == Approx(0.25 * (std::pow(5.0, static_cast<double>(k) / 20.0) - 1.0)).margin(1e-3));
    }
}

TEST_CASE("elements of a pack stand on the boundary exactly, with half cells", "[relaxed]") {
    for (const Region& region : {beam(), disc(), ring(), beam().rotated(0.3, {1.0, 2.0})}) {
        const Packing pack = relaxed(region, with_count(600, true));
        check_pack(pack, region);
        std::vector<double> row;
        std::vector<double> inside;
        double row_radius = 0.0;
        for (std::size_t k = 0; k < pack.centre.size(); ++k) {
            const double distance = region.distance(pack.centre[k]);
            if (on_boundary(pack, k, region)) {
                row.push_back(pack.cell_area[k]);
                row_radius += pack.radius[k];
            } else {
                CHECK(distance < -pack.radius[k]);
                inside.push_back(pack.cell_area[k]);
            }
        }
        CHECK(row.size() > 60);
        CHECK(mean(row) == Approx(0.5 * mean(inside)).epsilon(0.15));
        // between two elements of the row the boundary passes from one cell to the next once
        const Cells cells = cells_of(pack.centre, pack.radius, region);
        const auto crossings = std::count_if(cells.facets.begin(), cells.facets.end(), [](const Facet& facet) {
            return !(facet.outward_from == Vec2{}) || !(facet.outward_to == Vec2{});
        });
        CHECK(static_cast<std::size_t>(crossings) == row.size());
        const double full_radius = std::sqrt(mean(inside) / (2.0 * sqrt3));
        CHECK(row_radius / static_cast<double>(row.size()) == Approx(full_radius).epsilon(0.05));
        CHECK(relaxed_radius(region, with_count(600, true)) == Approx(full_radius).epsilon(0.03));
    }
}

TEST_CASE("the same seed gives the same relaxed pack, another seed another", "[relaxed]") {
    for (const bool row : {false, true}) {
        Relaxation settings = with_count(300, row);
        settings.seed = 7;
        const Packing first = relaxed(ring(), settings);
        const Packing again = relaxed(ring(), settings);
        settings.seed = 8;
        const Packing other = relaxed(ring(), settings);
        CHECK(first.centre == again.centre);
        CHECK(first.radius == again.radius);
        CHECK_FALSE(first.centre == other.centre);
    }
}

TEST_CASE("neighbours in a relaxed pack have near numbers", "[relaxed]") {
    const Packing pack = relaxed(Region::rectangle({0.0, 0.0}, {0.2, 1.0}), with_count(1500, false));
    const double band = 4.0 * mean(pack.radius);
    for (std::size_t k = 1; k < pack.centre.size(); ++k) CHECK(pack.centre[k].y > pack.centre[k - 1].y - band);
}

TEST_CASE("packs that cannot be are refused or empty", "[relaxed]") {
    CHECK(relaxed(Region(), with_count(10, false)).centre.empty());
    CHECK_THROWS_AS(relaxed(Region::half_plane({0.0, 0.0}, {0.0, 1.0}), with_count(10, false)), demlua::RunError);
    Relaxation dust;
    dust.spacing = 1e-5;
    CHECK_THROWS_AS(relaxed(beam(), dust), demlua::RunError);
    Relaxation dusty;
    dusty.size = [](Vec2 p) { return p.y == 0.0 ? 1e-9 : 0.01; };
    dusty.on_boundary = true;
    CHECK_THROWS_AS(relaxed(beam(), dusty), demlua::RunError);
    CHECK(relaxed(beam(), with_count(1, false)).centre.size() == 1);
    CHECK(relaxed(disc(), with_count(2, false)).centre.size() == 2);
    Relaxation raw = with_count(500, false);
    raw.steps = 0;
    check_pack(relaxed(ring(), raw), ring());
}

TEST_CASE("Lloyd steps make a consolidated pack even", "[relaxed]") {
    demlua::model::Consolidation settings;
    settings.count = 1200;
    const Packing pressed = consolidated(beam(), settings);
    settings.relax = 4;
    const Packing even = consolidated(beam(), settings);
    REQUIRE(even.centre.size() == pressed.centre.size());
    CHECK(even.radius == pressed.radius);
    const auto scatter = [](const Packing& pack) {
        const std::vector<double> areas = cells_of(pack.centre, pack.radius, beam()).area;
        double sum = 0.0;
        for (const double area : areas) sum += (area / mean(areas) - 1.0) * (area / mean(areas) - 1.0);
        return std::sqrt(sum / static_cast<double>(areas.size()));
    };
    CHECK(scatter(even) < 0.75 * scatter(pressed));
    for (const Vec2 p : even.centre) CHECK(beam().contains(p));
}

TEST_CASE("packs are as dense at their walls as inside", "[relaxed]") {
    demlua::model::Consolidation pressed;
    pressed.count = 1500;
    demlua::model::Consolidation evened = pressed;
    evened.relax = 4;
    for (const Region& region : {beam(), ring()}) {
        struct Example {
            std::string name;
            Packing pack;
        };
        for (const Example& example : {Example{"consolidated", consolidated(region, pressed)},
                                       Example{"consolidated, relaxed", consolidated(region, evened)},
                                       Example{"relaxed", relaxed(region, with_count(1500, false))}}) {
            INFO(example.name);
            const Packing& pack = example.pack;
            const std::vector<double> areas = cells_of(pack.centre, pack.radius, region).area;
            const double diameter = 2.0 * mean(pack.radius);
            std::vector<double> at_wall;
            std::vector<double> inside;
            for (std::size_t k = 0; k < areas.size(); ++k) {
                const double depth = -region.distance(pack.centre[k]);
                if (depth < diameter) at_wall.push_back(areas[k]);
                if (depth > 3.0 * diameter) inside.push_back(areas[k]);
            }
            // The rows of a lattice along a wall have cells of (2 + sqrt(3))/(2 sqrt(3)) = 1.08 of the others, since the
            // first stands a radius off the wall and not half a row.
            CHECK(mean(at_wall) == Approx(mean(inside)).epsilon(0.1));
        }
    }
}

TEST_CASE("a scene says how large elements are from place to place", "[relaxed]") {
    using namespace demlua::test;
    const std::string text = rock + R"(
local sim = dem.simulation {}
local body = sim:body { name = "plate", material = rock, region = dem.rectangle { size = { 1, 1 } },
                        packing = dem.relaxed { SIZE, on_boundary = true } }
dem.result { radius = body.radius }
sim:run { duration = 1e-6 }
)";
    const auto scene = [&text](const std::string& size) {
        std::string made = text;
        return made.replace(made.find("SIZE"), 4, size);
    };
    BareHost host;
    run(scene("size = function(x, y) return 0.03 + 0.06 * x end"), host);
    // the integral of dx / (sqrt(3)/2 h^2) is (1/0.03 - 1/0.09) / 0.06 / (sqrt(3)/2)
    const double cells = (1.0 / 0.03 - 1.0 / 0.09) / 0.06 / (0.5 * sqrt3);
    CHECK(host.number("radius") == Approx(std::sqrt(1.0 / cells / (2.0 * sqrt3))).epsilon(0.02));
    CHECK(static_cast<double>(host.simulation()->element_count()) == Approx(cells + 0.5 * 73.0).epsilon(0.03));

    // where nobody looked before the run
    CHECK(problems_of([&] {
              BareHost other;
              run(scene("size = function(x, y) return x < 0.9 and 0.1 or -1 end"), other);
          }) == std::vector<std::string>{scene_name + ":6: relaxed.size = -1: must return a positive number"});
}
