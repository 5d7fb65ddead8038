// Grains: what each way of putting them down promises, shape and sizes as asked, errors that say what was reached.
#include "engine/base/cell_grid.hpp"
#include "engine/base/problems.hpp"
#include "engine/packing/disk_union.hpp"
#include "engine/packing/grains.hpp"
#include "engine/packing/pack_store.hpp"
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
using Catch::Matchers::ContainsSubstring;
using demlua::CellGrid;
using demlua::Index;
using demlua::RunError;
using demlua::Vec2;
using demlua::model::Disk;
using demlua::model::GrainPacking;
using demlua::model::Placing;
using demlua::model::Region;
using demlua::packing::grains;
using demlua::packing::Packing;

const Region box = Region::rectangle({-0.2, 0.1}, {1.5, 1.0});
const Region pierced = box.without(Region::disc({0.3, 0.5}, 0.2));

GrainPacking asked(Placing method, int elements, double least, double greatest) {
    GrainPacking settings;
    settings.method = method;
    settings.elements = elements;
    settings.sizes = {{least, greatest, 1.0}};
    return settings;
}

GrainPacking asked(Placing method, int elements, double least, double greatest, double porosity) {
    GrainPacking settings = asked(method, elements, least, greatest);
    settings.porosity = porosity;
    return settings;
}

double greatest_radius(const Packing& pack) { return *std::max_element(pack.radius.begin(), pack.radius.end()); }

std::vector<std::vector<Disk>> grains_of(const Packing& pack) {
    std::vector<std::vector<Disk>> found;
    for (std::size_t k = 0; k < pack.centre.size(); ++k) {
        REQUIRE(pack.cluster[k] <= found.size());
        if (pack.cluster[k] == found.size()) found.emplace_back();
        REQUIRE(pack.cluster[k] + 1 == found.size()); // elements of a grain stand in a row
        found.back().push_back({pack.centre[k], pack.radius[k]});
    }
    return found;
}

/// 1 - the areas of the grains, each the exact union of its disks, over the region's.
double porosity(const Packing& pack, const Region& region) {
    double covered = 0.0;
    for (const std::vector<Disk>& grain : grains_of(pack)) covered += demlua::packing::union_of(grain).area;
    CHECK(std::accumulate(pack.cell_area.begin(), pack.cell_area.end(), 0.0) == Approx(covered).epsilon(1e-12));
    return 1.0 - covered / region.area();
}

/// Half of the largest grain, over the region: how near a whole number of grains comes to a porosity.
double half_a_grain(const Packing& pack, const Region& region) {
    double largest = 0.0;
    for (const std::vector<Disk>& grain : grains_of(pack)) {
        largest = std::max(largest, demlua::packing::union_of(grain).area);
    }
    return 0.5 * largest / region.area() + 1e-12;
}

/// How far the disk that does so most reaches out of the region, in its radii.
double sticks_out(const Packing& pack, const Region& region) {
    double most = -1.0;
    for (std::size_t k = 0; k < pack.centre.size(); ++k) {
        most = std::max(most, 1.0 + region.distance(pack.centre[k]) / pack.radius[k]);
    }
    return most;
}

/// Calls `f(i, j, gap)` for elements of different grains less than `reach` (m) apart; gaps are in radii of the smaller.
template <class F>
void for_each_meeting(const Packing& pack, double reach, const F& f) {
    const double far = 2.0 * greatest_radius(pack) + reach;
    CellGrid grid;
    grid.build(pack.centre, far);
    grid.for_each_pair(far, [&](Index i, Index j) {
        if (pack.cluster[i] == pack.cluster[j]) return;
        const double gap = norm(pack.centre[i] - pack.centre[j]) - pack.radius[i] - pack.radius[j];
        if (gap < reach) f(i, j, gap / std::min(pack.radius[i], pack.radius[j]));
    });
}

double deepest_overlap(const Packing& pack) {
    double deepest = 0.0;
    for_each_meeting(pack, 0.0, [&](Index, Index, double gap) { deepest = std::max(deepest, -gap); });
    return deepest;
}

