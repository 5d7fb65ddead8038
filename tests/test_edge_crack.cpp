// The edge-cracked plate of Tavarez & Plesha 2007, fig. 15, as its scene builds it; what it comes to is in tests/scenarios.py.
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/scene_language.hpp"

#include <numeric>

using namespace demlua;
using namespace demlua::test;
using Catch::Approx;

namespace {

const std::filesystem::path scene_file = source_folder / "scenarios/edge_crack.lua";

/// The plate at rest: a load too small and too short to break anything.
observe::Simulation& plate(BareHost& host, const Overrides& parameters) {
    Overrides all{{"stress", "1"}, {"ramp", "1e-5"}};
    for (const auto& each : parameters) all.push_back(each);
    run_scene(scene_file, all, host);
    return *host.simulation();
}

/// Length of side (times thickness) that the elements of a load bear.
double borne(const state::Load& load) { return std::accumulate(load.share.begin(), load.share.end(), 0.0); }

} // namespace

TEST_CASE("the plate of fig. 15 has the paper's elements, its crack crosses two bonds a diameter", "[edge crack]") {
    struct Level {
        const char* radius;
        double R;
        std::size_t elements, in_end_row, crossing;
    };
    for (const Level& level : {Level{"7.8125e-3", 7.8125e-3, 1172, 17, 4}, Level{"3.90625e-3", 3.90625e-3, 4713, 33, 8},
                               Level{"1.953125e-3", 1.953125e-3, 18899, 65, 16}}) {
        INFO(level.radius);
        BareHost host;
        const observe::Simulation& simulation = plate(host, {{"radius", level.radius}});
        CHECK(simulation.element_count() == level.elements);
        CHECK(simulation.broken_bonds() == level.crossing);
        // Free ends: two loads, no drives.
        const state::State& state = simulation.state();
        CHECK(state.drives.empty());
        REQUIRE(state.loads.size() == 2);
        for (const state::Load& load : state.loads) {
            REQUIRE(load.share.size() == level.in_end_row);
            // The ends of a side are found to 1e-10 of a radius.
            CHECK(borne(load) == Approx(0.25).epsilon(1e-10));
            CHECK(load.share.front() == Approx(level.R).epsilon(1e-9));
            CHECK(load.share[1] == Approx(2.0 * level.R).epsilon(1e-9));
            CHECK(load.share.back() == Approx(level.R).epsilon(1e-9));
        }
    }
}

TEST_CASE("the plate without a crack, with ends that do not turn", "[edge crack]") {
    BareHost host;
    const observe::Simulation& simulation =
        plate(host, {{"radius", "7.8125e-3"}, {"crack", "0"}, {"hold_rotation", "true"}});
    CHECK(simulation.broken_bonds() == 0);
    CHECK(simulation.state().drives.size() == 2);
    CHECK(host.number("reference") == 3.44e6);
}

TEST_CASE("eq. 37 of the plate's crack is 2.61 MPa", "[edge crack]") {
    BareHost host;
    plate(host, {{"radius", "7.8125e-3"}});
    CHECK(host.number("reference") == Approx(2.61e6).epsilon(0.005 / 2.61));
    CHECK(host.results.count("critical_stress") == 0);
}

TEST_CASE("the plate refuses what it is not made for", "[edge crack]") {
    const auto told = [](const Overrides& parameters) {
        const auto messages = problems_of([&] { check_scene(scene_file, parameters); });
        return messages.empty() ? std::string() : messages.front();
    };
    using Catch::Matchers::ContainsSubstring;
    CHECK_THAT(told({{"radius", "6e-3"}}), ContainsSubstring("a whole number of diameters"));
    CHECK_THAT(told({{"radius", "0.125"}}), ContainsSubstring("too large"));
    CHECK_THAT(told({{"crack", "-0.01"}}), ContainsSubstring("crack: a length"));
    CHECK_THAT(told({{"law", "no such law"}}), ContainsSubstring("no such law"));
    CHECK_THAT(told({{"read_out", "second bond"}}), ContainsSubstring("\"half ligament\""));
    CHECK_THAT(told({{"head_start", "3.6e6"}}), ContainsSubstring("below stress"));
    CHECK_THAT(told({{"plane", "strain"}}), ContainsSubstring("at most 1/4 in plane strain"));
}
