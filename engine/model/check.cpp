#include "engine/model/check.hpp"

#include "engine/model/check_fracture.hpp"
#include "engine/model/check_grains.hpp"
#include "engine/model/check_walls.hpp"
#include "engine/model/findings.hpp"
#include "engine/model/setting.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <type_traits>
#include <utility>

namespace demlua::model {

std::optional<Network> network_of(const Body& body) {
    if (body.rigid) return std::nullopt;
    const auto chosen = std::visit(
        [](const auto& bonds) -> std::optional<Network> {
            if constexpr (std::is_same_v<std::decay_t<decltype(bonds)>, NoBonds>)
                return std::nullopt;
            else
                return bonds.facets_only ? Network::facets : bonds.network;
        },
        body.bonds);
    if (chosen != Network::automatic) return chosen;
    if (std::holds_alternative<ClosePacking>(body.packing)) return Network::unit_cell;
    const bool fills = !body.in_clusters && !std::holds_alternative<ListedDisks>(body.packing);
    return fills ? Network::facets : Network::contacts;
}

namespace {

std::string quoted(const std::string& text) { return '"' + text + '"'; }

void check_material(const Material& material, Findings& findings) {
    if (material.restitution && material.contact_damping) {
        findings.add(material.place, "material.contact_damping", text_of(*material.contact_damping),
                     "must not be given beside restitution", "each follows from the other");
    }
}

void check_contact(const ContactRule& rule, Findings& findings) {
    if (rule.restitution && rule.contact_damping) {
        findings.add(rule.place, "contact.contact_damping", text_of(*rule.contact_damping),
                     "must not be given beside restitution", "each follows from the other");
    }
}

/// Poisson's ratio must suit every network made of the material.
void check_poissons_ratio(const Scene& scene, std::size_t row, Findings& findings) {
    const Material& material = scene.materials[row];
    const double limit = scene.plane == Plane::stress ? 1.0 / 3.0 : 0.25;
    bool pairs = false;
    bool facets = false;
    for (const Body& body : scene.bodies) {
        if (body.material != row) continue;
        const std::optional<Network> network = network_of(body);
        facets = facets || network == Network::facets;
        pairs = pairs || (network && network != Network::facets);
    }
    if (pairs && material.poissons_ratio > limit) {
        findings.add(material.place, "material.poissons_ratio", text_of(material.poissons_ratio),
                     scene.plane == Plane::stress ? "must be at most 1/3 in plane stress"
                                                  : "must be at most 1/4 in plane strain",
                     R"(beyond it bonds would need a negative shear stiffness; stiffness = "facets" takes more)");
    }
    if (facets && material.poissons_ratio < 0.0) {
        findings.add(material.place, "material.poissons_ratio", text_of(material.poissons_ratio),
                     R"(must not be negative with stiffness = "facets")");
    }
}

/// A disk of this radius cannot lie inside a box narrower than its diameter, whatever the region in it.
void check_room(const Body& body, double radius, Findings& findings) {
    const Vec2 size = body.region.bounds().size();
    if (radius <= 0.0 || (size.x >= 2.0 * radius && size.y >= 2.0 * radius)) return;
    findings.add(body.place, "body.region", text_of(size.x) + " m by " + text_of(size.y) + " m",
                 "is too small for one element of radius " + text_of(radius) + " m");
}

void check_consolidation(const Body& body, const Consolidation& packing, Findings& findings) {
    if ((packing.count == 0) == (packing.radius == 0.0)) {
        findings.add(body.place, "consolidated.count", packing.count == 0 ? "" : std::to_string(packing.count),
                     "exactly one of count and radius must be given");
    }
    check_room(body, packing.radius, findings);
}

void check_network(const Body& body, Findings& findings) {
    const std::optional<Network> network = network_of(body);
    if (!network || !body.region.bounds().empty()) return;
    if (*network == Network::facets || *network == Network::delaunay) {
        findings.add(body.place, "body.bonds", *network == Network::facets ? "\"facets\"" : "\"delaunay\"",
                     "needs the body's region, which its cells share out");
    }
}

/// A place of the region where nobody would forget to define something: its middle, or else on its boundary.
Vec2 some_place(const Region& region) {
    const Box box = region.bounds();
    const Vec2 middle = 0.5 * (box.lower + box.upper);
    if (region.contains(middle)) return middle;
    const Piece& piece = region.boundary().front();
    return piece.at(0.5 * (piece.begin + piece.end));
}

void check_relaxation(const Body& body, const Relaxation& packing, Findings& findings) {
    const int given = (packing.count > 0 ? 1 : 0) + (packing.spacing > 0.0 ? 1 : 0) + (packing.size ? 1 : 0);
    if (given != 1) {
        findings.add(body.place, "relaxed.count", packing.count == 0 ? "" : std::to_string(packing.count),
                     "exactly one of count, spacing and size must be given");
    }
    if (!packing.size) return;
    try {
        packing.size(some_place(body.region));
    } catch (const SceneError& error) {
        findings.problems.insert(findings.problems.end(), error.problems().begin(), error.problems().end());
    }
}

void check_packing(const Body& body, Findings& findings) {
    if (std::holds_alternative<std::monostate>(body.packing)) {
        findings.add(body.place, "body.packing", "", "is missing: a body without packing has no elements");
        return;
    }
    if (std::holds_alternative<ListedDisks>(body.packing)) return;
    const Box box = body.region.bounds();
    if (box.empty()) {
        findings.add(body.place, "body.region", "", "is missing or empty; only dem.disks needs none");
        return;
    }
    if (!std::isfinite(box.size().x) || !std::isfinite(box.size().y)) {
        findings.add(body.place, "body.region", "", "has no end; cut it with a * b where b is finite");
        return;
    }
    if (const auto* close = std::get_if<ClosePacking>(&body.packing)) {
        if (close->fit == Fit::inside) check_room(body, close->radius, findings);
    }
    if (const auto* pressed = std::get_if<Consolidation>(&body.packing)) {
        check_consolidation(body, *pressed, findings);
    }
    if (const auto* even = std::get_if<Relaxation>(&body.packing)) check_relaxation(body, *even, findings);
    if (const auto* loose = std::get_if<GrainPacking>(&body.packing)) findings.add(grain_problems(body, *loose));
}

bool selects_nothing(const Selection& selection) { return !selection.body && !selection.within && !selection.where; }

void check_selection(const Selection& selection, const std::string& word, const Place& place, Findings& findings) {
    if (!selects_nothing(selection)) return;
    findings.add(place, word, "", "selects nothing: give a body, a side, within or where");
}

void check_motion(const Motion& motion, Findings& findings) {
    check_selection(motion.selection, "move", motion.place, findings);
    check_signal(motion.velocity_x, "move.velocity_x", motion.place, findings);
    check_signal(motion.velocity_y, "move.velocity_y", motion.place, findings);
    check_signal(motion.displacement_x, "move.displacement_x", motion.place, findings);
    check_signal(motion.displacement_y, "move.displacement_y", motion.place, findings);
    check_signal(motion.spin, "move.spin", motion.place, findings);
    if (motion.velocity_x && motion.displacement_x) {
        findings.add(motion.place, "move.displacement_x", "", "must not be given beside velocity_x");
    }
    if (motion.velocity_y && motion.displacement_y) {
        findings.add(motion.place, "move.displacement_y", "", "must not be given beside velocity_y");
    }
    if (!motion.velocity_x && !motion.velocity_y && !motion.displacement_x && !motion.displacement_y && !motion.spin) {
        findings.add(motion.place, "move", "", "prescribes nothing: give velocity, displacement or spin");
    }
}

void check_force(const Force& force, Findings& findings) {
    check_selection(force.selection, "force", force.place, findings);
    check_signal(force.x, "force.x", force.place, findings);
    check_signal(force.y, "force.y", force.place, findings);
}

void check_traction(const Traction& traction, Findings& findings) {
    if (!traction.selection.body || !traction.selection.side) {
        findings.add(traction.place, "traction.selection", "", "must name a side of a body, such as plate.top");
    }
    check_signal(traction.stress_x, "traction.stress_x", traction.place, findings);
    check_signal(traction.stress_y, "traction.stress_y", traction.place, findings);
}

/// Bonds that never break would hold what wear takes out of its cluster.
void check_wear(const Scene& scene, const Body& body, Findings& findings) {
    const Material& material = scene.materials[body.material];
    if (!material.wear_energy_density || !body.in_clusters || body.rigid) return;
    if (!std::holds_alternative<ElasticBonds>(body.bonds)) return;
    findings.add(body.place, "body.bonds", "\"elastic\"",
                 "must be able to break, for the material has a wear_energy_density",
                 "take another law, or rigid clusters");
}

void check_periodic(const Scene& scene, Findings& findings) {
    if (!scene.periodic_x || scene.periodic_x->y > scene.periodic_x->x) return;
    findings.add(scene.place, "simulation.periodic_x",
                 text_of(scene.periodic_x->x) + ", " + text_of(scene.periodic_x->y),
                 "must be the left edge and then the right one");
}

void check_damping(const Damping& damping, Findings& findings) {
    if (damping.second_fraction && !damping.second_frequency) {
        findings.add(damping.place, "damping.second_frequency", "", "is missing: it goes with second_fraction");
    }
    if (damping.second_frequency && !damping.second_fraction) {
        findings.add(damping.place, "damping.second_fraction", "", "is missing: it goes with second_frequency");
    }
    if (damping.second_frequency && *damping.second_frequency == damping.frequency) {
        findings.add(damping.place, "damping.second_frequency", text_of(damping.frequency),
                     "must differ from frequency");
    }
}

void check_probe(const Probe& probe, const std::vector<std::string>& measurable, Findings& findings) {
    if (std::find(measurable.begin(), measurable.end(), probe.measure) != measurable.end()) return;
    findings.add(probe.place, "probe.measure", quoted(probe.measure), "is not a field of elements",
                 did_you_mean(probe.measure, measurable));
}

void check_bond_probe(const BondProbe& probe, const Scene& scene, Findings& findings) {
    if (probe.at.has_value() == probe.between.has_value()) {
        findings.add(probe.place, "bond_probe.at", "", "exactly one of at and between must be given");
    }
    if (probe.body >= scene.bodies.size()) return;
    const Body& body = scene.bodies[probe.body];
    if (!network_of(body)) findings.add(probe.place, "bond_probe.body", quoted(body.name), "has no bonds");
}

double side_of(Vec2 a, Vec2 b, Vec2 point) { return cross(b - a, point - a); }

bool in_box_of(Vec2 a, Vec2 b, Vec2 point) {
    return std::min(a.x, b.x) <= point.x && point.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= point.y &&
           point.y <= std::max(a.y, b.y);
}

/// Whether two closed segments have a point in common.
bool meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const double c_side = side_of(a, b, c);
    const double d_side = side_of(a, b, d);
    const double a_side = side_of(c, d, a);
    const double b_side = side_of(c, d, b);
    if (c_side * d_side < 0.0 && a_side * b_side < 0.0) return true;
    return (c_side == 0.0 && in_box_of(a, b, c)) || (d_side == 0.0 && in_box_of(a, b, d)) ||
           (a_side == 0.0 && in_box_of(c, d, a)) || (b_side == 0.0 && in_box_of(c, d, b));
}

} // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    const std::string nearest = nearest_word(word, known);
    // Between words of one letter everything is near.
    return nearest.size() < 2 || word.size() < 2 ? std::string{} : "did you mean " + quoted(nearest) + "?";
}

