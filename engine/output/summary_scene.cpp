#include "engine/output/summary.hpp"

#include "engine/model/derived_law.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <type_traits>

namespace demlua::output {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
void put(Json& json, const char* name, const std::optional<T>& value) {
    if (value) json[name] = *value;
}

Json pair_json(Vec2 value) { return Json::array({value.x, value.y}); }

Json material_json(const model::Material& material) {
    Json json{{"name", material.name},
              {"youngs_modulus", material.youngs_modulus},
              {"poissons_ratio", material.poissons_ratio},
              {"density", material.density}};
    put(json, "tensile_strength", material.tensile_strength);
    put(json, "fracture_toughness", material.fracture_toughness);
    put(json, "fracture_energy", material.fracture_energy);
    json["rate_factor"] = material.rate_factor;
    json["friction"] = material.friction;
    put(json, "restitution", material.restitution);
    put(json, "contact_damping", material.contact_damping);
    return json;
}

Json packing_json(const std::monostate& /*none*/) { return nullptr; }

Json packing_json(const model::ClosePacking& packing) {
    Json json{{"kind", "close_packed"},
              {"radius", packing.radius},
              {"rows", packing.rows == model::Rows::horizontal ? "horizontal" : "vertical"},
              {"fit", packing.fit == model::Fit::inside ? "inside" : "centres"}};
    if (packing.origin) json["origin"] = pair_json(*packing.origin);
    return json;
}

Json packing_json(const model::Consolidation& packing) {
    return {{"kind", "consolidated"},
            {"cluster", packing.cluster},
            {"count", packing.count},
            {"radius", packing.radius},
            {"solid_fraction", packing.solid_fraction},
            {"relax", packing.relax},
            {"seed", packing.seed}};
}

Json packing_json(const model::Relaxation& packing) {
    Json json{{"kind", "relaxed"},
              {"steps", packing.steps},
              {"on_boundary", packing.on_boundary},
              {"graded", static_cast<bool>(packing.size)},
              {"seed", packing.seed}};
    if (packing.count > 0) json["count"] = packing.count;
    if (packing.spacing > 0.0) json["spacing"] = packing.spacing;
    return json;
}

Json packing_json(const model::ListedDisks& packing) { return {{"kind", "disks"}, {"count", packing.disks.size()}}; }

Json packing_json(const model::GrainPacking& packing) {
    constexpr std::array names{"consolidation", "insertion", "rain"}; // as the alternatives of Placing
    Json json{{"kind", "grains"},
              {"method", names.at(static_cast<std::size_t>(packing.method))},
              {"elements", packing.disks.empty() ? static_cast<std::size_t>(packing.elements) : packing.disks.size()},
              {"removed", packing.removed},
              {"seed", packing.seed}};
    for (const model::SizeClass& each : packing.sizes) {
        json["radius"].push_back({{"least", each.least}, {"greatest", each.greatest}, {"share", each.share}});
    }
    put(json, "porosity", packing.porosity);
    if (packing.count > 0) json["count"] = packing.count;
    return json;
}

Json bonds_json(const model::NoBonds& /*none*/) { return {{"law", "none"}}; }

template <class Choice>
Json bonds_json(const Choice& bonds) {
    Json json{{"law", model::LawOf<Choice>::name}, {"search", bonds.search}, {"damping", bonds.damping}};
    if constexpr (std::is_same_v<Choice, model::PlateauBonds>) json["break_in_shear"] = bonds.break_in_shear;
    if constexpr (model::takes_rates<Choice>) {
        put(json, "rate_compressive_strength", bonds.rate_compressive_strength);
        put(json, "rate_window", bonds.rate_window);
    }
    return json;
}

Json body_json(const model::Body& body, const model::Scene& scene, std::size_t count) {
    Json json{{"name", body.name}, {"elements", count}};
    json["material"] = scene.materials.at(body.material).name;
    json["packing"] = std::visit([](const auto& packing) { return packing_json(packing); }, body.packing);
    json["bonds"] = std::visit([](const auto& bonds) { return bonds_json(bonds); }, body.bonds);
    json["velocity"] = pair_json(body.velocity);
    json["spin"] = body.spin;
    json["rigid"] = body.rigid;
    if (body.in_clusters) json["in_clusters"] = true;
    return json;
}

/// Seeds by body, of the packings that draw random numbers.
Json seeds_json(const model::Scene& scene) {
    Json json = Json::object();
    for (const auto& body : scene.bodies) {
        if (const auto* pressed = std::get_if<model::Consolidation>(&body.packing)) json[body.name] = pressed->seed;
        if (const auto* even = std::get_if<model::Relaxation>(&body.packing)) json[body.name] = even->seed;
        if (const auto* loose = std::get_if<model::GrainPacking>(&body.packing)) json[body.name] = loose->seed;
    }
    return json;
}

Json counts_json(const model::Scene& scene) {
    return {{"supports", scene.supports.size()},
            {"motions", scene.motions.size()},
            {"forces", scene.forces.size()},
            {"tractions", scene.tractions.size()},
            {"walls", scene.walls.size()},
            {"outlines", scene.outlines.size()},
            {"notches", scene.notches.size()},
            {"probes", scene.probes.size()},
            {"bond_probes", scene.bond_probes.size()}};
}

const char* name_of(model::StepRule rule) {
    if (rule == model::StepRule::sharp) return "sharp";
    return rule == model::StepRule::bound ? "bound" : "paper";
}

/// Counted by selecting each body's elements, as a probe would.
std::vector<std::size_t> body_counts(const model::Scene& scene, const observe::Simulation& simulation) {
    std::vector<std::size_t> counts;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        model::Selection selection;
        selection.body = body;
        counts.push_back(simulation.field("radius", selection).size());
    }
    return counts;
}

} // namespace

std::string inputs_json(const model::Scene& scene, const observe::Simulation& simulation) {
    const auto counts = body_counts(scene, simulation);
    Json json;
    json["title"] = scene.title;
    json["plane"] = scene.plane == model::Plane::stress ? "stress" : "strain";
    json["thickness"] = scene.thickness;
    json["gravity"] = pair_json(scene.gravity);
    json["time_step"] = name_of(scene.time_step);
    json["step_fraction"] = scene.step_fraction;
    json["precision"] = scene.precision == model::Precision::full ? "double" : "mixed";
    json["seeds"] = seeds_json(scene);
    json["materials"] = Json::array();
    for (const auto& material : scene.materials) json["materials"].push_back(material_json(material));
    json["bodies"] = Json::array();
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        json["bodies"].push_back(body_json(scene.bodies[k], scene, counts[k]));
    }
    if (!scene.dampings.empty()) {
        const auto& damping = scene.dampings.back();
        Json& entry = json["damping"] = {{"fraction", damping.fraction}, {"frequency", damping.frequency}};
        put(entry, "second_fraction", damping.second_fraction);
        put(entry, "second_frequency", damping.second_frequency);
    }
    json["counts"] = counts_json(scene);
    return json.dump();
}

} // namespace demlua::output
