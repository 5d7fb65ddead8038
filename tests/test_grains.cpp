// Loose grains: no contact gives energy away for nothing, no result hangs on numbering, and what lies still stays so.
#include "engine/law/stiffness.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace demlua;
using Catch::Approx;

namespace {

constexpr double R = 5e-3;
constexpr double speed = 1.0;

law::ContactStiffness stiffness(const model::Material& material) {
    return law::contact_stiffness(law::plane_moduli(material.youngs_modulus, material.poissons_ratio, false), 1.0);
}

double disk_mass(const model::Material& material) { return material.density * std::numbers::pi * R * R; }

double kinetic(double mass, Vec2 velocity, double spin) {
    return 0.5 * mass * dot(velocity, velocity) + 0.25 * mass * R * R * spin * spin;
}

/// 89 disks that meet a floor at 1 to 89 degrees from the upright, within a contact's duration of each other, and each at
/// another place between two time steps.
model::Scene thrown_at_all_angles(const model::Material& material, double spin, double contact) {
    model::Scene scene = test::scene_of(material);
    scene.step_fraction = 0.02;
    scene.walls.push_back(test::wall_along("floor", {{0.0, 0.0}, {4.0 * R * 91.0, 0.0}}));
    for (int angle = 1; angle < 90; ++angle) {
        const double turned = angle * std::numbers::pi / 180.0;
        const Vec2 velocity{speed * std::sin(turned), -speed * std::cos(turned)};
        const double flight = contact * std::fmod(0.618 * angle, 1.0);
        const model::Disk disk{{4.0 * R * angle, R - velocity.y * flight}, R};
        scene.bodies.push_back(test::disks("at" + std::to_string(angle), {disk}, model::NoBonds{}));
        scene.bodies.back().velocity = velocity;
        scene.bodies.back().spin = spin;
    }
    return scene;
}

/// A place in the list of `n` for every number, and every place once: a prime that does not divide n goes round.
std::vector<std::size_t> places(std::size_t n, bool shuffled) {
    std::vector<std::size_t> place(n);
    for (std::size_t k = 0; k < n; ++k) place[k] = shuffled ? (k * 7919) % n : k;
    return place;
}

/// Disks of five sizes in a square lattice with gaps.
std::vector<model::Disk> lattice(Vec2 at, std::size_t columns, std::size_t rows) {
    std::vector<model::Disk> disks;
    for (std::size_t k = 0; k < columns * rows; ++k) {
        const auto column = static_cast<double>(k % columns);
        const std::size_t row = k / columns;
        const double shrunk = 0.8 + 0.05 * static_cast<double>((3 * k) % 5);
        disks.push_back(
            {at + 2.05 * R * Vec2{column + 0.02 * static_cast<double>(k % 3), static_cast<double>(row)}, shrunk * R});
    }
    return disks;
}

/// Two heaps thrown at each other over a floor.
model::Scene colliding_heaps(bool shuffled) {
    model::Scene scene = test::scene_of(test::bouncing(0.6, 0.4));
    scene.materials[0].youngs_modulus = 1e8;
    scene.gravity = {0.0, -9.81};
    scene.walls.push_back(test::wall_along("floor", {{-1.0, 0.0}, {1.0, 0.0}}));
    for (const double side : {-1.0, 1.0}) {
        const std::vector<model::Disk> disks = lattice({side * 7.0 * R - 5.0 * R, R}, 6, 5);
        std::vector<model::Disk> listed;
        for (const std::size_t place : places(disks.size(), shuffled)) listed.push_back(disks[place]);
        scene.bodies.push_back(test::disks(side < 0.0 ? "left" : "right", listed, model::NoBonds{}));
        scene.bodies.back().velocity = {-2.0 * side, 0.0};
    }
    return scene;
}

/// Two disks that meet off centre, in either order.
model::Scene struck_pair(bool exchanged, double smaller) {
    model::Scene scene = test::scene_of(test::bouncing(0.7, 0.3));
    std::vector<model::Body> pair{test::disks("one", {{{0.0, 0.0}, R}}, model::NoBonds{}),
                                  test::disks("other", {{{1.9 * R, 0.9 * R}, smaller * R}}, model::NoBonds{})};
    pair[0].velocity = {speed, 0.0};
    if (exchanged) std::reverse(pair.begin(), pair.end());
    scene.bodies = pair;
    return scene;
}

/// velocity and spin of one body's disk.
std::vector<double> motion(const observe::Simulation& sim, std::size_t body) {
    std::vector<double> all;
    for (const char* name : {"velocity_x", "velocity_y", "spin"}) {
        all.push_back(sim.field(name, test::all_of(body))[0]);
    }
    return all;
}

} // namespace