std::string polygon_fault(const std::vector<Vec2>& corners) {
    const std::size_t n = corners.size();
    if (n < 3) return "must have at least three corners";
    for (std::size_t i = 0; i < n; ++i) {
        if (corners[i] == corners[(i + 1) % n]) {
            return "corner " + std::to_string((i + 1) % n + 1) + " must differ from the one before it";
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j + 1 == n) continue; // the first side and the last share a corner
            if (!meet(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n])) continue;
            return "sides must not cross: those after corners " + std::to_string(i + 1) + " and " +
                   std::to_string(j + 1) + " do";
        }
    }
    return {};
}

std::vector<Problem> check(const Scene& scene, const std::vector<std::string>& measurable) {
    Findings findings;
    for (std::size_t row = 0; row < scene.materials.size(); ++row) {
        check_material(scene.materials[row], findings);
        check_poissons_ratio(scene, row, findings);
    }
    for (const ContactRule& rule : scene.contact_rules) check_contact(rule, findings);
    for (const Body& body : scene.bodies) {
        check_packing(body, findings);
        check_network(body, findings);
        if (body.material < scene.materials.size()) check_wear(scene, body, findings);
        findings.add(cluster_problems(body));
    }
    check_periodic(scene, findings);
    for (const Support& support : scene.supports) check_selection(support.selection, "fix", support.place, findings);
    for (const Motion& motion : scene.motions) check_motion(motion, findings);
    for (const Force& force : scene.forces) check_force(force, findings);
    for (const Traction& traction : scene.tractions) check_traction(traction, findings);
    check_walls(scene, findings);
    for (Problem& problem : fracture_problems(scene)) findings.problems.push_back(std::move(problem));
    for (const Damping& damping : scene.dampings) check_damping(damping, findings);
    for (const Probe& probe : scene.probes) check_probe(probe, measurable, findings);
    for (const BondProbe& probe : scene.bond_probes) check_bond_probe(probe, scene, findings);
    check_names(scene.bodies, "body", findings);
    check_wall_names(scene, findings);
    check_names(scene.probes, "probe", findings);
    check_names(scene.bond_probes, "bond_probe", findings);
    return std::move(findings.problems);
}

} // namespace demlua::model
