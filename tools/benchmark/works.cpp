#include "tools/benchmark/works.hpp"

#include "engine/base/random.hpp"

#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace demlua::bench {

namespace {

constexpr double length = 1.5; // m, of the beam
constexpr double depth = 0.25; // m

model::Material concrete() {
    model::Material material;
    material.name = "concrete";
    material.youngs_modulus = 30e9;
    material.poissons_ratio = 0.2;
    material.density = 2400.0;
    material.tensile_strength = 3.44e6;
    material.fracture_toughness = 1e6;
    material.friction = 0.5;
    return material;
}

model::ClosePacking close_packed(double count) {
    const double radius = std::sqrt(length * depth / (count * 2.0 * std::numbers::sqrt3));
    return {radius, model::Rows::horizontal, model::Fit::inside, std::nullopt};
}

model::Relaxation relaxed(double count) {
    model::Relaxation packing;
    packing.count = static_cast<std::uint64_t>(count);
    packing.steps = 20;
    return packing;
}

/// As the penetration bonds its beam.
template <class Bonds>
Bonds touching(Bonds bonds) {
    bonds.network = model::Network::contacts;
    return bonds;
}

template <class Bonds>
model::BondChoice damped(Bonds bonds, double fraction) {
    bonds.damping = fraction;
    return bonds;
}

/// A beam with waves of 2 cm/s in it: about a tenth of the strain at which a bond yields.
Work beam(std::string what, const model::PackingChoice& packing, const model::BondChoice& bonds) {
    Work work;
    work.what = std::move(what);
    work.speed = 0.02;
    work.scene.materials.push_back(concrete());
    model::Body body;
    body.name = "beam";
    body.region = model::Region::rectangle({0.0, 0.0}, {length, depth});
    body.packing = packing;
    body.bonds = bonds;
    work.scene.bodies.push_back(body);
    return work;
}

Work plateau(double count) {
    return beam("close packed, bonds elastic to plateau", close_packed(count), model::PlateauBonds{});
}

Work mixed(Work work) {
    work.what += ", mixed precision";
    work.scene.precision = model::Precision::mixed;
    return work;
}

/// Poisson's ratio 1/3: bonds without shear stiffness, which programs without rotations can follow.
Work central(double count) {
    Work work = beam("close packed, elastic for good, central forces", close_packed(count), model::ElasticBonds{});
    work.scene.materials[0].poissons_ratio = 1.0 / 3.0;
    return work;
}

/// Grains of 5 mm that stand a little apart, each moved and made smaller by up to a tenth of its radius, over a floor
/// between two walls. They have fallen for as long as the uppermost need to meet the rest.
Work grains() {
    constexpr int columns = 120;
    constexpr int rows = 100;
    constexpr double R = 5e-3;
    constexpr double apart = 2.3 * R;
    Work work;
    work.what = "loose disks settling in a box, friction with history, search";
    work.steps_before = 12000;
    model::Material grain = concrete();
    grain.name = "grain";
    grain.youngs_modulus = 1e7;
    grain.density = 2500.0;
    grain.contact_damping = 0.2;
    work.scene.materials.push_back(grain);
    work.scene.gravity = {0.0, -9.81};

    std::uint64_t drawn = 0;
    const auto share = [&] { return 0.1 * uniform(1, 0, drawn++); };
    model::ListedDisks disks;
    for (int row = 0; row < rows; ++row) {
        const double shift = row % 2 == 0 ? 0.6 : 1.1;
        for (int column = 0; column < columns; ++column) {
            const double x = apart * (column + shift) + R * share();
            const double y = apart * (row + 0.6) + R * share();
            disks.disks.push_back({{x, y}, R * (1.0 - share())});
        }
    }
    model::Body body;
    body.name = "grains";
    body.packing = disks;
    work.scene.bodies.push_back(body);

    model::Wall box;
    box.name = "box";
    const double wide = apart * (columns + 0.7);
    const double high = apart * (rows + 1);
    box.path = {{0.0, high}, {0.0, 0.0}, {wide, 0.0}, {wide, high}};
    work.scene.walls.push_back(box);
    return work;
}

using Maker = std::function<Work()>;

const std::vector<std::pair<std::string, Maker>>& makers() {
    static const std::vector<std::pair<std::string, Maker>> all{
        {"bonded_1k", [] { return plateau(1e3); }},
        {"bonded_12k", [] { return plateau(12e3); }},
        {"bonded_100k", [] { return plateau(1e5); }},
        {"bonded_1m", [] { return plateau(1e6); }},
        {"bonded_mixed_12k", [] { return mixed(plateau(12e3)); }},
        {"bonded_mixed_100k", [] { return mixed(plateau(1e5)); }},
        {"elastic_12k",
         [] { return beam("close packed, bonds elastic for good", close_packed(12e3), model::ElasticBonds{}); }},
        {"central_12k", [] { return central(12e3); }},
        {"damped_12k",
         [] { return beam("plateau and dashpots", close_packed(12e3), damped(model::PlateauBonds{}, 0.02)); }},
        {"contacts_12k",
         [] {
             return beam("irregular pack, bonds between what touches, plateau and dashpots", relaxed(12e3),
                         damped(touching(model::PlateauBonds{}), 0.02));
         }},
        {"facets_12k",
         [] {
             return beam("irregular pack, facets and cell pressures, plateau", relaxed(12e3), model::PlateauBonds{});
         }},
        {"facets_mixed_12k",
         [] {
             return mixed(
                 beam("irregular pack, facets and cell pressures, plateau", relaxed(12e3), model::PlateauBonds{}));
         }},
        {"facets_elastic_12k", [] { return beam("the same, elastic for good", relaxed(12e3), model::ElasticBonds{}); }},
        {"cohesive_12k", [] { return beam("the same, cohesive", relaxed(12e3), model::CohesiveBonds{}); }},
        {"grains_12k", grains}};
    return all;
}

} // namespace

std::vector<std::string> names_of_works() {
    std::vector<std::string> names;
    for (const auto& maker : makers()) names.push_back(maker.first);
    return names;
}

Work work_of(const std::string& name) {
    for (const auto& [known, make] : makers()) {
        if (known != name) continue;
        Work work = make();
        work.name = name;
        return work;
    }
    throw std::invalid_argument(
        fmt::format("there is no work \"{}\"; there are {}", name, fmt::join(names_of_works(), ", ")));
}

} // namespace demlua::bench
