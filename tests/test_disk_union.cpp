// What disks cover together: against closed forms of mensuration, and against a sum over fine strips.
#include "engine/packing/disk_union.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace {

using Catch::Approx;
using demlua::Vec2;
using demlua::model::Disk;
using demlua::packing::Lamina;
using demlua::packing::union_of;
using std::numbers::pi;

double disk_area(double radius) { return pi * radius * radius; }
double disk_polar(double radius) { return pi * std::pow(radius, 4) / 2.0; }

/// What lies beyond a chord at `distance` from the middle of a disk about the origin, on the side of +x.
struct Segment {
    double area;
    double first;  ///< integral of x
    double second; ///< integral of x^2 + y^2
};

/// Elementary integrals of 2 sqrt(R^2 - x^2) {1, x, x^2 + (R^2 - x^2)/3} from `distance` to R, with x = R cos(t).
Segment segment(double radius, double distance) {
    const double t = std::acos(distance / radius);
    const double sine = std::sin(t);
    const double area = radius * radius * (t - sine * std::cos(t));
    const double r4 = std::pow(radius, 4);
    const double xx = r4 / 4.0 * (t - std::sin(4.0 * t) / 4.0); // 2 R^4 int cos^2 sin^2
    const double yy = r4 / 3.0 * 2.0 * (3.0 * t / 8.0 - std::sin(2.0 * t) / 4.0 + std::sin(4.0 * t) / 32.0);
    return {area, 2.0 / 3.0 * std::pow(radius * sine, 3), xx + yy};
}

/// Lengths and moments of the union along lines of constant y, summed by the midpoint rule.
Lamina by_strips(const std::vector<Disk>& disks, std::size_t strips) {
    double low = disks.front().centre.y;
    double high = low;
    for (const Disk& disk : disks) {
        low = std::min(low, disk.centre.y - disk.radius);
        high = std::max(high, disk.centre.y + disk.radius);
    }
    const double step = (high - low) / static_cast<double>(strips);
    double area = 0.0;
    Vec2 first;
    double second = 0.0;
    std::vector<std::pair<double, double>> spans;
    for (std::size_t k = 0; k < strips; ++k) {
        const double y = low + (static_cast<double>(k) + 0.5) * step;
        spans.clear();
        for (const Disk& disk : disks) {
            const double square = disk.radius * disk.radius - (y - disk.centre.y) * (y - disk.centre.y);
            if (square > 0.0) spans.emplace_back(disk.centre.x - std::sqrt(square), disk.centre.x + std::sqrt(square));
        }
        std::sort(spans.begin(), spans.end());
        double passed = -HUGE_VAL;
        for (const auto& [from, to] : spans) {
            const double a = std::max(from, passed);
            if (to <= a) continue;
            area += step * (to - a);
            first += step * Vec2{(to * to - a * a) / 2.0, y * (to - a)};
            second += step * ((to * to * to - a * a * a) / 3.0 + y * y * (to - a));
            passed = to;
        }
    }
    const Vec2 centroid = first / area;
    return {area, centroid, second - area * dot(centroid, centroid)};
}

void check_lamina(const Lamina& found, const Lamina& expected, double tolerance) {
    const double size = std::sqrt(expected.area);
    CHECK(found.area == Approx(expected.area).epsilon(tolerance));
    CHECK(norm(found.centroid - expected.centroid) < tolerance * size);
    CHECK(found.polar == Approx(expected.polar).epsilon(tolerance));
}

} // namespace

