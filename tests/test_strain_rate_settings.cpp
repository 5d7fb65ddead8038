// Strain-rate factors as scenes ask for them.
#include "engine/state/state.hpp"
#include "tests/catch.hpp"
#include "tests/scene_language.hpp"

#include <string>
#include <variant>
#include <vector>

using namespace demlua;

TEST_CASE("strain-rate factors are asked for by the concrete's compressive strength", "[scene]") {
    const std::string head =
        "local concrete = dem.material { name = \"concrete\", youngs_modulus = 29.7e9, poissons_ratio = 0.3, "
        "density = 2400, tensile_strength = 3.44e6, fracture_toughness = 1e6";
    const auto scene = [&](const std::string& more, const std::string& bonds) {
        return head + more + " }\nlocal sim = dem.simulation {}\nsim:body { name = \"a\", material = concrete, " +
               "region = dem.rectangle { size = { 0.1, 0.1 } }, packing = dem.close_packed { radius = 5e-3 }, bonds "
               "= " +
               bonds + " }\nsim:run { duration = 1e-6 }\n";
    };
    const auto told = [&](const std::string& more, const std::string& bonds) {
        const std::vector<std::string> problems = test::problems_of([&] {
            test::BareHost host;
            test::run(scene(more, bonds), host);
        });
        REQUIRE(problems.size() == 1);
        return problems[0];
    };
    using Catch::Matchers::ContainsSubstring;
    CHECK_THAT(told("", "dem.plateau { rate_compressive_strength = 0 }"),
               ContainsSubstring("plateau.rate_compressive_strength = 0: must be positive"));
    CHECK_THAT(told("", "dem.softening { rate_window = 1e-4 }"),
               ContainsSubstring("softening.rate_window = 0.0001: does nothing without"));
    CHECK_THAT(told(", rate_factor = 2", "dem.plateau { rate_compressive_strength = 30e6 }"),
               ContainsSubstring("would count strain rates twice"));
    // Five times 2R/sqrt(E/rho) = 1e-2/3517.8.
    CHECK_THAT(told("", "dem.plateau { rate_compressive_strength = 30e6, rate_window = 1e-6 }"),
               ContainsSubstring("plateau.rate_window = 1e-06 s: must be at least 1.42134e-05 s"));
    test::BareHost host;
    CHECK_NOTHROW(test::run(scene("", "dem.plateau { rate_compressive_strength = 30e6, rate_window = 2e-5 }"), host));
    CHECK(std::holds_alternative<state::BondSet<law::RateDependent<law::Plateau>>>(
        host.simulation()->state().bond_sets.at(0)));
    // Without the setting there is neither column nor loop.
    test::BareHost plain;
    CHECK_NOTHROW(test::run(scene("", "dem.plateau {}"), plain));
    CHECK(std::holds_alternative<state::BondSet<law::Plateau>>(plain.simulation()->state().bond_sets.at(0)));
}
