// What the user said, as plain checked values in SI units. A scene grows from top to bottom of the user's file;
// what is added after a run takes effect before the next.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/base/signal.hpp"
#include "engine/base/vec2.hpp"
#include "engine/model/packings.hpp"
#include "engine/model/region.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace demlua::model {

enum class Plane { stress, strain };

struct Material {
    std::string name;
    double youngs_modulus = 0.0;            ///< Pa
    double poissons_ratio = 0.0;            ///< at most 1/3 (plane stress) or 1/4 (strain) for bonds other than facets
    double density = 0.0;                   ///< kg/m^3
    std::optional<double> tensile_strength; ///< Pa
    std::optional<double> fracture_toughness; ///< Pa m^0.5
    std::optional<double> fracture_energy;    ///< J/m^2, says the same as the toughness
    double rate_factor = 1.0;                 ///< constant factor on tensile strength and on fracture energy
    double friction = 0.0;                    ///< Coulomb coefficient
    double rolling_friction = 0.0;            ///< greatest rolling moment over pressure and reduced radius
    std::optional<double>
        wear_energy_density;           ///< W0: sliding work per volume after which an element leaves its cluster, J/m^3
    std::optional<double> restitution; ///< of a head-on impact, (0, 1]
    std::optional<double> contact_damping; ///< fraction of critical of the contact dashpots
    Place place;
};

/// What holds for contacts between two materials in place of what follows from them.
struct ContactRule {
    std::size_t first = 0; ///< rows of Scene::materials
    std::size_t second = 0;
    std::optional<double> friction;
    std::optional<double> rolling_friction;
    std::optional<double> restitution;
    std::optional<double> contact_damping; ///< fraction of critical
    Place place;
};

/// No bonds: every element is loose.
struct NoBonds {};
/// Which elements of a body are bonded and how stiffly.
enum class Network {
    automatic, ///< facets for laws that need them; else unit cell for close packing, facets for packs that fill a region
               ///< irregularly, contacts for others
    facets,    ///< across the facets of cells, exact on any pack (law/facet.hpp)
    unit_cell, ///< elements that touch, eqs 15, 16: exact for close packing
    delaunay,  ///< all neighbouring cells, eqs 15, 16
    contacts   ///< elements that touch, eqs 15, 16, on a pack they were not made for
};
/// What is said of bonds under any law.
struct BondSettings {
    double search = 0.1;  ///< elements touch when the gap between them is below this share of the mean radius
    double damping = 0.0; ///< dashpots beside the springs, as a fraction of critical of one bond
    Network network = Network::automatic;
    static constexpr bool facets_only = false; ///< whether the law needs the facets of cells
};
// The laws of engine/law by the same names; `needs_...` is what they take from the material.
struct ElasticBonds : BondSettings {
    static constexpr bool needs_strength = false;
    static constexpr bool needs_toughness = false;
};
struct PlateauBonds : BondSettings {
    static constexpr bool needs_strength = true;
    static constexpr bool needs_toughness = true;
    bool break_in_shear = false; ///< also break when the plastic slip has spent the fracture energy (fig. 14b)
    // strain-rate factors (law/rate_dependent.hpp), of laws that take them
    std::optional<double> rate_compressive_strength = std::nullopt; ///< of the concrete, Pa; none: no factors
    std::optional<double> rate_window = std::nullopt;               ///< over which rates are averaged, s
};
struct SofteningBonds : BondSettings {
    static constexpr bool needs_strength = true;
    static constexpr bool needs_toughness = true;
    std::optional<double> rate_compressive_strength = std::nullopt;
    std::optional<double> rate_window = std::nullopt;
};
struct BrittleTensileBonds : BondSettings {
    static constexpr bool needs_strength = true;
    static constexpr bool needs_toughness = false;
};
struct BrittleToughnessBonds : BondSettings {
    static constexpr bool needs_strength = false;
    static constexpr bool needs_toughness = true;
};
struct CohesiveBonds : BondSettings {
    static constexpr bool needs_strength = true;
    static constexpr bool needs_toughness = true;
    static constexpr bool facets_only = true;
};
using BondChoice = std::variant<NoBonds, ElasticBonds, PlateauBonds, SofteningBonds, BrittleTensileBonds,
                                BrittleToughnessBonds, CohesiveBonds>;

