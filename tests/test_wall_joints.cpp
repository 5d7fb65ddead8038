// What an element feels where one part of a wall ends and the next begins.
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;
constexpr double g = 9.81;

/// From `from` to `to` in `segments` of unequal lengths.
std::vector<Vec2> divided(Vec2 from, Vec2 to, int segments) {
    std::vector<Vec2> points{from};
    for (int k = 1; k < segments; ++k) points.push_back(from + ((k + 0.2 * (k % 3)) / segments) * (to - from));
    points.push_back(to);
    return points;
}

struct Felt {
    std::vector<Vec2> force;
    observe::BodyMotion end;
    std::size_t most_contacts = 0;
    double friction = 0.0;
    double way = 0.0; ///< m
};

/// A disk thrown along a floor at angle `slope`, first sliding and then rolling.
Felt thrown(double slope, int segments, double rolling_friction) {
    model::Scene scene = test::scene_of(test::bouncing(0.5, 0.3));
    scene.materials[0].youngs_modulus = 1e7;
    scene.materials[0].rolling_friction = rolling_friction;
    scene.gravity = turned({0.0, -g}, slope);
    const Vec2 along = turned({1.0, 0.0}, slope);
    scene.walls.push_back(test::wall_along("floor", divided(-0.1 * along, 0.3 * along, segments)));
    scene.bodies.push_back(
        test::disks("disk", {{-0.08 * along + (R - 2e-8) * turned_left(along), R}}, model::NoBonds{}));
    scene.bodies[0].velocity = 0.8 * along;
    observe::Simulation sim(scene, 1);
    Felt felt;
    sim.run(0.3, {test::watching(1e-4, [&](observe::Simulation& now) {
                felt.force.push_back(now.wall_motion(0).force);
                felt.most_contacts = std::max(felt.most_contacts, now.contact_count());
            })});
    felt.end = sim.body_motion(0);
    felt.way = dot(felt.end.centre, along) + 0.08;
    felt.friction = sim.ledger().friction;
    return felt;
}

} // namespace

TEST_CASE("joints of a straight wall are not felt", "[walls]") {
    // Floor of ten segments against the same floor of one. On a slope the joints are straight to rounding only.
    const double slope = GENERATE(0.0, 0.3);
    const double rolling_friction = GENERATE(0.0, 0.05);
    const Felt whole = thrown(slope, 1, rolling_friction);
    const Felt jointed = thrown(slope, 10, rolling_friction);
    CHECK(whole.way > 0.15); // over four joints and more
    CHECK(jointed.most_contacts == 1);
    REQUIRE(jointed.force.size() == whole.force.size());
    double worst = 0.0;
    double most = 0.0;
    for (std::size_t k = 0; k < whole.force.size(); ++k) {
        worst = std::max(worst, norm(jointed.force[k] - whole.force[k]));
        most = std::max(most, norm(whole.force[k]));
    }
    // A place at 0.1 m is known to 1e-17 m, of overlaps of 1e-7 m and more.
    CHECK(worst < 1e-8 * most);
    CHECK(norm(jointed.end.centre - whole.end.centre) < 1e-10 * R);
    CHECK(jointed.end.spin == Approx(whole.end.spin).epsilon(1e-9));
    CHECK(jointed.friction == Approx(whole.friction).epsilon(1e-9));
}

TEST_CASE("friction goes on round a corner", "[walls]") {
    // A disk that does not turn is led over a floor, round its end and down the side at constant overlap: it slips all the way,
    // so that shear over pressure is mu at every instant, the normal being that of the nearest point.
    const double mu = 0.3;
    const double overlap = 1e-3 * R;
    const double arm = R - overlap;
    const double speed = 0.2;
    model::Scene scene = test::scene_of(test::bouncing(1.0, mu));
    scene.materials[0].youngs_modulus = 1e8;
    scene.walls.push_back(test::wall_along("step", {{-0.1, 0.0}, {0.0, 0.0}, {0.0, -0.1}}));
    scene.bodies.push_back(test::disks("disk", {{{-0.01, arm}, R}}, model::NoBonds{}));
    const double before = 0.01 / speed;
    const double round = 0.5 * std::numbers::pi * arm / speed;
    std::vector<double> times{0.0};
    std::vector<double> x{speed};
    std::vector<double> y{0.0};
    constexpr int pieces = 2000;
    for (int k = 0; k <= pieces; ++k) {
        const double angle = 0.5 * std::numbers::pi * k / pieces;
        times.push_back(before + round * k / pieces);
        x.push_back(speed * std::cos(angle));
        y.push_back(-speed * std::sin(angle));
    }
    model::Motion led;
    led.selection = test::all_of(0);
    led.velocity_x = Signal{times, x};
    led.velocity_y = Signal{times, y};
    led.spin = Signal::constant(0.0);
    scene.motions.push_back(led);
    observe::Simulation sim(scene, 1);
    sim.run(0.2 * before, {}); // the spring of the shear is as far as it goes
    double worst = 0.0;
    sim.run(0.8 * before + round + before, {test::watching(0.0, [&](observe::Simulation& now) {
                const Vec2 at = now.body_motion(0).centre;
                const Vec2 nearest{std::min(at.x, 0.0), std::min(at.y, 0.0)};
                const Vec2 n = (1.0 / norm(at - nearest)) * (at - nearest);
                const Vec2 f = -1.0 * now.wall_motion(0).force;
                worst = std::max(worst, std::fabs(dot(f, turned_left(n)) / dot(f, n) - mu));
            })});
    CHECK(sim.body_motion(0).centre.y < -0.005);
    CHECK(worst < 1e-6);
    CHECK(sim.wall_motion(0).force.x == Approx(-sim.state().walls[0].rules[0].Kn * overlap).epsilon(1e-3));
}

TEST_CASE("a disk over a joint presses on the wall once, in a bend twice", "[walls]") {
    // Over a joint of a straight floor and on a ridge one contact, in a valley two, each with W/(2 cos a).
    const double a = GENERATE(0.0, 0.2, -0.2);
    model::Scene scene = test::scene_of(test::bouncing(0.3, 0.0));
    scene.materials[0].youngs_modulus = 1e7;
    scene.gravity = {0.0, -g};
    scene.walls.push_back(test::wall_along("floor", {{-0.1, 0.1 * std::tan(a)}, {0.0, 0.0}, {0.1, 0.1 * std::tan(a)}}));
    scene.bodies.push_back(test::disks("disk", {{{0.0, R / std::cos(std::max(a, 0.0))}, R}}, model::NoBonds{}));
    observe::Simulation sim(scene, 1);
    sim.run(0.1, {});
    const double weight = g * sim.body_motion(0).mass;
    CHECK(sim.contact_count() == (a > 0.0 ? 2 : 1));
    CHECK(-sim.wall_motion(0).force.y == Approx(weight).epsilon(1e-6));
    const double K = sim.state().walls[0].rules[0].Kn;
    const double sunk = a > 0.0 ? weight / (2.0 * K * std::cos(a) * std::cos(a)) : weight / K;
    CHECK(R / std::cos(std::max(a, 0.0)) - sim.body_motion(0).centre.y == Approx(sunk).epsilon(1e-4));
}
