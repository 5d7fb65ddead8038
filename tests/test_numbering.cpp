// What comes of grains, clusters, wear, walls and figures does not hang on how elements are numbered.
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>
#include <variant>
#include <vector>

using namespace demlua;

namespace {

constexpr double R = 5e-3;
constexpr int columns = 5;
constexpr int rows = 4;

enum class Kind { single, rigid, bonded };

/// Disks of one kind, a grain in every third place of a coarse lattice, turned differently; in place order.
struct Grains {
    std::vector<model::Disk> disks;
    std::vector<std::uint32_t> cluster;
};

Grains grains_of(Kind kind) {
    Grains grains;
    for (int place = static_cast<int>(kind); place < columns * rows; place += 3) {
        const int column = place % columns;
        const int row = place / columns;
        const Vec2 middle{6.0 * R * (column + 0.6), 6.0 * R * (row + 1.0)};
        const auto cluster = static_cast<std::uint32_t>(place / 3);
        const int disks = kind == Kind::single ? 1 : 3;
        for (int k = 0; k < disks; ++k) {
            const double angle = 0.7 * place + 2.0 * std::numbers::pi / 3.0 * k;
            const double arm = kind == Kind::single ? 0.0 : 2.0 * R / std::numbers::sqrt3;
            grains.disks.push_back({middle + arm * Vec2{std::cos(angle), std::sin(angle)}, R});
            grains.cluster.push_back(cluster);
        }
    }
    return grains;
}

model::Body body_of(Kind kind, bool renumbered) {
    Grains grains = grains_of(kind);
    if (renumbered) {
        const std::size_t n = grains.disks.size();
        constexpr std::size_t prime = 7919; // does not divide n: every disk once
        Grains shuffled;
        for (std::size_t k = 0; k < n; ++k) {
            shuffled.disks.push_back(grains.disks[prime * (k + 1) % n]);
            shuffled.cluster.push_back(6 - grains.cluster[prime * (k + 1) % n]);
        }
        grains = shuffled;
    }
    static constexpr std::array<const char*, 3> names{"single", "rigid", "bonded"};
    model::Body body = test::disks(names.at(static_cast<std::size_t>(kind)), grains.disks,
                                   kind == Kind::bonded ? model::BondChoice{model::PlateauBonds{}}
                                                        : model::BondChoice{model::NoBonds{}});
    std::get<model::ListedDisks>(body.packing).clusters = grains.cluster;
    body.in_clusters = kind != Kind::single;
    body.rigid = kind == Kind::rigid;
    body.velocity = {0.4, -2.0};
    return body;
}

/// Grains of three kinds thrown into the corner of a box that wears them, with a free figure among them.
model::Scene thrown(bool renumbered) {
    model::Scene scene = test::scene_of(test::bouncing(0.6, 0.5));
    scene.materials[0].youngs_modulus = 5e7;
    scene.materials[0].tensile_strength = 2e4;
    scene.materials[0].wear_energy_density = 300.0;
    scene.materials[0].rolling_friction = 0.05;
    scene.gravity = {0.0, -9.81};
    std::vector<Kind> kinds{Kind::single, Kind::rigid, Kind::bonded};
    if (renumbered) std::reverse(kinds.begin(), kinds.end());
    for (const Kind kind : kinds) scene.bodies.push_back(body_of(kind, renumbered));
    scene.walls.push_back(test::wall_along("box", {{0.0, 1.0}, {0.0, 0.0}, {32.0 * R, 0.0}, {32.0 * R, 1.0}}));
    model::Outline block;
    block.name = "block";
    block.path = {{4.0 * R, 0.3 * R}, {12.0 * R, 0.3 * R}, {12.0 * R, 3.0 * R}, {4.0 * R, 3.0 * R}};
    scene.outlines.push_back(block);
    return scene;
}

using Place = std::pair<double, double>;

struct Outcome {
    std::vector<std::pair<Place, std::array<double, 3>>> moved; ///< by place at the start: displacement, m, and turn
    std::set<std::array<Place, 2>> broken;
    std::size_t worn = 0;
    std::size_t touching = 0;
    double friction = 0.0;
    observe::WallMotion block;
};

Outcome outcome_of(bool renumbered, double time) {
    observe::Simulation sim(thrown(renumbered), {renumbered ? 3 : 1, 1});
    sim.run(time, {});
    const state::Elements& elements = sim.state().elements;
    const auto stood = [&](std::size_t k) { return Place{elements.reference_x[k], elements.reference_y[k]}; };
    Outcome seen;
    for (std::size_t k = 0; k < elements.size(); ++k) {
        seen.moved.push_back({stood(k), {elements.ux[k], elements.uy[k], elements.rotation[k]}});
    }
    std::sort(seen.moved.begin(), seen.moved.end());
    for (const state::Crack& crack : sim.state().cracks) {
        seen.broken.insert({std::min(stood(crack.i), stood(crack.j)), std::max(stood(crack.i), stood(crack.j))});
    }
    seen.worn = sim.worn_elements();
    seen.touching = sim.contact_count();
    seen.friction = sim.ledger().friction;
    seen.block = sim.wall_motion(1);
    return seen;
}

} // namespace

TEST_CASE("grains of every kind, worn and broken among walls and figures, move alike by any numbering", "[numbering]") {
    // In the shorter run a search falls into a step in which a worn element leaves its cluster.
    const double time = GENERATE(0.02, 0.025);
    const Outcome plain = outcome_of(false, time);
    const Outcome other = outcome_of(true, time);
    CHECK(plain.broken.size() > 2);
    CHECK(plain.worn > 2);
    // Rounding of 1e-17 m; every impact makes of it as much more as a grain flies farther than its radius, here some
    // times for each of a few impacts. Anything decided by a number would show as a good part of the moves, 0.05 m.
    constexpr double rounding = 1e-9;
    REQUIRE(plain.moved.size() == other.moved.size());
    for (std::size_t k = 0; k < plain.moved.size(); ++k) {
        REQUIRE(plain.moved[k].first == other.moved[k].first);
        const auto& a = plain.moved[k].second;
        const auto& b = other.moved[k].second;
        CHECK(std::hypot(b[0] - a[0], b[1] - a[1]) < rounding);
        CHECK(std::fabs(b[2] - a[2]) < rounding / R);
    }
    CHECK(plain.broken == other.broken);
    CHECK(plain.worn == other.worn);
    CHECK(plain.touching == other.touching);
    CHECK(std::fabs(other.friction - plain.friction) < 1e-6 * plain.friction);
    CHECK(norm(other.block.position - plain.block.position) < rounding);
}