std::string error_of(const Region& region, const GrainPacking& settings) {
    try {
        grains(region, settings);
    } catch (const RunError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("consolidated grains fill their region to the porosity asked for", "[grains]") {
    struct Case {
        Region region;
        int elements;
        double ratio; ///< of the largest to the smallest
        double porosity;
    };
    const std::vector<Case> cases{{box, 1, 2.0, 0.19}, {pierced, 3, 1.6, 0.24}, {box, 7, 1.0, 0.28}};
    for (const Case& each : cases) {
        const GrainPacking settings =
            asked(Placing::consolidation, each.elements, 0.02, 0.02 * each.ratio, each.porosity);
        const Packing pack = grains(each.region, settings);
        // Sizes are spread as evenly as may be, so that only the number of grains is rounded.
        CHECK(std::abs(porosity(pack, each.region) - each.porosity) < half_a_grain(pack, each.region));
        CHECK(deepest_overlap(pack) < 0.1);
        CHECK(sticks_out(pack, each.region) < 0.1);
    }
}

TEST_CASE("inserted grains overlap nothing", "[grains]") {
    for (const int elements : {1, 2, 4}) {
        const Packing pack = grains(pierced, asked(Placing::insertion, elements, 0.015, 0.03, 0.6));
        CHECK(std::abs(porosity(pack, pierced) - 0.6) < half_a_grain(pack, pierced));
        CHECK(deepest_overlap(pack) == 0.0);
        CHECK(sticks_out(pack, pierced) < 1e-12);
    }
    GrainPacking some = asked(Placing::insertion, 3, 0.01, 0.02);
    some.count = 57;
    CHECK(grains_of(grains(box, some)).size() == 57);
}

TEST_CASE("rained grains lie on others, on the floor or between walls", "[grains]") {
    const Region hopper = Region::polygon({{0.0, 1.0}, {0.4, 0.3}, {0.4, 0.0}, {0.6, 0.0}, {0.6, 0.3}, {1.0, 1.0}});
    struct Case {
        Region region;
        int elements;
        double ratio;
    };
    const std::vector<Case> cases{{box, 1, 1.0}, {box, 1, 2.5}, {pierced, 3, 1.5}, {hopper, 2, 1.5}};
    for (const Case& each : cases) {
        const Packing pack = grains(each.region, asked(Placing::rain, each.elements, 0.015, 0.015 * each.ratio));
        // Pushing apart stops below 0.001 of the smallest radius, and may leave two neighbours that much each.
        CHECK(deepest_overlap(pack) < 2e-3);
        CHECK(sticks_out(pack, each.region) < 2e-3);

        // The last step down is 2e-4 of the smallest radius; what it meets is nearer than that, along its way and across.
        const double near = 2e-3 * 0.015;
        const std::vector<std::vector<Disk>> put = grains_of(pack);
        std::vector<int> held(put.size(), 0);
        for_each_meeting(pack, near, [&](Index i, Index j, double) {
            ++held[pack.cluster[i]];
            ++held[pack.cluster[j]];
        });
        std::vector<demlua::model::Boundary> walls;
        for (std::size_t k = 0; k < pack.centre.size(); ++k) {
            each.region.walls_near(pack.centre[k], pack.radius[k] + near, walls);
            for (const demlua::model::Boundary& wall : walls) {
                if (wall.distance > -pack.radius[k] - near) held[pack.cluster[k]] += wall.outward.y < -0.999 ? 2 : 1;
            }
        }
        CHECK(std::count_if(held.begin(), held.end(), [](int n) { return n < 2; }) == 0);
    }
}

TEST_CASE("rain stops at the porosity or number asked for", "[grains]") {
    const Packing half = grains(box, asked(Placing::rain, 1, 0.015, 0.03, 0.6));
    CHECK(std::abs(porosity(half, box) - 0.6) < half_a_grain(half, box));
    const double highest =
        std::max_element(half.centre.begin(), half.centre.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; })->y;
    CHECK(highest < 0.9); // of 1.1: it lies at the bottom
    GrainPacking few = asked(Placing::rain, 3, 0.02, 0.02);
    few.count = 31;
    CHECK(grains_of(grains(box, few)).size() == 31);
}

TEST_CASE("a disk rained between two others lies where it touches both", "[grains]") {
    // In a slot 3 radii wide disks zigzag: each touches a wall and the one below, which is higher by sqrt(3) R.
    const double R = 0.01;
    const Packing pack = grains(Region::rectangle({0.0, 0.0}, {3.0 * R, 0.2}), asked(Placing::rain, 1, R, R));
    REQUIRE(pack.centre.size() > 8);
    std::vector<Vec2> at = pack.centre;
    std::sort(at.begin(), at.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
    // The first may stop anywhere on the floor; those above it are driven to the walls.
    for (std::size_t k = 3; k < at.size(); ++k) {
        CHECK(at[k].y - at[k - 1].y == Approx(std::numbers::sqrt3 * R).epsilon(5e-3));
        CHECK(std::min(at[k].x, 3.0 * R - at[k].x) == Approx(R).epsilon(5e-3));
    }
}

TEST_CASE("grains keep the shape of their cluster", "[grains]") {
    GrainPacking listed = asked(Placing::consolidation, 1, 0.02, 0.035, 0.3);
    listed.disks = {{{10.0, 4.0}, 2.0}, {{12.5, 4.0}, 1.0}, {{11.0, 6.0}, 1.5}};
    for (const Placing method : {Placing::consolidation, Placing::insertion, Placing::rain}) {
        listed.method = method;
        listed.porosity = method == Placing::insertion ? 0.6 : 0.35;
        for (const std::vector<Disk>& grain : grains_of(grains(pierced, listed))) {
            REQUIRE(grain.size() == 3);
            const double unit = (grain[0].radius + grain[1].radius + grain[2].radius) / 4.5; // as the list adds up
            CHECK(3.0 * 0.02 / 4.5 <= unit * (1.0 + 1e-12));
            CHECK(unit <= 3.0 * 0.035 / 4.5 * (1.0 + 1e-12));
            for (std::size_t a = 0; a < 3; ++a) {
                CHECK(grain[a].radius == Approx(unit * listed.disks[a].radius).epsilon(1e-12));
                const std::size_t b = (a + 1) % 3;
                CHECK(norm(grain[a].centre - grain[b].centre) ==
                      Approx(unit * norm(listed.disks[a].centre - listed.disks[b].centre)).epsilon(1e-12));
            }
            // Not a mirror image.
            CHECK(cross(grain[1].centre - grain[0].centre, grain[2].centre - grain[0].centre) ==
                  Approx(unit * unit * 5.0).epsilon(1e-9));
        }
    }
}

TEST_CASE("sizes of grains are spread as asked for", "[grains]") {
    const double a = 0.01;
    const double b = 0.02;
    for (const Placing method : {Placing::insertion, Placing::rain}) {
        const Packing pack = grains(box, asked(method, 1, a, b, 0.5));
        const auto n = static_cast<double>(pack.radius.size());
        double sum = 0.0;
        double squares = 0.0;
        for (const double r : pack.radius) {
            sum += r;
            squares += r * r;
            CHECK((a <= r && r <= b));
        }
        // Four standard errors of the mean and of the mean square of a uniform spread.
        CHECK(std::abs(sum / n - 0.5 * (a + b)) < 4.0 * (b - a) / std::sqrt(12.0 * n));
        CHECK(std::abs(squares / n - (a * a + a * b + b * b) / 3.0) < 4.0 * (b - a) * (a + b) / std::sqrt(12.0 * n));
    }
    GrainPacking classes = asked(Placing::insertion, 1, 0.01, 0.01);
    classes.sizes = {{0.01, 0.01, 3.0}, {0.02, 0.02, 1.0}};
    classes.count = 400;
    const Packing pack = grains(box, classes);
    CHECK(std::count(pack.radius.begin(), pack.radius.end(), 0.01) == 300);
    CHECK(std::count(pack.radius.begin(), pack.radius.end(), 0.02) == 100);
    CHECK(demlua::packing::mean_radius(classes) == Approx(0.0125));
}

TEST_CASE("angles of grains are spread evenly", "[grains]") {
    GrainPacking pairs = asked(Placing::insertion, 2, 0.005, 0.005);
    pairs.count = 1000;
    Vec2 sum; // of (cos 2a, sin 2a), whose mean has a standard error of 1/sqrt(2 n) along each axis
    for (const std::vector<Disk>& grain : grains_of(grains(box, pairs))) {
        const Vec2 axis = (grain[1].centre - grain[0].centre) / norm(grain[1].centre - grain[0].centre);
        sum += Vec2{axis.x * axis.x - axis.y * axis.y, 2.0 * axis.x * axis.y};
    }
    CHECK(norm(sum / 1000.0) < 4.0 / std::sqrt(2000.0));
}

TEST_CASE("the same seed gives the same grains", "[grains]") {
    for (const Placing method : {Placing::consolidation, Placing::insertion, Placing::rain}) {
        GrainPacking settings = asked(method, 3, 0.02, 0.03, 0.6);
        const Packing pack = grains(pierced, settings);
        CHECK(grains(pierced, settings).centre == pack.centre);
        settings.seed = 2;
        CHECK_FALSE(grains(pierced, settings).centre == pack.centre);
    }
}

TEST_CASE("grains are taken away whole", "[grains]") {
    GrainPacking settings = asked(Placing::consolidation, 3, 0.02, 0.02, 0.3);
    const Packing whole = grains(box, settings);
    settings.removed = 0.25;
    const Packing rest = grains(box, settings);
    const std::size_t count = grains_of(whole).size();
    const auto gone = static_cast<std::size_t>(std::llround(0.25 * static_cast<double>(count)));
    CHECK(grains_of(rest).size() == count - gone);
    for (const Vec2 at : rest.centre)
        CHECK(std::find(whole.centre.begin(), whole.centre.end(), at) != whole.centre.end());

    const Packing thin = demlua::packing::thinned(whole, 0.5, 1);
    CHECK(thin.centre.size() ==
          whole.centre.size() - static_cast<std::size_t>(std::llround(0.5 * static_cast<double>(whole.centre.size()))));
    CHECK(*std::max_element(thin.cluster.begin(), thin.cluster.end()) < count);
}

TEST_CASE("a porosity that cannot be had is refused, saying what was reached", "[grains]") {
    CHECK_THAT(error_of(box, asked(Placing::consolidation, 3, 0.04, 0.04, 0.05)),
               ContainsSubstring("consolidated grains: at porosity 0.0") && ContainsSubstring("can be reached"));
    CHECK_THAT(error_of(box, asked(Placing::insertion, 1, 0.04, 0.04, 0.3)),
               ContainsSubstring("inserted grains: no place found for grain") && ContainsSubstring("at porosity 0."));
    CHECK_THAT(error_of(box, asked(Placing::rain, 1, 0.02, 0.03, 0.05)),
               ContainsSubstring("rained grains: the region is full at porosity 0.2") &&
                   ContainsSubstring("0.05 was asked for"));
    GrainPacking many = asked(Placing::rain, 1, 0.02, 0.02);
    many.count = 10000;
    CHECK_THAT(error_of(box, many), ContainsSubstring("of 10000 grains; ask for fewer"));
    CHECK(grains(Region::rectangle({0.0, 0.0}, {0.03, 0.03}), asked(Placing::rain, 1, 0.02, 0.02)).centre.empty());
}

TEST_CASE("whatever grains follow from tells them from others in the store", "[grains]") {
    const auto key = [](auto change) {
        GrainPacking settings = asked(Placing::consolidation, 3, 0.02, 0.02, 0.3);
        change(settings);
        return demlua::packing::inputs_of(box, settings);
    };
    const auto same = key([](GrainPacking&) {});
    REQUIRE(same);
    CHECK(key([](GrainPacking&) {}) == same);
    CHECK_FALSE(key([](GrainPacking& s) { s.elements = 4; }) == same);
    CHECK_FALSE(key([](GrainPacking& s) { s.disks = {{{0.0, 0.0}, 1.0}}; }) == same);
    CHECK_FALSE(key([](GrainPacking& s) { s.sizes.front().greatest = 0.021; }) == same);
    CHECK_FALSE(key([](GrainPacking& s) { s.sizes.push_back({0.02, 0.02, 1.0}); }) == same);
    CHECK_FALSE(key([](GrainPacking& s) { s.method = Placing::rain; }) == same);
    CHECK_FALSE(key([](GrainPacking& s) { s.porosity = 0.31; }) == same);
    CHECK_FALSE(key([](GrainPacking& s) { s.count = 5; }) == same);
    CHECK_FALSE(key([](GrainPacking& s) { s.removed = 0.1; }) == same);
    CHECK_FALSE(key([](GrainPacking& s) { s.seed = 2; }) == same);
}