/// What a grain is made of and what holds it together; nothing, where it is neither bonded nor rigid.
struct Cluster {
    int elements = 0;             ///< as GrainPacking has them; 0 where `disks` are given
    std::vector<Disk> disks = {}; ///< one by one, in any unit of length
    BondChoice bonds;
    bool rigid = false;
};

struct Body {
    std::string name;
    std::size_t material = 0; ///< row of Scene::materials
    Region region;
    PackingChoice packing;
    BondChoice bonds;
    Vec2 velocity;     ///< at the start, m/s
    double spin = 0.0; ///< at the start, about the centre of mass, rad/s
    bool rigid = false;
    bool in_clusters = false; ///< bonds or rigidity hold each cluster of the packing together, not the body as a whole
    Place place;
};

/// What holds the body together: its bonds' choice with `automatic` settled by the packing; none when it is loose or rigid.
std::optional<Network> network_of(const Body& body);

enum class Side { left, right, bottom, top };

/// Elements chosen by any mixture of body, side of that body, region, and yes-or-no function of place, all of which
/// must agree. Where the elements stand when the selection is first used decides.
struct Selection {
    std::optional<std::size_t> body;
    std::optional<Side> side;
    std::optional<Region> within;
    std::function<bool(Vec2)> where;
};

/// Degrees of freedom held at rest.
struct Support {
    Selection selection;
    bool x = true;
    bool y = true;
    bool rotation = true;
    Place place;
};

/// Prescribed motion; a degree of freedom without a signal stays free.
struct Motion {
    Selection selection;
    std::optional<Signal> velocity_x;     ///< m/s
    std::optional<Signal> velocity_y;     ///< m/s
    std::optional<Signal> displacement_x; ///< m, from where the element stands when the motion begins
    std::optional<Signal> displacement_y; ///< m
    std::optional<Signal> spin;           ///< rad/s
    Place place;
};

/// A force shared equally among the elements selected.
struct Force {
    Selection selection;
    Signal x; ///< N, sum over the elements
    Signal y; ///< N
    Place place;
};

/// Stress on one side of a body, each element taking the length of side that is nearest to it.
struct Traction {
    Selection selection; ///< names a body and a side
    Signal stress_x;     ///< Pa, force along x per area of the side
    Signal stress_y;     ///< Pa
    bool hold_rotation = false;
    Place place;
};

/// Moves a wall along an axis so that it presses with a stress or a force. Positive: the wall presses on what it meets.
struct Servo {
    std::optional<Signal> stress_x;  ///< Pa, over the wall's height at the start times thickness
    std::optional<Signal> stress_y;  ///< Pa, over its width
    std::optional<Signal> force_x;   ///< N
    std::optional<Signal> force_y;   ///< N
    double gain = 0.1;               ///< share of what is missing that a step makes up for
    std::optional<double> max_speed; ///< m/s; else a tenth of sqrt(stress/density)
    std::optional<double> travel;    ///< how far it may go without meeting anything; else the extent of all there is, m

    [[nodiscard]] bool along_x() const { return stress_x || force_x; }
    [[nodiscard]] bool along_y() const { return stress_y || force_y; }
};

/// A rigid line of segments. Elements meet it from either side.
struct Wall {
    std::string name;
    std::vector<Vec2> path; ///< m, at least two points; closed where the last is the first
    double friction = std::numeric_limits<double>::infinity(); ///< the smaller of wall's and element's counts
    std::optional<Signal> velocity_x;                          ///< m/s
    std::optional<Signal> velocity_y;                          ///< m/s
    std::optional<Signal> spin;                                ///< rad/s, about `centre`
    std::optional<Vec2> centre; ///< at the start, moves with the wall; else the middle, m
    std::optional<Servo> servo;
    bool stop = false; ///< said of a wall that moves: all of its motion ends
    Place place;
};

