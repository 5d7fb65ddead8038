// References of finite elements, computed again and compared with tests/references.json.
//
//   demlua_tests "[.rewrite]"    writes the file anew
#include "tests/catch.hpp"
#include "tests/reference_cases.hpp"
#include "tests/references.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
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

TEST_CASE("write tests/references.json anew", "[.rewrite]") {
    Json all;
    for (const test::ReferenceCase& one : test::bar_cases()) {
        all[one.name] = described(one);
    }
    for (const test::ReferenceCase& one : test::round_cases()) {
        all[one.name] = described(one);
    }
    std::ofstream file(test::references_file());
    file << all.dump(2) << '\n';
    REQUIRE(file.good());
}
