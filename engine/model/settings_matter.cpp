// Rows of what a scene is made of: the simulation, materials, regions, packings, bodies.
#include "engine/model/rows.hpp"
#include "engine/model/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace demlua::model::words {

using namespace rows;

namespace {

constexpr Range ratio{"must lie between -1 and 0.5", [](double v) { return v > -1.0 && v < 0.5; }};
constexpr Range step_share{"must be above 0 and below 1", [](double v) { return v > 0.0 && v < 1.0; }};
constexpr Range solid{"must be above 0 and at most 0.9", [](double v) { return v > 0.0 && v <= 0.9; }};
constexpr Range number_of_cluster{"must be a whole number from 0 on",
                                  [](double v) { return v >= 0.0 && v < 4294967295.0 && v == std::floor(v); }};
constexpr Range cluster_size{"must be 1, 2, 3, 4 or 7", [](double v) {
                                 constexpr std::array sizes{1.0, 2.0, 3.0, 4.0, 7.0};
                                 return std::find(sizes.begin(), sizes.end(), v) != sizes.end();
                             }};

const Names& plane_names() {
    static const Names names{"stress", "strain"};
    return names;
}
const Names& step_rule_names() {
    static const Names names{"sharp", "bound", "paper"};
    return names;
}
const Names& precision_names() {
    static const Names names{"double", "mixed"};
    return names;
}
const Names& row_names() {
    static const Names names{"horizontal", "vertical"};
    return names;
}
const Names& fit_names() {
    static const Names names{"centres", "inside"};
    return names;
}

} // namespace

const WordOf<Scene>& simulation() {
    static const WordOf<Scene> made = word<Scene>(
        "dem.simulation", "The experiment as a whole; one to a scene. Everything else is said to it.", "a simulation",
        R"(local sim = dem.simulation { title = "Penetration", plane = "stress", gravity = { 0, -9.81 } })",
        {
            row<&Scene::title>("title", optional, "what the experiment is called"),
            choice<&Scene::plane, plane_names>("plane", "plane assumption of the elastic stiffness"),
            row<&Scene::thickness>("thickness", "m", optional, positive, "out of the plane"),
            row<&Scene::gravity>("gravity", "m/s^2", optional, any, "acceleration of free fall"),
            choice<&Scene::time_step, step_rule_names>(
                "time_step",
                R"(how the critical time step is found: "sharp" by iteration on the assembly, "bound" by a quick bound, "paper" by eq. 19 of Tavarez & Plesha 2007, refused where unstable)"),
            choice<&Scene::precision, precision_names>(
                "precision",
                R"("double", or "mixed": what a step reads of bonds is kept in single precision, and is faster to read; elements, what bonds remember and all arithmetic stay double)"),
            row<&Scene::step_fraction>("step_fraction", "", optional, step_share,
                                       "share of the critical time step that is used"),
            row<&Scene::greatest_move>("greatest_move", "", optional, step_share,
                                       "share of its radius that an element may move in a step; more stops the run"),
            row<&Scene::periodic_x>("periodic_x", "m", optional, any,
                                    "left and right edge of a box that repeats along x: what leaves it on one side "
                                    "comes in on the other"),
            row<&Scene::domain>("domain", optional,
                                "elements whose centre leaves it are taken out, with all they are held together with "
                                "once that has left as a whole, and counted as now.removed"),
        });
    return made;
}

