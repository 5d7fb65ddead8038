// Rows of the bond laws.
#include "engine/model/rows.hpp"
#include "engine/model/settings.hpp"

#include <iterator>

namespace demlua::model::words {

using namespace rows;

const Names& network_names() {
    static const Names names{"automatic", "facets", "unit cell", "delaunay", "contacts"};
    return names;
}

namespace {

constexpr const char* network_meaning =
    R"("facets": every two neighbouring cells, elastically exact on any pack; "unit cell": elements that touch, eqs 15-16, exact for close packing; "delaunay": all neighbouring cells, eqs 15-16; "contacts": elements that touch, eqs 15-16, softer than said on an irregular pack; "automatic": unit cell for close packing, facets for packs that fill a region, contacts for listed disks, and facets whatever the pack for dem.cohesive)";

/// A bond law: what all have, and its own settings.
template <class T>
WordOf<T> bond_law(std::string call, std::string meaning, std::string example, std::vector<Row<T>> own = {}) {
    std::vector<Row<T>> table{
        choice_of<T, &BondSettings::network, network_names>("stiffness", network_meaning),
        row_of<T, &BondSettings::search>(
            "search", "", optional, non_negative,
            "elements that touch are bonded across gaps below this share of their mean radius"),
        row_of<T, &BondSettings::damping>("damping", "", optional, non_negative,
                                          "dashpots beside the springs, fraction of critical of one bond"),
    };
    std::move(own.begin(), own.end(), std::back_inserter(table));
    return word<T>(std::move(call), std::move(meaning), "a bond law", std::move(example), std::move(table));
}

/// Settings of laws that strain rates can make stronger, after their own.
template <class T>
std::vector<Row<T>> with_rates(std::vector<Row<T>> own = {}) {
    own.push_back(row<&T::rate_compressive_strength>(
        "rate_compressive_strength", "Pa", optional, positive,
        "static compressive strength of the concrete: bonds are then stronger, and cost more, the faster they are "
        "stretched when they first yield (Malvar & Crawford 1998); without, strain rates do nothing"));
    own.push_back(row<&T::rate_window>("rate_window", "s", optional, positive,
                                       "time over which a bond's strain rate is averaged; without, ten times that in "
                                       "which a wave passes one bond"));
    return own;
}

} // namespace

const WordOf<ElasticBonds>& elastic() {
    static const WordOf<ElasticBonds> made =
        bond_law<ElasticBonds>("dem.elastic", "Bonds that never break.", "dem.elastic { damping = 0.02 }");
    return made;
}

const WordOf<PlateauBonds>& plateau() {
    static const WordOf<PlateauBonds> made = bond_law<PlateauBonds>(
        "dem.plateau",
        "Bonds that yield at the tensile strength and break when the fracture energy is spent (Tavarez & Plesha "
        "2007, eqs 32-36).",
        "dem.plateau { search = 0.1, damping = 0.02 }",
        with_rates<PlateauBonds>({row<&PlateauBonds::break_in_shear>(
            "break_in_shear", optional, "also break when plastic slip has spent the fracture energy")}));
    return made;
}

const WordOf<SofteningBonds>& softening() {
    static const WordOf<SofteningBonds> made = bond_law<SofteningBonds>(
        "dem.softening",
        "Bonds whose tension and shear, once at the tensile strength, fall in a straight line to nothing while the "
        "fracture energy is spent (Tavarez & Plesha 2007, fig. 16).",
        "dem.softening { search = 0.1, damping = 0.02 }", with_rates<SofteningBonds>());
    return made;
}

const WordOf<BrittleTensileBonds>& brittle_tensile() {
    static const WordOf<BrittleTensileBonds> made =
        bond_law<BrittleTensileBonds>("dem.brittle_tensile",
                                      "Bonds that break at once at the tensile strength (Tavarez & Plesha 2007, eq. "
                                      "21). What makes a crack grow then "
                                      "depends on the size of the elements.",
                                      "dem.brittle_tensile { search = 0.1 }");
    return made;
}

const WordOf<BrittleToughnessBonds>& brittle_toughness() {
    static const WordOf<BrittleToughnessBonds> made = bond_law<BrittleToughnessBonds>(
        "dem.brittle_toughness",
        "Bonds that break at once at the pull that the fracture toughness puts on the tip of a crack (Tavarez & Plesha "
        "2007, eq. 26). The strength without a crack then depends on the size of the elements.",
        "dem.brittle_toughness { search = 0.1 }");
    return made;
}

const WordOf<CohesiveBonds>& cohesive() {
    static const WordOf<CohesiveBonds> made = bond_law<CohesiveBonds>(
        "dem.cohesive",
        "Facets that wake where the stress reaches the tensile strength and let go while the fracture energy of the "
        "crack "
        "they open is spent, whatever its direction: converges to fracture mechanics. Only across facets.",
        "dem.cohesive { damping = 0.02 }");
    return made;
}

} // namespace demlua::model::words