/// A rigid figure with mass, bounded by a closed path that elements meet. It moves freely in every way that no signal gives.
struct Outline {
    std::string name;
    std::size_t material = 0;                                  ///< row of Scene::materials
    std::vector<Vec2> path;                                    ///< its corners, m; or else
    Region region;                                             ///< of straight sides, without holes
    Vec2 velocity;                                             ///< at the start, m/s
    double spin = 0.0;                                         ///< at the start, about the centre of mass, rad/s
    double friction = std::numeric_limits<double>::infinity(); ///< the smaller of outline's and element's counts
    std::optional<double> rounding;   ///< of corners that meet walls and outlines; else the smallest radius, m
    std::optional<Signal> given_x;    ///< m/s
    std::optional<Signal> given_y;    ///< m/s
    std::optional<Signal> given_spin; ///< rad/s
    bool let_go = false;              ///< said of an outline that is moved: what is not given now is free again
    Place place;
};

/// A straight cut: bonds of the body that cross it are broken before the run, and turn frictional.
struct Notch {
    std::size_t body = 0;
    Vec2 from;
    Vec2 to;
    Place place;
};

/// Rayleigh damping C = alpha M + beta K through fractions of critical at one or two frequencies. With one frequency it
/// is mass-proportional alone.
struct Damping {
    double fraction = 0.0;  ///< of critical at `frequency`
    double frequency = 0.0; ///< Hz
    std::optional<double> second_fraction;
    std::optional<double> second_frequency; ///< Hz
    Place place;
};

/// The mean (for forces: the sum) of a field over a selection, written to the history.
struct Probe {
    std::string name;
    Selection selection;
    std::string measure; ///< name of an element field, see observe/fields
    Place place;
};

/// Numbers of two elements, as the field `id` has them.
using IdPair = std::array<std::uint64_t, 2>;

/// What one bond bears, could bear and how far it has gone, written to the history.
struct BondProbe {
    std::string name;
    std::size_t body = 0;
    std::optional<Vec2> at;        ///< the bond whose middle is nearest to this place when the probe is first used, m
    std::optional<IdPair> between; ///< the bond of these two; exactly one of `at` and `between` is given
    Place place;
};

/// How numbers are kept that a step reads.
enum class Precision { full, mixed };

enum class StepRule {
    sharp, ///< the assembly's highest frequency by iteration, never below it
    bound, ///< the sum of what each element feels while the others stand still, times two
    paper  ///< Tavarez & Plesha 2007, eq. 19
};

/// Elements moved to rest under the loads, forces and given displacements of one instant.
struct StaticSolve {
    double tolerance = 1e-10;          ///< of the loads and reactions, what may be left on free elements
    std::uint64_t max_iterations = 60; ///< solutions of the linear system
    bool linear = false;               ///< one solution, of first order in displacements from bonding
    Place place;
};

/// How a run gets from one instant to the next.
enum class Driver {
    dynamic,     ///< steps of motion
    quasi_static ///< from rest to rest under loads that grow slowly (step/quasi_static.hpp)
};

/// A run from rest to rest.
struct QuasiStaticRun {
    double duration = 0.0;   ///< s
    double tolerance = 1e-5; ///< of a bond's strength, what may be out of balance in it
    std::uint64_t runs_after =
        20; ///< bonds broken one after another under one load, after which the crack is said to run
    std::uint64_t most_failing = 3000; ///< bonds that may yield or break at one instant
    Place place;
};

struct Scene {
    std::string title;
    Plane plane = Plane::stress;
    double thickness = 1.0; ///< m
    Vec2 gravity;           ///< m/s^2
    StepRule time_step = StepRule::sharp;
    Precision precision = Precision::full;
    double step_fraction = 0.8;     ///< of the critical time step
    double greatest_move = 0.2;     ///< share of its radius an element may move in a step
    std::optional<Vec2> periodic_x; ///< edges of a box that repeats along x, m
    Region domain;                  ///< elements that leave it are taken out; empty: there is none
    Place place;

    std::vector<Material> materials;
    std::vector<ContactRule> contact_rules; ///< of two that are said twice the last counts
    std::vector<Body> bodies;
    std::vector<Support> supports;
    std::vector<Motion> motions;
    std::vector<Force> forces;
    std::vector<Traction> tractions;
    std::vector<Wall> walls;
    std::vector<Outline> outlines;
    std::vector<Notch> notches;
    std::vector<Damping> dampings; ///< the last one counts
    std::vector<Probe> probes;
    std::vector<BondProbe> bond_probes;
};

} // namespace demlua::model
