#include "engine/model/check_fracture.hpp"

#include "engine/model/derived_law.hpp"
#include "engine/model/setting.hpp"
#include "engine/model/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <type_traits>
#include <utility>

namespace demlua::model {

namespace {

/// Asks `use` with the choice of a body's bonds, unless it has none; gives `otherwise` then.
template <class Result, class Use>
Result with_bonds(const Body& body, Result otherwise, const Use& use) {
    return std::visit(
        [&](const auto& bonds) -> Result {
            if constexpr (std::is_same_v<std::decay_t<decltype(bonds)>, NoBonds>)
                return otherwise;
            else
                return use(bonds);
        },
        body.bonds);
}

/// As the scene writes it: dem.plateau; "no bonds" without.
std::string law_name(const Body& body) {
    return with_bonds(body, std::string("no bonds"), [](const auto& bonds) {
        return std::string("dem.") + LawOf<std::decay_t<decltype(bonds)>>::name;
    });
}

/// A law for facets alone takes no other network.
void check_facets_only(const Body& body, std::vector<Problem>& problems) {
    const Network said = with_bonds(
        body, Network::facets, [](const auto& bonds) { return bonds.facets_only ? bonds.network : Network::facets; });
    if (said == Network::automatic || said == Network::facets) return;
    problems.push_back({body.place, law_name(body).substr(4) + ".stiffness",
                        '"' + words::network_names()[static_cast<std::size_t>(said)] + '"',
                        "cannot be: this law needs the facets of cells", R"(leave it away, or say "facets")"});
}

bool can_break(const Body& body) {
    return network_of(body) &&
           with_bonds(body, false, [](const auto& bonds) { return LawOf<std::decay_t<decltype(bonds)>>::breaks; });
}

/// Toughness and energy are two ways of saying the same.
void check_agreement(const Material& material, Plane plane, std::vector<Problem>& problems) {
    constexpr double agreement = 1e-6;
    if (!material.fracture_toughness || !material.fracture_energy) return;
    const law::PlaneModuli moduli = plane_moduli_of(material, plane);
    const double energy = law::fracture_energy(*material.fracture_toughness, moduli);
    if (std::abs(*material.fracture_energy - energy) <= agreement * energy) return;
    problems.push_back({material.place, "material.fracture_energy", text_of(*material.fracture_energy),
                        fmt::format("contradicts fracture_toughness = {}, which means {:.9g} J/m^2",
                                    text_of(*material.fracture_toughness), energy),
                        fmt::format("give one of them; this energy means a toughness of {:.9g} Pa m^0.5",
                                    law::fracture_toughness(*material.fracture_energy, moduli))});
}

/// What the law of a body's bonds needs and its material does not say, as names of settings.
std::vector<std::string> missing_settings(const Body& body, const Material& material) {
    return with_bonds(body, std::vector<std::string>{}, [&](const auto& bonds) {
        std::vector<std::string> missing;
        if (bonds.needs_strength && !material.tensile_strength) missing.emplace_back("tensile_strength");
        if (bonds.needs_toughness && !material.fracture_toughness && !material.fracture_energy) {
            missing.emplace_back("fracture_toughness or fracture_energy");
        }
        return missing;
    });
}

/// Strain-rate factors that nothing asks for, or that would count twice.
void check_rates(const Body& body, const Material& material, std::vector<Problem>& problems) {
    with_bonds(body, false, [&](const auto& bonds) {
        if constexpr (takes_rates<std::decay_t<decltype(bonds)>>) {
            const std::string word = law_name(body).substr(4);
            if (bonds.rate_window && !bonds.rate_compressive_strength) {
                problems.push_back({body.place, word + ".rate_window", text_of(*bonds.rate_window),
                                    "does nothing without " + word + ".rate_compressive_strength", ""});
            }
            if (bonds.rate_compressive_strength && material.rate_factor != 1.0) {
                problems.push_back({body.place, word + ".rate_compressive_strength",
                                    text_of(*bonds.rate_compressive_strength),
                                    "would count strain rates twice: material \"" + material.name +
                                        "\" has a rate_factor of " + text_of(material.rate_factor),
                                    "leave one of them away"});
            }
        }
        return true;
    });
}

/// Radius of a body's elements where its settings say it.
std::optional<double> radius_said(const Body& body) {
    if (const auto* close = std::get_if<ClosePacking>(&body.packing)) return close->radius;
    if (const auto* pressed = std::get_if<Consolidation>(&body.packing)) {
        if (pressed->radius > 0.0) return pressed->radius;
    }
    return std::nullopt;
}

void check_bonds(const Scene& scene, const Body& body, std::vector<Problem>& problems) {
    check_facets_only(body, problems);
    const std::optional<Network> network = network_of(body);
    if (!network || body.material >= scene.materials.size()) return;
    const Material& material = scene.materials[body.material];
    const std::vector<std::string> missing = missing_settings(body, material);
    check_rates(body, material, problems);
    for (const std::string& setting : missing) {
        problems.push_back({body.place, "body.bonds", law_name(body),
                            "needs " + setting + " in material \"" + material.name + '"', ""});
    }
    const std::optional<double> radius = radius_said(body);
    if (!missing.empty() || !radius) return;
    // Cells of irregular packs differ: theirs are looked at once they are there.
    if (*network == Network::facets && !std::holds_alternative<ClosePacking>(body.packing)) return;
    const double size = *network == Network::facets ? 2.0 * *radius : *radius;
    if (std::optional<Problem> problem = unresolved_bonds(scene, body, *network, size)) {
        problems.push_back(std::move(*problem));
    }
}

/// Whether the straight line stays outside the region: walked in steps as long as the way to the nearest boundary.
bool stays_outside(const Region& region, Vec2 from, Vec2 to) {
    const double length = norm(to - from);
    const double touching = 1e-6 * length;
    for (double gone = 0.0; gone <= length;) {
        const double distance = region.distance(from + (gone / length) * (to - from));
        if (distance <= touching) return false;
        gone += distance;
    }
    return true;
}

void check_notch(const Scene& scene, const Notch& notch, std::vector<Problem>& problems) {
    if (notch.from == notch.to) {
        problems.push_back({notch.place, "notch.to", "", "must differ from notch.from", ""});
        return;
    }
    if (notch.body >= scene.bodies.size()) return;
    const Body& body = scene.bodies[notch.body];
    const std::string name = '"' + body.name + '"';
    if (!can_break(body)) {
        const std::string has = body.rigid ? "is rigid" : "has " + law_name(body);
        problems.push_back({notch.place, "notch.body", name, "must have bonds that can break, but " + has,
                            "a law such as dem.plateau lets bonds be cut"});
        return;
    }
    if (body.region.bounds().empty() || !stays_outside(body.region, notch.from, notch.to)) return;
    problems.push_back({notch.place, "notch",
                        fmt::format("({}, {}) to ({}, {}) m", notch.from.x, notch.from.y, notch.to.x, notch.to.y),
                        "lies outside body " + name, ""});
}

} // namespace

std::optional<Problem> unresolved_bonds(const Scene& scene, const Body& body, Network network, double size) {
    const Matter matter = matter_of(scene.materials.at(body.material), scene.plane, scene.thickness);
    const bool facets = network == Network::facets;
    const double largest = with_bonds(body, size, [&](const auto& bonds) {
        using Law = LawOf<std::decay_t<decltype(bonds)>>;
        if constexpr (Law::yields) {
            const DerivedLaw<Law> law = derived(bonds, matter);
            if (!facets) return Law::largest_radius(law.params);
            // A uniform stress stretches a bond of length l by l/E* of it, and shears it by l/2G.
            const law::ContactStiffness uniform{matter.moduli.youngs_modulus * matter.thickness,
                                                law::facet_moduli(matter.moduli).twice_shear * matter.thickness};
            return Law::largest_radius(Law::on_facet(law.tractions, uniform, 1.0, 1.0));
        } else {
            return size;
        }
    });
    if (!(size > largest)) return std::nullopt;
    return Problem{body.place, "body.bonds", law_name(body),
                   fmt::format("cannot be resolved by {} {:.6g} m: bonds would store more than their fracture energy "
                               "before they yield (delta_max < delta_crit)",
                               facets ? "elements that stand apart by" : "elements of radius", size),
                   fmt::format("the largest {} is {:.6g} m", facets ? "distance" : "radius", largest)};
}

std::vector<Problem> fracture_problems(const Scene& scene) {
    std::vector<Problem> problems;
    for (const Material& material : scene.materials) check_agreement(material, scene.plane, problems);
    for (const Body& body : scene.bodies) check_bonds(scene, body, problems);
    for (const Notch& notch : scene.notches) check_notch(scene, notch, problems);
    return problems;
}

} // namespace demlua::model