TEST_CASE("one disk, and disks that lie apart or in it", "[union]") {
    const Vec2 at{3.0, -2.0};
    check_lamina(union_of(std::vector<Disk>{{at, 0.7}}), {disk_area(0.7), at, disk_polar(0.7)}, 1e-13);

    // The same twice, one inside, one touching from within.
    const std::vector<Disk> hidden{{at, 0.7}, {at, 0.7}, {at + Vec2{0.1, 0.2}, 0.3}, {at + Vec2{0.4, 0.0}, 0.3}};
    check_lamina(union_of(hidden), {disk_area(0.7), at, disk_polar(0.7)}, 1e-12);
    check_lamina(union_of(std::vector<Disk>(hidden.rbegin(), hidden.rend())), {disk_area(0.7), at, disk_polar(0.7)},
                 1e-12);

    CHECK(union_of({}).area == 0.0);
}

TEST_CASE("disks that touch have the parallel-axis moment of the template", "[union]") {
    const double R = 0.02;
    const double root = std::sqrt(3.0);
    const std::vector<std::vector<Vec2>> shapes{
        {{-1.0, 0.0}, {1.0, 0.0}},
        {{-1.0, -1.0 / root}, {1.0, -1.0 / root}, {0.0, 2.0 / root}},
        {{0.0, 0.0}, {2.0, 0.0}, {1.0, root}, {-1.0, root}, {-2.0, 0.0}, {-1.0, -root}, {1.0, -root}}};
    for (const std::vector<Vec2>& shape : shapes) {
        std::vector<Disk> disks;
        Lamina expected{0.0, {1e3, 5.0}, 0.0};
        for (const Vec2 p : shape) {
            disks.push_back({expected.centroid + R * p, R});
            expected.area += disk_area(R);
            expected.polar += disk_polar(R) + disk_area(R) * R * R * dot(p, p);
        }
        // Rounding at a tangent point lets a lens of depth 1e-13 R in, and coordinates of 1e3 m carry 1e-13 m.
        check_lamina(union_of(disks), expected, 1e-9);
    }
}

TEST_CASE("two disks that overlap cover both less their lens", "[union]") {
    for (const double r : {1.0, 0.6, 1.4}) {
        for (const double share : {0.05, 0.4, 0.8}) {
            const double d = std::abs(1.0 - r) + share * (1.0 + r - std::abs(1.0 - r));
            const double chord = (d * d + 1.0 - r * r) / (2.0 * d);
            // The lens is the segment of the first beyond the chord and that of the second before it.
            const Segment here = segment(1.0, chord);
            const Segment there = segment(r, d - chord);
            const double area = disk_area(1.0) + disk_area(r) - here.area - there.area;
            const double first = d * disk_area(r) - here.first - (d * there.area - there.first);
            const double second = disk_polar(1.0) + disk_polar(r) + d * d * disk_area(r) - here.second -
                                  (there.second - 2.0 * d * there.first + d * d * there.area);
            const double x = first / area;
            const Vec2 axis{0.6, 0.8};
            const Vec2 at{-4.0, 2.0};
            check_lamina(union_of(std::vector<Disk>{{at, 1.0}, {at + d * axis, r}}),
                         {area, at + x * axis, second - area * x * x}, 1e-12);
        }
    }
}

TEST_CASE("disks that overlap each other cover what strips add up to", "[union]") {
    const std::vector<std::vector<Disk>> cases{
        {{{0.0, 0.0}, 1.0}, {{1.2, 0.1}, 0.9}, {{0.5, 0.9}, 0.7}},  // covered in the middle
        {{{0.0, 0.0}, 1.0}, {{1.7, 0.0}, 1.0}, {{0.85, 1.5}, 1.0}}, // round a hole
        {{{0.0, 0.0}, 1.0}, {{0.5, 0.0}, 0.2}, {{1.1, 0.3}, 0.5}, {{5.0, 1.0}, 0.4}, {{1.3, 0.6}, 0.5}},
    };
    constexpr std::size_t strips = 200000;
    // The midpoint rule is wrong by the square roots at the ends of each disk: (height/strips)^1.5.
    const double tolerance = 20.0 * std::pow(4.0 / strips, 1.5);
    for (const std::vector<Disk>& disks : cases) check_lamina(union_of(disks), by_strips(disks, strips), tolerance);
}
