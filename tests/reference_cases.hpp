// The bodies whose deformation the discrete element engine is compared with, solved by finite elements on two meshes.
// Their numbers stand in tests/references.json; docs/theory/references.md explains them.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace demlua::test {

struct Quantity {
    std::string name;
    std::string meaning; // with its unit where E, length, load and density are not all one
    double value;
    std::optional<double> closed_form; // of this very quantity
};

struct ReferenceCase {
    std::string name;
    std::string geometry;
    std::string material;
    std::string support;
    std::string load;
    std::array<int, 2> cells; // mesh parameter, coarse and fine: half the size
    std::function<std::string(int cells)> mesh;
    std::function<std::vector<Quantity>(int cells)> solve;
};

/// Cantilevers, straight and slanted; bars under uniform tension across the axes.
std::vector<ReferenceCase> bar_cases();

/// Notched bodies with a cohesive zone; minutes for all of them.
std::vector<ReferenceCase> crack_cases();

/// A ring and a disc squeezed across a diameter.
std::vector<ReferenceCase> round_cases();

} // namespace demlua::test
