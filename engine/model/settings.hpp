// The words of the scene language. A new setting is one row in a settings_*.cpp; a new word is one function here, its
// table there, an entry in all_words() and the few lines in scripting/ that say what the call does.
#pragma once

#include "engine/model/comparison.hpp"
#include "engine/model/setting.hpp"

#include <vector>

namespace demlua::model {

// --- what words say that no part of Scene holds as it was said -----------------------------------------------------

struct RectangleSaid {
    Vec2 at;
    Vec2 size;
};
struct DiscSaid {
    Vec2 centre;
    double radius = 0.0;
};
struct PolygonSaid {
    std::vector<Vec2> corners;
};
struct HalfPlaneSaid {
    Vec2 point;
    Vec2 outward;
};
/// A plane vector whose components are settings of their own.
struct ShiftSaid {
    double x = 0.0;
    double y = 0.0;
};
struct TurnSaid {
    double angle = 0.0;
    Vec2 about;
};
struct DiskSaid {
    double x = 0.0;
    double y = 0.0;
    double radius = 0.0;
    std::optional<double> cluster;
};
struct GrainsSaid {
    std::string name;
    std::size_t material = 0;
    Region region;
    Cluster shape{.elements = 1, .disks = {}, .bonds = {}, .rigid = false};
    std::vector<SizeClass> sizes;
    std::optional<double> porosity;
    Placing method = Placing::consolidation;
    std::uint64_t count = 0;
    double removed = 0.0;
    Vec2 velocity;
    std::uint64_t seed = 1;
    Place place;
};
struct RampSaid {
    double to = 0.0;
    double over = 0.0;
    double from = 0.0;
    std::optional<double> start;
};
struct SawtoothSaid {
    Vec2 from;
    Vec2 to;
    double height = 0.0;
    double pitch = 0.0;
};
struct HistorySaid {
    double every = 0.0;
};
struct OutputSaid {
    double every = 0.0;
};
struct EverySaid {
    double interval = 0.0;
    Callback act;
};
struct BondBreakSaid {
    Callback act;
};
struct RunSaid {
    double duration = 0.0;
    bool until_rest = false;
    Driver driver = Driver::dynamic;
    std::uint64_t runs_after = QuasiStaticRun{}.runs_after;
};
struct Nothing {};
/// What a study measures; the settings that may be of several kinds are read by the word itself.
struct StudySaid {
    std::string measure;
    std::string unit;
    std::string source;
    std::string because;
    std::uint64_t repeats = 1;
    std::optional<Vec2> order;
};

// --- the words -------------------------------------------------------------------------------------------------------

namespace words {

const WordOf<Scene>& simulation();
const WordOf<Material>& material();
const WordOf<ContactRule>& contact();

const WordOf<RectangleSaid>& rectangle();
const WordOf<DiscSaid>& disc();
const WordOf<PolygonSaid>& polygon();
const WordOf<HalfPlaneSaid>& half_plane();
const WordOf<ShiftSaid>& translated();
const WordOf<TurnSaid>& rotated();

const WordOf<ClosePacking>& close_packed();
const WordOf<Consolidation>& consolidated();
const WordOf<Relaxation>& relaxed();
const WordOf<ListedDisks>& disks();
const WordOf<DiskSaid>& disk();
/// The values of a bond law's `stiffness`, in the order of Network.
const Names& network_names();
const WordOf<ElasticBonds>& elastic();
const WordOf<PlateauBonds>& plateau();
const WordOf<SofteningBonds>& softening();
const WordOf<BrittleTensileBonds>& brittle_tensile();
const WordOf<BrittleToughnessBonds>& brittle_toughness();
const WordOf<CohesiveBonds>& cohesive();
const WordOf<Body>& body();
const WordOf<Cluster>& cluster();
/// One item of the list that `radius` of sim:grains may be.
const WordOf<SizeClass>& size_class();
const WordOf<GrainsSaid>& grains();
const WordOf<ShiftSaid>& set_velocity();

const WordOf<Support>& fix();
const WordOf<Motion>& move();
const WordOf<Force>& force();
const WordOf<Traction>& traction();
const WordOf<RampSaid>& ramp();
const WordOf<SawtoothSaid>& sawtooth();
const WordOf<Wall>& wall();
const WordOf<Servo>& servo();
const WordOf<Wall>& wall_move();
const WordOf<Outline>& outline();
const WordOf<Outline>& outline_move();
const WordOf<Notch>& notch();
const WordOf<Damping>& damping();
const WordOf<Probe>& probe();
const WordOf<BondProbe>& bond_probe();

const WordOf<HistorySaid>& history();
const WordOf<OutputSaid>& output();
const WordOf<EverySaid>& every();
const WordOf<BondBreakSaid>& on_bond_break();
const WordOf<RunSaid>& run();
const WordOf<StaticSolve>& solve_static();
const WordOf<Nothing>& param();
const WordOf<Nothing>& result();
const WordOf<Comparison>& compare();
const WordOf<StudySaid>& study();

} // namespace words

/// Every word a user calls with a table, in the order of the manual.
const std::vector<const Word*>& all_words();

} // namespace demlua::model
