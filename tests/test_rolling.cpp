// Rolling friction: the law, and a disk that it brings to rest.
#include "engine/law/rolling.hpp"
#include "tests/catch.hpp"
#include "tests/grain_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace demlua;
using Catch::Approx;

TEST_CASE("what a rolling moment takes is stored, rubbed off or damped") {
    // A turn there and back again, well beyond the cap: the work of the moment is the sum of the three.
    const double kr = 50.0;
    const double cap = 0.02;
    const double dt = 1e-4;
    law::Rolling::History<double> history;
    law::Spent<double> spent;
    double work = 0.0;
    double before = 0.0;
    double greatest = 0.0;
    for (int k = 0; k < 4000; ++k) {
        const double rate = 3.0 * std::sin(2.0 * std::numbers::pi * k / 2000.0);
        const double moment = law::Rolling::respond<double>({kr, 1e-3, cap, rate}, dt, history, spent);
        work += 0.5 * (before + moment) * rate * dt;
        before = moment;
        greatest = std::max(greatest, std::fabs(moment));
    }
    CHECK(greatest == Approx(cap).epsilon(1e-12));
    CHECK(work == Approx(law::Rolling::stored_energy(kr, history) + spent.friction + spent.damped).epsilon(1e-12));
    CHECK(spent.friction > 0.0);
}

TEST_CASE("rolling friction brings a rolling disk to rest at two thirds of mu_r g") {
    // M = mu_r R N against the spin and friction F at the foot: m a = -F, I w' = F R - M with a = -w' R gives a = 2/3 mu_r g.
    const double R = 5e-3;
    const double g = 9.81;
    const double mu_r = 0.1;
    const double u = 0.2;
    model::Scene scene = test::scene_of(test::concrete());
    scene.materials[0].youngs_modulus = 1e7;
    scene.materials[0].friction = 0.5;
    scene.materials[0].restitution = 0.3;
    scene.materials[0].rolling_friction = mu_r;
    scene.gravity = {0.0, -g};
    scene.walls.push_back(test::wall_along("floor", {{-1.0, 0.0}, {1.0, 0.0}}));
    scene.bodies.push_back(test::disks("disk", {{{0.0, R}, R}}, model::NoBonds{}));
    scene.bodies[0].velocity = {u, 0.0};
    scene.bodies[0].spin = -u / R;
    observe::Simulation sim(scene, 1);
    const double a = 2.0 / 3.0 * mu_r * g;
    sim.run(0.5 * u / a, {});
    CHECK(sim.body_motion(0).velocity.x == Approx(0.5 * u).epsilon(0.01));
    sim.run(u / a, {});
    CHECK(std::fabs(sim.body_motion(0).velocity.x) < 1e-3 * u);
    CHECK(sim.body_motion(0).centre.x == Approx(0.5 * u * u / a).epsilon(0.01));
    CHECK(std::fabs(sim.ledger().error) < 1e-3 * sim.ledger().friction);
}
