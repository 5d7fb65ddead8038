// Notched bodies: the highest load with a cohesive zone and that of the handbook.
#include "tests/cohesive_crack.hpp"
#include "tests/handbook.hpp"
#include "tests/reference_cases.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace demlua::test {

namespace {

/// A shape of body, with what its handbook formula calls share.
struct Family {
    const char* name;
    const char* geometry; // of width c
    NotchedBody (*body)(double c, double share);
    double (*shape)(double share);
};

NotchedBody edge(double c, double share) { return {.notch = share * c, .width = c, .half_height = 2.0 * c}; }

NotchedBody centre(double c, double share) {
    return {.notch = 0.5 * share * c, .width = 0.5 * c, .half_height = 2.0 * c, .mirror_at_start = true};
}

NotchedBody double_edge(double c, double share) {
    return {.notch = 0.5 * share * c, .width = 0.5 * c, .half_height = 2.0 * c, .mirror_at_end = true};
}

NotchedBody bent(double c, double share) {
    return {.notch = share * c, .width = c, .half_height = 2.25 * c, .load = NotchedBody::Load::bending};
}

constexpr Family edge_family{"edge_crack", "plate c x 4 c, a crack of length a from one edge at half height", edge,
                             handbook::edge_crack};
constexpr Family centre_family{"centre_crack", "plate c x 4 c, a crack of length 2 a in the middle", centre,
                               handbook::centre_crack};
constexpr Family double_edge_family{"double_edge_crack",
                                    "plate c x 4 c, cracks of length a from both edges at half height", double_edge,
                                    handbook::double_edge_crack};
constexpr Family bend_family{"three_point_bend",
                             "beam 4.5 c x c, a crack of length a from the lower side under the force", bent,
                             handbook::three_point_bend};

std::vector<Quantity> failure(const Family& family, double c, double share, int cells) {
    const NotchedBody body = family.body(c, share);
    const Ligament ligament = condense(body, {.cell = 1.0 / cells, .reach = 4.0, .growth = 1.3});
    const Growth linear = peak(grow(ligament, Softening::linear), Softening::linear);
    const Growth plateau = peak(grow(ligament, Softening::plateau), Softening::plateau);
    const double toughness = std::sqrt(handbook::pi);
    const double fragile = handbook::critical_stress(toughness, body.notch, family.shape(share));
    return {
        {"peak", "highest load over the strength, traction falling linearly", linear.load, {}},
        {"handbook", "load at K_I = K_Ic over the strength", fragile, {}},
        {"ratio", "peak over handbook", linear.load / fragile, {}},
        {"zone", "length of the cohesive zone at the peak, in a_t", linear.tip - linear.zone_from, {}},
        {"opening", "at the notch at the peak, over that without traction", linear.opening / (2.0 * handbook::pi), {}},
        {"plateau_peak", "highest load over the strength, constant traction", plateau.load, {}},
        {"plateau_ratio", "plateau_peak over handbook", plateau.load / fragile, {}},
        {"plateau_zone", "length of its zone at the peak, in a_t", plateau.tip - plateau.zone_from, {}}};
}

ReferenceCase crack(const Family& family, double c, double share) {
    const bool bent = family.body == bend_family.body;
    const char* ratio = family.body == edge_family.body || bent ? "a" : "2 a";
    return {fmt::format("cohesive_{}_c{}_{}", family.name, c, share),
            fmt::format("{}; c = {} a_t, {} / c = {}", family.geometry, c, ratio, share),
            "nu = 0.3, plane stress, strength s, K_Ic; length in a_t = (K_Ic / s)^2 / pi",
            bent ? "rollers at a span of 4 c" : "rigid motions only",
            bent ? "a force midway; load: 6 M / c^2" : "uniform tension on both ends; load: that tension",
            {10, 20},
            [](int cells) { return fmt::format("nine-node cells of 1 / {} a_t over 4 a_t ahead of the notch", cells); },
            [=](int cells) { return failure(family, c, share, cells); }};
}

} // namespace

std::vector<ReferenceCase> crack_cases() {
    std::vector<ReferenceCase> cases{crack(edge_family, 8.0, 0.125)};
    for (const double c : {9.3, 25.0, 50.0, 100.0}) {
        for (const double share : {0.125, 0.25, 0.5}) {
            cases.push_back(crack(edge_family, c, share));
        }
    }
    for (const Family& family : {centre_family, double_edge_family}) {
        for (const double c : {25.0, 50.0, 100.0}) {
            for (const double share : {0.25, 0.5}) {
                cases.push_back(crack(family, c, share));
            }
        }
    }
    for (const double c : {25.0, 50.0, 100.0}) {
        for (const double share : {0.3, 0.5}) {
            cases.push_back(crack(bend_family, c, share));
        }
    }
    return cases;
}

} // namespace demlua::test
