// Small scenes that several tests start from.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/observe/simulation.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace demlua::test {

/// Concrete of Tavarez & Plesha 2007, section 8.
inline model::Material concrete() {
    model::Material material;
    material.name = "concrete";
    material.youngs_modulus = 29.7e9;
    material.poissons_ratio = 0.3;
    material.density = 2400.0;
    material.tensile_strength = 3.44e6;
    material.fracture_toughness = 1.0e6;
    material.friction = 0.5;
    return material;
}

inline model::Scene scene_of(const model::Material& material) {
    model::Scene scene;
    scene.materials.push_back(material);
    return scene;
}

/// A body of disks put down one by one.
inline model::Body disks(const std::string& name, const std::vector<model::Disk>& list,
                         const model::BondChoice& bonds) {
    model::Body body;
    body.name = name;
    body.packing = model::ListedDisks{list};
    body.bonds = bonds;
    return body;
}

/// A close-packed rectangle with its lower left corner at `at`, rows horizontal, disks inside.
inline model::Body block(const std::string& name, Vec2 at, Vec2 size, double radius, const model::BondChoice& bonds) {
    model::Body body;
    body.name = name;
    body.region = model::Region::rectangle(at, size);
    body.packing = model::ClosePacking{radius, model::Rows::horizontal, model::Fit::inside, std::nullopt};
    body.bonds = bonds;
    return body;
}

inline model::Selection all_of(std::size_t body) {
    model::Selection selection;
    selection.body = body;
    return selection;
}

inline model::Selection side_of(std::size_t body, model::Side side) {
    model::Selection selection = all_of(body);
    selection.side = side;
    return selection;
}

/// Two bonded disks of the given radius in contact: the first held, the second given this displacement along x.
inline model::Scene pulled_pair(const model::BondChoice& bonds, double radius, const Signal& along) {
    model::Scene scene = scene_of(concrete());
    scene.bodies.push_back(disks("pair", {{{0.0, 0.0}, radius}, {{2.0 * radius, 0.0}, radius}}, bonds));
    model::Support held;
    held.selection = all_of(0);
    held.selection.where = [radius](Vec2 at) { return at.x < radius; };
    scene.supports.push_back(held);
    model::Motion motion;
    motion.selection = all_of(0);
    motion.selection.where = [radius](Vec2 at) { return at.x > radius; };
    motion.displacement_x = along;
    motion.velocity_y = Signal::constant(0.0);
    motion.spin = Signal::constant(0.0);
    scene.motions.push_back(motion);
    return scene;
}

/// Looks at the simulation every `every` seconds.
template <class Look>
observe::Watcher watching(double every, Look look) {
    return {every, std::move(look)};
}

} // namespace demlua::test