const WordOf<Material>& material() {
    static const WordOf<Material> made = word<Material>(
        "dem.material", "What bodies are made of. Its settings can be read back: `concrete.density`.", "a material",
        R"(local concrete = dem.material { name = "concrete", youngs_modulus = 30e9, poissons_ratio = 0.2, density = 2400, friction = 0.5 })",
        {
            row<&Material::name>("name", optional, "as messages call it"),
            row<&Material::youngs_modulus>("youngs_modulus", "Pa", required, positive, "Young's modulus"),
            row<&Material::poissons_ratio>(
                "poissons_ratio", "", required, ratio,
                "Poisson's ratio; bonds other than facets take at most 1/3 in plane stress, 1/4 in plane strain"),
            row<&Material::density>("density", "kg/m^3", required, positive, "mass per volume of the solid"),
            row<&Material::tensile_strength>("tensile_strength", "Pa", optional, positive,
                                             "needed by bonds that break"),
            row<&Material::fracture_toughness>("fracture_toughness", "Pa m^0.5", optional, positive,
                                               "K_Ic, needed by bonds that break; this or fracture_energy"),
            row<&Material::fracture_energy>("fracture_energy", "J/m^2", optional, positive,
                                            "G_f = K_Ic^2/E*, E* = E in plane stress and E/(1-nu^2) in plane strain"),
            row<&Material::rate_factor>("rate_factor", "", optional, positive,
                                        "constant strain-rate factor on tensile strength and fracture energy"),
            row<&Material::friction>("friction", "", optional, non_negative,
                                     "Coulomb coefficient; the smaller of two materials' counts"),
            row<&Material::rolling_friction>("rolling_friction", "", optional, non_negative,
                                             "greatest moment against rolling over pressure and reduced radius; the "
                                             "smaller of two materials' counts"),
            row<&Material::wear_energy_density>(
                "wear_energy_density", "J/m^3", optional, positive,
                "W0 of Tavarez & Plesha 2007, eqs 1 and 2: an element leaves its cluster once sliding on others has "
                "spent this much per volume of it"),
            row<&Material::restitution>("restitution", "", optional, share,
                                        "speed after over speed before a head-on impact"),
            row<&Material::contact_damping>("contact_damping", "", optional, non_negative,
                                            "dashpots of contacts, fraction of critical; instead of restitution"),
        });
    return made;
}

const WordOf<ContactRule>& contact() {
    static const WordOf<ContactRule> made = word<ContactRule>(
        "sim:contact",
        "How elements of two materials, or of one, meet each other and its outlines. What is not named follows from "
        "the "
        "materials: the smaller friction and rolling friction, the mean of the dashpots, springs in series.",
        "", "sim:contact { sand, steel, friction = 0.3, restitution = 0.5 }",
        {
            row<&ContactRule::first, MaterialSlot>("first", required, "one material; the word itself may be left out")
                .at(1),
            row<&ContactRule::second, MaterialSlot>("second", required, "the other, or the same; likewise").at(2),
            row<&ContactRule::friction>("friction", "", optional, non_negative, "Coulomb coefficient"),
            row<&ContactRule::rolling_friction>("rolling_friction", "", optional, non_negative,
                                                "greatest moment against rolling over pressure and reduced radius"),
            row<&ContactRule::restitution>("restitution", "", optional, share,
                                           "speed after over speed before a head-on impact"),
            row<&ContactRule::contact_damping>("contact_damping", "", optional, non_negative,
                                               "dashpots, fraction of critical; instead of restitution"),
        });
    return made;
}

const WordOf<RectangleSaid>& rectangle() {
    static const WordOf<RectangleSaid> made =
        word<RectangleSaid>("dem.rectangle", "A rectangle along the axes.", "a region",
                            "dem.rectangle { at = { 0, 0 }, size = { 1.5, 0.25 } }",
                            {row<&RectangleSaid::at>("at", "m", optional, any, "lower left corner"),
                             row<&RectangleSaid::size>("size", "m", required, positive, "width and height")});
    return made;
}

const WordOf<DiscSaid>& disc() {
    static const WordOf<DiscSaid> made =
        word<DiscSaid>("dem.disc", "A full circle.", "a region", "dem.disc { centre = { 0.5, 0.5 }, radius = 0.1 }",
                       {row<&DiscSaid::centre>("centre", "m", optional, any, "its middle"),
                        row<&DiscSaid::radius>("radius", "m", required, positive, "its radius")});
    return made;
}

const WordOf<PolygonSaid>& polygon() {
    static const WordOf<PolygonSaid> made = word<PolygonSaid>(
        "dem.polygon", "At least three corners in either sense; sides must not cross.", "a region",
        "dem.polygon { { 0, 0 }, { 1, 0 }, { 0, 1 } }",
        {row<&PolygonSaid::corners>("corners", "m", required, any, "the corners in order").at(whole_list)});
    return made;
}

