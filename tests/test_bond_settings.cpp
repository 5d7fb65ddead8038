// Bond laws as scenes say them, and what is told of bodies whose bonds cannot do what they are asked.
#include "engine/model/derived_law.hpp"
#include "engine/state/assemble.hpp"
#include "tests/catch.hpp"
#include "tests/scene_language.hpp"

#include <cmath>
#include <string>
#include <variant>
#include <vector>

using namespace demlua;
using namespace demlua::test;
using Catch::Approx;

namespace {

const std::string concrete_with =
    "local concrete = dem.material { name = \"concrete\", youngs_modulus = 29.7e9, poissons_ratio = 0.3, "
    "density = 2400, tensile_strength = 3.44e6, ";

/// Problems found when the scene is put together, without their places.
std::vector<std::string> assembled(const std::string& text) {
    std::vector<std::string> told;
    for (const std::string& message : problems_of([&] {
             BareHost host;
             run(text, host);
         })) {
        told.push_back(message.substr(message.find(": ") + 2));
    }
    return told;
}

std::string plate(const std::string& bonds, const std::string& packing, const std::string& rest) {
    return concrete_with + "fracture_toughness = 1e6 }\n" + R"(local sim = dem.simulation {}
local plate = sim:body { name = "plate", material = concrete, region = dem.rectangle { size = { 1, 1 } }, packing = )" +
           packing + ", bonds = " + bonds + " }\n" + rest + "sim:run { duration = 1e-6 }\n";
}

} // namespace

TEST_CASE("a bond law is chosen by a parameter", "[scene]") {
    const std::string text = rock + R"(local p = dem.param { law = "plateau" }
local sim = dem.simulation {}
sim:body { name = "pair", material = rock, packing = dem.disks { { 0, 0, 1 }, { 2, 0, 1 } }, bonds = dem.bond_law(p.law) { search = 0.3 } }
)";
    const auto law_of = [&](const std::string& name) {
        return checked(text, {{"law", name}}).scene.bodies.at(0).bonds;
    };
    CHECK(std::get<model::ElasticBonds>(law_of("elastic")).search == 0.3);
    CHECK_THROWS_AS(law_of("plateau"), SceneError); // rock has no strength
    const std::string strong =
        concrete_with + "fracture_toughness = 1e6 }\nlocal rock = concrete\n" + text.substr(text.find("local p"));
    const auto strong_law = [&](const std::string& name) {
        return checked(strong, {{"law", name}}).scene.bodies.at(0).bonds;
    };
    CHECK(std::get<model::PlateauBonds>(strong_law("plateau")).search == 0.3);
    CHECK(std::get<model::SofteningBonds>(strong_law("softening")).search == 0.3);
    CHECK(std::get<model::BrittleTensileBonds>(strong_law("brittle_tensile")).search == 0.3);
    CHECK(std::get<model::BrittleToughnessBonds>(strong_law("brittle_toughness")).search == 0.3);
}

TEST_CASE("fracture energy stands for the toughness sqrt(G E*)", "[scene]") {
    const auto material = [](const std::string& said) {
        return checked(concrete_with + said +
                       " }\nlocal sim = dem.simulation { plane = \"strain\" }\n"
                       "sim:body { name = \"a\", material = concrete, packing = dem.disks { { 0, "
                       "0, 1 } } }\n")
            .scene.materials.at(0);
    };
    const double modulus = 29.7e9 / (1.0 - 0.09);
    const auto toughness = model::fracture_toughness_of(material("fracture_energy = 30"), model::Plane::strain);
    CHECK(toughness.value() == Approx(std::sqrt(30.0 * modulus)).epsilon(1e-14));
    // Both, a millionth apart at most.
    const double energy = 1e12 / modulus;
    CHECK_NOTHROW(material("fracture_toughness = 1e6, fracture_energy = " + std::to_string(energy * (1.0 + 9e-7))));
    CHECK_THROWS_AS(material("fracture_toughness = 1e6, fracture_energy = " + std::to_string(energy * (1.0 + 2e-6))),
                    SceneError);
}

