// Rows of grains: what one is made of, how large they are, how they are put down.
#include "engine/model/rows.hpp"
#include "engine/model/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace demlua::model::words {

using namespace rows;

namespace {

constexpr Range template_size{"must be 1, 2, 3, 4 or 7", [](double v) {
                                  constexpr std::array sizes{1.0, 2.0, 3.0, 4.0, 7.0};
                                  return std::find(sizes.begin(), sizes.end(), v) != sizes.end();
                              }};
constexpr Range within_one{"must be above 0 and below 1", [](double v) { return v > 0.0 && v < 1.0; }};

const Names& placing_names() {
    static const Names names{"consolidation", "insertion", "rain"};
    return names;
}

} // namespace

const WordOf<Cluster>& cluster() {
    static const WordOf<Cluster> made = word<Cluster>(
        "dem.cluster",
        "What one grain of sim:grains is made of: disks that touch or overlap, which bonds hold together, or which "
        "move as "
        "one rigid piece with the exact mass and inertia of what they cover.",
        "a cluster", "dem.cluster { elements = 3, bonds = dem.plateau {} }",
        {
            row<&Cluster::elements>("elements", "", optional, template_size,
                                    "equal disks, each touching its neighbours; this or disks"),
            row<&Cluster::disks>("disks", "", optional, any,
                                 "the disks one by one, in any unit of length, for radius says how large grains are; "
                                 "each must touch or overlap another, directly or through others"),
            row<&Cluster::bonds>("bonds", optional, "what holds the disks together, until it breaks"),
            row<&Cluster::rigid>("rigid", optional, "the disks move as one piece; instead of bonds"),
        });
    return made;
}

const WordOf<SizeClass>& size_class() {
    static const WordOf<SizeClass> made = word<SizeClass>(
        "radius", "One size of grains.", "", "{ radius = 2e-3, share = 3 }",
        {row<&SizeClass::least>("radius", "m", required, positive, "mean radius of a grain's elements").at(1),
         row<&SizeClass::share>("share", "", required, positive,
                                "of the grains by number; only its ratio to the others counts")
             .at(2)});
    return made;
}

const WordOf<GrainsSaid>& grains() {
    using G = GrainsSaid;
    static const WordOf<G> made = word<G>(
        "sim:grains",
        "A body of loose grains, each a disk or a cluster of disks, turned at random. It can do all that a body of "
        "sim:body "
        "can; selections and readings see its elements.",
        "a body",
        R"(local bed = sim:grains { name = "bed", material = sand, region = box, shape = dem.cluster { elements = 3, rigid = true }, radius = { 1.5e-3, 2.5e-3 }, porosity = 0.2, seed = 1 })",
        {
            row<&G::name>("name", required, "as results call it: now.body.NAME"),
            row<&G::material, MaterialSlot>("material", required, "made with dem.material"),
            row<&G::region>("region", required, "the part of the plane to put them in"),
            row<&G::shape>("shape", optional, "what a grain is made of; without it a single disk"),
            row<&G::sizes>(
                "radius", "m", required, positive,
                "mean radius of a grain's elements: one for all, spread evenly between two, or classes by number"),
            row<&G::porosity>("porosity", "", optional, within_one,
                              "1 - area of the grains over area of the region; when it cannot be reached the run stops "
                              "and says what can"),
            choice<&G::method, placing_names>(
                "method",
                R"("consolidation": grown inside the region, sliding without friction, until they fill it; "insertion": one by one at random places where they overlap nothing, the largest first; "rain": dropped one by one, each sliding and turning without friction until it lies as low as it can)"),
            row<&G::count>("count", "", optional, positive,
                           "grains, instead of porosity; rain without either fills the region"),
            row<&G::removed>("removed", "", optional, lost_share,
                             "share of the grains taken away at random afterwards, down to a higher porosity"),
            row<&G::velocity>("velocity", "m/s", optional, any, "at the start"),
            row<&G::seed>("seed", "", optional, non_negative, "same seed, same grains"),
        });
    return made;
}

} // namespace demlua::model::words