const WordOf<HalfPlaneSaid>& half_plane() {
    static const WordOf<HalfPlaneSaid> made = word<HalfPlaneSaid>(
        "dem.half_plane", "Everything on one side of a line.", "a region",
        "dem.half_plane { point = { 0, 0.1 }, outward = { 0, 1 } }",
        {row<&HalfPlaneSaid::point>("point", "m", optional, any, "a point of the line"),
         row<&HalfPlaneSaid::outward>("outward", "", required, any, "across the line, away from the region")});
    return made;
}

const WordOf<ShiftSaid>& translated() {
    static const WordOf<ShiftSaid> made =
        word<ShiftSaid>("region:translated", "The same region elsewhere.", "a region", "hole:translated { 0.1, 0 }",
                        {row<&ShiftSaid::x>("x", "m", optional, any, "to the right").at(1),
                         row<&ShiftSaid::y>("y", "m", optional, any, "upwards").at(2)});
    return made;
}

const WordOf<TurnSaid>& rotated() {
    static const WordOf<TurnSaid> made =
        word<TurnSaid>("region:rotated", "The same region turned counter-clockwise.", "a region",
                       "slot:rotated { angle = math.pi / 4, about = { 0.5, 0.5 } }",
                       {row<&TurnSaid::angle>("angle", "rad", required, any, "how far").at(1),
                        row<&TurnSaid::about>("about", "m", optional, any, "the point that stays")});
    return made;
}

const WordOf<ClosePacking>& close_packed() {
    static const WordOf<ClosePacking> made = word<ClosePacking>(
        "dem.close_packed", "Hexagonal lattice of equal elements, each touching six others.", "a packing",
        R"(dem.close_packed { radius = 5e-3, rows = "horizontal", fit = "inside" })",
        {
            row<&ClosePacking::radius>("radius", "m", required, positive, "of the elements"),
            choice<&ClosePacking::rows, row_names>("rows", "the way along which elements touch in straight rows"),
            choice<&ClosePacking::fit, fit_names>(
                "fit",
                R"("centres": an element stays when its centre lies in the region; "inside": when its whole disk does)"),
            row<&ClosePacking::origin>("origin", "m", optional, any,
                                       "a lattice point; else the lattice starts at the region's lower left"),
            row<&ClosePacking::removed>("removed", "", optional, lost_share,
                                        "share of the elements taken away at random, for a porous solid"),
            row<&ClosePacking::seed>("seed", "", optional, non_negative, "which elements are taken away"),
        });
    return made;
}

const WordOf<Consolidation>& consolidated() {
    static const WordOf<Consolidation> made = word<Consolidation>(
        "dem.consolidated", "Clusters put down at random and pressed together until they fill the region.", "a packing",
        "dem.consolidated { cluster = 3, count = 12000, seed = 1 }",
        {
            row<&Consolidation::cluster>("cluster", "", optional, cluster_size, "elements in a cluster"),
            row<&Consolidation::count>("count", "", optional, positive,
                                       "elements wanted, made up to whole clusters; this or radius"),
            row<&Consolidation::radius>("radius", "m", optional, positive, "of the elements; this or count"),
            row<&Consolidation::solid_fraction>("solid_fraction", "", optional, solid,
                                                "area of the disks over the area of the region"),
            row<&Consolidation::relax>("relax", "", optional, non_negative,
                                       "steps of Lloyd's method afterwards, which make the distances even"),
            row<&Consolidation::removed>("removed", "", optional, lost_share,
                                         "share of the elements taken away at random in the end, for a porous solid"),
            row<&Consolidation::seed>("seed", "", optional, non_negative, "same seed, same pack"),
        });
    return made;
}