TEST_CASE("a frictional impact gains no energy at any angle") {
    // A spring that is met and left between two steps changes the energy in it by a share of at most (w dt)^2/4: central
    // difference keeps v- v+ + w^2 u^2, which is the square of the free speed v less w^2 u (v dt - u), 0 < u < v dt, on
    // both sides. Friction and dashpots only take.
    const double restitution = GENERATE(1.0, 0.5);
    const double friction = GENERATE(0.0, 0.1, 0.5, 1.0);
    const double spin = GENERATE(0.0, 1.5, -1.5) * speed / R;
    const model::Material material = test::bouncing(restitution, friction);
    const law::ContactStiffness K = stiffness(material);
    const double m = disk_mass(material);
    const double contact = std::numbers::pi * std::sqrt(m / K.normal);
    observe::Simulation sim(thrown_at_all_angles(material, spin, contact), 1);
    sim.run(4.0 * contact, {});
    const double step = std::sqrt(std::max(K.normal, 3.0 * K.shear) / m) * sim.time_step();
    double gain = -1.0;
    for (std::size_t body = 0; body < 89; ++body) {
        const observe::BodyMotion after = sim.body_motion(body);
        CHECK(after.velocity.y > 0.0);
        const double turned = static_cast<double>(body + 1) * std::numbers::pi / 180.0;
        const double before = kinetic(m, {speed * std::sin(turned), speed * std::cos(turned)}, spin);
        gain = std::max(gain, kinetic(m, after.velocity, after.spin) / before - 1.0);
    }
    INFO("restitution " << restitution << ", friction " << friction << ", spin " << spin);
    CHECK(gain <= 0.25 * step * step);
}

TEST_CASE("numbering of disks does not change how heaps collide") {
    observe::Simulation straight(colliding_heaps(false), 1);
    observe::Simulation shuffled(colliding_heaps(true), 1);
    // Long enough for every disk to have met others. An impact makes a disturbance grow by about the way between impacts over
    // a radius; after five of at most twenty, 1e-16 is below 1e-9.
    const double duration = 12e-3;
    straight.run(duration, {});
    shuffled.run(duration, {});
    const double tolerance = 1e-9;
    const observe::Ledger a = straight.ledger();
    const observe::Ledger b = shuffled.ledger();
    CHECK(a.friction > 0.01 * a.kinetic);
    CHECK(straight.time_step() == shuffled.time_step());
    CHECK(straight.contact_count() == shuffled.contact_count());
    CHECK(b.kinetic == Approx(a.kinetic).epsilon(tolerance));
    CHECK(b.friction == Approx(a.friction).epsilon(tolerance));
    CHECK(b.contact_damping == Approx(a.contact_damping).epsilon(tolerance));
    for (std::size_t body = 0; body < 2; ++body) {
        const Vec2 apart = shuffled.body_motion(body).velocity - straight.body_motion(body).velocity;
        CHECK(norm(apart) < tolerance * speed);
        const std::vector<double> x = straight.field("displacement_x", test::all_of(body));
        const std::vector<double> y = shuffled.field("displacement_x", test::all_of(body));
        const std::vector<std::size_t> place = places(x.size(), true);
        for (std::size_t k = 0; k < x.size(); ++k) CHECK(y[k] == Approx(x[place[k]]).margin(tolerance * R));
    }
}

TEST_CASE("a pair is struck alike whichever of it comes first") {
    for (const double smaller : {1.0, 0.7}) {
        observe::Simulation sim(struck_pair(false, smaller), 1);
        observe::Simulation other(struck_pair(true, smaller), 1);
        sim.run(3e-3, {});
        other.run(3e-3, {});
        REQUIRE(sim.ledger().friction > 0.0);
        for (std::size_t body = 0; body < 2; ++body) {
            const std::vector<double> here = motion(sim, body);
            const std::vector<double> there = motion(other, 1 - body);
            // Equal disks share the lever exactly; of unequal ones one's is what the other's leaves.
            if (smaller == 1.0) CHECK(here == there);
            for (std::size_t k = 0; k < here.size(); ++k) CHECK(there[k] == Approx(here[k]).epsilon(1e-12));
        }
    }
}

TEST_CASE("a pile that has come to rest stays where it is") {
    // Three disks in a tray, one on two. At rest a place is known to its last digit.
    model::Scene scene = test::scene_of(test::bouncing(0.3, 0.5));
    scene.materials[0].youngs_modulus = 1e7;
    scene.gravity = {0.0, -9.81};
    model::Wall tray;
    tray.name = "tray";
    tray.path = {{-2.0 * R, 2.0 * R}, {-2.0 * R, 0.0}, {2.0 * R, 0.0}, {2.0 * R, 2.0 * R}};
    scene.walls.push_back(tray);
    scene.bodies.push_back(test::disks("pile", {{{-R, R}, R}, {{R, R}, R}, {{0.0, (1.0 + std::numbers::sqrt3) * R}, R}},
                                       model::NoBonds{}));
    observe::Simulation sim(scene, 1);
    sim.run(1.0, {});
    std::vector<std::vector<double>> before;
    for (const char* name : {"displacement_x", "displacement_y", "rotation"}) before.push_back(sim.field(name, {}));
    sim.run(1.0, {});
    const double digit = std::numeric_limits<double>::epsilon();
    std::size_t row = 0;
    for (const char* name : {"displacement_x", "displacement_y", "rotation"}) {
        const double unit = row < 2 ? 3.0 * R : 1.0;
        const std::vector<double> after = sim.field(name, {});
        for (std::size_t k = 0; k < after.size(); ++k)
            CHECK(std::fabs(after[k] - before[row][k]) <= 2.0 * digit * unit);
        ++row;
    }
}
