// References of finite elements, computed again and compared with tests/references.json.
//
//   demlua_tests "[.rewrite]"    writes the file anew, which takes minutes
//   demlua_tests "[.cracks]"     prints the table of notched bodies of docs/theory/references.md
#include "tests/catch.hpp"
#include "tests/reference_cases.hpp"
#include "tests/references.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using namespace demlua;
using Json = nlohmann::ordered_json;

namespace {

/// Digits beyond the tenth are round-off of the solution.
double ten_digits(double value) { return std::stod(fmt::format("{:.10g}", value)); }

Json described(const test::ReferenceCase& one) {
    const std::vector<test::Quantity> coarse = one.solve(one.cells[0]);
    const std::vector<test::Quantity> fine = one.solve(one.cells[1]);
    Json quantities;
    for (std::size_t k = 0; k < fine.size(); ++k) {
        Json& quantity = quantities[fine[k].name];
        quantity["meaning"] = fine[k].meaning;
        quantity["value"] = ten_digits(fine[k].value);
        quantity["coarse"] = ten_digits(coarse[k].value);
        if (fine[k].closed_form) {
            quantity["closed_form"] = ten_digits(*fine[k].closed_form);
        }
    }
    return {{"geometry", one.geometry},
            {"material", one.material},
            {"support", one.support},
            {"load", one.load},
            {"meshes", {one.mesh(one.cells[0]), one.mesh(one.cells[1])}},
            {"quantities", quantities}};
}

void compare(const test::ReferenceCase& one) {
    INFO(one.name);
    const nlohmann::json& stated = test::references().at(one.name);
    CHECK(stated.at("meshes") == nlohmann::json({one.mesh(one.cells[0]), one.mesh(one.cells[1])}));
    const std::vector<test::Quantity> fine = one.solve(one.cells[1]);
    CHECK(stated.at("quantities").size() == fine.size());
    for (const test::Quantity& got : fine) {
        INFO(got.name);
        const nlohmann::json& quantity = stated.at("quantities").at(got.name);
        const auto value = quantity.at("value").get<double>();
        // Round-off grows with the condition number, 1e9 for the slender bars.
        CHECK(std::fabs(got.value - value) < 1e-7 * std::fabs(value));
        CHECK(std::fabs(quantity.at("coarse").get<double>() - value) < 1e-4 * std::fabs(value));
        CHECK(quantity.contains("closed_form") == got.closed_form.has_value());
        if (got.closed_form) {
            CHECK(std::fabs(value - *got.closed_form) < 1e-4 * std::fabs(value));
        }
    }
}

/// What the coarse mesh may be off by; places where a peak is reached are less sharp than its height.
double agreement(const std::string& quantity) {
    return quantity == "zone" || quantity == "plateau_zone" || quantity == "opening" ? 2e-2 : 1e-3;
}

void compare_crack(const test::ReferenceCase& one, bool compute) {
    INFO(one.name);
    const nlohmann::json& stated = test::references().at(one.name);
    CHECK(stated.at("meshes") == nlohmann::json({one.mesh(one.cells[0]), one.mesh(one.cells[1])}));
    for (const auto& [name, quantity] : stated.at("quantities").items()) {
        INFO(name);
        const auto value = quantity.at("value").get<double>();
        CHECK(std::fabs(quantity.at("coarse").get<double>() - value) < agreement(name) * value);
    }
    if (compute) {
        for (const test::Quantity& got : one.solve(one.cells[0])) {
            INFO(got.name);
            const auto coarse = stated.at("quantities").at(got.name).at("coarse").get<double>();
            // The parabola through three loads near a peak magnifies round-off where it is read for a place.
            CHECK(std::fabs(got.value - coarse) < 1e-5 * coarse);
        }
    }
}

} // namespace

TEST_CASE("references: bars by finite elements, two meshes within 1e-4") {
    for (const test::ReferenceCase& one : test::bar_cases()) {
        compare(one);
    }
}

TEST_CASE("references: ring and disc by finite elements against Michell's series and Hondros") {
    for (const test::ReferenceCase& one : test::round_cases()) {
        compare(one);
    }
}

TEST_CASE("references: notched bodies with a cohesive zone, two meshes within 1e-3") {
    const std::vector<test::ReferenceCase> cases = test::crack_cases();
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const bool computed = k % 6 == 1; // one of each family, and one more
        compare_crack(cases[k], computed);
    }
}

TEST_CASE("print the table of notched bodies", "[.cracks]") {
    std::cout << "| body | peak | handbook | ratio | zone | opening | plateau: peak | ratio | zone |\n"
                 "|---|---|---|---|---|---|---|---|---|\n";
    for (const test::ReferenceCase& one : test::crack_cases()) {
        const auto value = [&](const char* quantity) { return test::reference(one.name, quantity); };
        std::cout << fmt::format("| `{}` | {:.4f} | {:.4f} | {:.3f} | {:.2f} | {:.2f} | {:.4f} | {:.3f} | {:.2f} |\n",
                                 one.name, value("peak"), value("handbook"), value("ratio"), value("zone"),
                                 value("opening"), value("plateau_peak"), value("plateau_ratio"),
                                 value("plateau_zone"));
    }
}

TEST_CASE("write tests/references.json anew", "[.rewrite]") {
    Json all;
    for (const test::ReferenceCase& one : test::bar_cases()) {
        all[one.name] = described(one);
    }
    for (const test::ReferenceCase& one : test::round_cases()) {
        all[one.name] = described(one);
    }
    for (const test::ReferenceCase& one : test::crack_cases()) {
        all[one.name] = described(one);
    }
    std::ofstream file(test::references_file());
    file << all.dump(2) << '\n';
    REQUIRE(file.good());
}