const WordOf<Relaxation>& relaxed() {
    static const WordOf<Relaxation> made = word<Relaxation>(
        "dem.relaxed",
        "Irregular pack of single elements at even distances, by Lloyd's method, that fills any region to its walls. "
        "Its "
        "disks overlap a little: a pack for bonded bodies.",
        "a packing", "dem.relaxed { size = function(x, y) return 2e-3 + 0.1 * y end, on_boundary = true }",
        {
            row<&Relaxation::count>("count", "", optional, positive, "elements wanted; this, spacing or size"),
            row<&Relaxation::spacing>("spacing", "m", optional, positive,
                                      "distance of neighbouring elements; this, count or size"),
            row<&Relaxation::size>("size", optional,
                                   "the same from place to place, m; from an element to the next it should change by "
                                   "less than a third"),
            row<&Relaxation::steps>("steps", "", optional, non_negative, "of Lloyd's method: more give evener cells"),
            row<&Relaxation::on_boundary>("on_boundary", optional,
                                          "a row of elements stands on the region's boundary, one in each corner; else "
                                          "all disks lie inside"),
            row<&Relaxation::boundary_within>("boundary_within", optional,
                                              "with on_boundary: the row stands only where the boundary lies in this "
                                              "region, as at a clamped or loaded end"),
            row<&Relaxation::seed>("seed", "", optional, non_negative, "same seed, same pack"),
        });
    return made;
}

const WordOf<DiskSaid>& disk() {
    static const WordOf<DiskSaid> made =
        word<DiskSaid>("disks", "One disk of dem.disks.", "", "{ x = 0, y = 0, radius = 0.01 }",
                       {row<&DiskSaid::x>("x", "m", required, any, "of the centre").at(1),
                        row<&DiskSaid::y>("y", "m", required, any, "of the centre").at(2),
                        row<&DiskSaid::radius>("radius", "m", required, positive, "of the disk").at(3),
                        row<&DiskSaid::cluster>("cluster", "", optional, number_of_cluster,
                                                "which cluster it belongs to, for all disks or for none")
                            .at(4)});
    return made;
}

const WordOf<ListedDisks>& disks() {
    static const WordOf<ListedDisks> made =
        word<ListedDisks>("dem.disks", "Elements put down one by one; a body packed so needs no region.", "a packing",
                          "dem.disks { { 0, 0, 0.01 }, { x = 0.02, y = 0, radius = 0.01 } }",
                          {Row<ListedDisks>{{"list", [](void* said) -> Slot { return static_cast<ListedDisks*>(said); },
                                             "m", required, any, "the disks", whole_list}}});
    return made;
}

const WordOf<Body>& body() {
    static const WordOf<Body> made = word<Body>(
        "sim:body", "Elements of one material that fill a region.", "a body",
        R"(local beam = sim:body { name = "beam", material = concrete, region = box, packing = dem.close_packed { radius = 5e-3 }, bonds = dem.plateau {} })",
        {
            row<&Body::name>("name", required, "as results call it: now.body.NAME"),
            row<&Body::material, MaterialSlot>("material", required, "made with dem.material"),
            row<&Body::region>("region", optional, "the part of the plane to fill; not needed by dem.disks"),
            row<&Body::packing>("packing", required, "how it is filled"),
            row<&Body::bonds>("bonds", optional, "what holds the elements together; without it they are loose"),
            row<&Body::velocity>("velocity", "m/s", optional, any, "at the start"),
            row<&Body::spin>("spin", "rad/s", optional, any, "at the start, about the centre of mass"),
            row<&Body::rigid>("rigid", optional, "move as one piece; bonds then have nothing to do"),
            row<&Body::in_clusters>("in_clusters", optional,
                                    "bonds or rigid hold each cluster of the packing together, not the whole body"),
        });
    return made;
}

const WordOf<ShiftSaid>& set_velocity() {
    static const WordOf<ShiftSaid> made = word<ShiftSaid>(
        "body:set_velocity", "Gives every element of the body this velocity, now.", "", "shot:set_velocity { 0, -20 }",
        {row<&ShiftSaid::x>("x", "m/s", optional, any, "to the right").at(1),
         row<&ShiftSaid::y>("y", "m/s", optional, any, "upwards").at(2)});
    return made;
}

} // namespace demlua::model::words