TEST_CASE("elements too large for their bonds are refused once the body is packed", "[scene]") {
    // Largest radius 16 (1-nu*) sqrt(3)/(3-nu*)^2 (K_Ic/s)^2 = 0.224871 m of pairs, largest distance 2 (K_Ic/s)^2 =
    // 0.169010 m across facets.
    const std::vector<std::string> pairs =
        assembled(plate(R"(dem.plateau { stiffness = "delaunay" })", "dem.relaxed { spacing = 0.55 }", ""));
    REQUIRE(pairs.size() == 1);
    CHECK_THAT(pairs[0], Catch::Matchers::ContainsSubstring("body.bonds = dem.plateau: cannot be resolved") &&
                             Catch::Matchers::ContainsSubstring("the largest radius is 0.224871 m"));
    const std::vector<std::string> facets = assembled(plate("dem.plateau {}", "dem.relaxed { spacing = 0.2 }", ""));
    REQUIRE(facets.size() == 1);
    CHECK_THAT(facets[0], Catch::Matchers::ContainsSubstring("the largest distance is 0.16901 m"));
    CHECK(assembled(plate("dem.plateau {}", "dem.relaxed { spacing = 0.1 }", "")).empty());
    CHECK(assembled(plate("dem.brittle_tensile {}", "dem.relaxed { spacing = 0.2 }", "")).empty());
}

TEST_CASE("dem.cohesive takes facets on any pack and nothing else", "[scene]") {
    const std::string fine = "dem.close_packed { radius = 0.015 }";
    const model::Scene scene = checked(plate("dem.bond_law \"cohesive\" {}", fine, "")).scene;
    CHECK(std::holds_alternative<model::CohesiveBonds>(scene.bodies.at(0).bonds));
    CHECK(model::network_of(scene.bodies.at(0)) == model::Network::facets);
    for (const char* stiffness : {"unit cell", "contacts", "delaunay"}) {
        const std::vector<std::string> told =
            assembled(plate(std::string("dem.cohesive { stiffness = \"") + stiffness + "\" }", fine, ""));
        REQUIRE(told.size() == 1);
        CHECK_THAT(told[0], Catch::Matchers::ContainsSubstring(std::string("cohesive.stiffness = \"") + stiffness) &&
                                Catch::Matchers::ContainsSubstring("needs the facets of cells"));
    }
    // Largest distance 0.6 (K_Ic/s)^2/(1 + nu*) = 0.0390024 m.
    const std::vector<std::string> large =
        assembled(plate("dem.cohesive {}", "dem.close_packed { radius = 0.02 }", ""));
    REQUIRE(large.size() == 1);
    CHECK_THAT(large[0], Catch::Matchers::ContainsSubstring("the largest distance is 0.0390024 m"));
}

TEST_CASE("a notch that cuts nothing is refused, one that cuts is not", "[scene]") {
    const std::string packing = "dem.close_packed { radius = 0.05 }";
    // Rows stand at 0.05 + 0.0866 n; between two columns of a row, along it, nothing is crossed.
    const std::vector<std::string> told = assembled(
        plate("dem.plateau {}", packing, "sim:notch { plate, from = { 0.02, 0.02 }, to = { 0.03, 0.03 } }\n"));
    REQUIRE(told.size() == 1);
    CHECK_THAT(told[0], Catch::Matchers::ContainsSubstring("notch: cuts no bond of body \"plate\""));
    for (const char* law : {"plateau", "softening", "brittle_tensile", "brittle_toughness"}) {
        const std::string bonds = std::string("dem.") + law + " {}";
        CHECK(
            assembled(plate(bonds, packing, "sim:notch { plate, from = { 0, 0.52 }, to = { 0.3, 0.52 } }\n")).empty());
    }
    const std::vector<std::string> again =
        assembled(plate("dem.plateau {}", packing,
                        "sim:notch { plate, from = { 0, 0.52 }, to = { 0.3, 0.52 } }\n"
                        "sim:notch { plate, from = { 0, 0.52 }, to = { 0.2, 0.52 } }\n"));
    REQUIRE(again.size() == 1);
    CHECK_THAT(again[0], Catch::Matchers::ContainsSubstring("cuts no bond"));
}
