// The bond laws, one row each. To add one: write its file like elastic.hpp (equation, Params, History, derive, respond,
// has_yielded, stored_energy; if it breaks, broken, caps and damage; if it yields, largest_radius and the plastic stretch, shear
// and work in its History; `wakes` says that its facets are dormant until the stress of their cells wakes them, as in
// cohesive.hpp: such a law is for facets alone), put it in this list, give it a choice in model/scene.hpp with a word in
// model/settings_bonds.cpp, a `derived` in model/derived_law.hpp and a row in scripting/bond_laws.cpp. Loops, checks, files
// and ledger follow. A law whose Params are StrengthCaps can stand inside RateDependent as well.
#pragma once

#include "engine/law/brittle_tensile.hpp"
#include "engine/law/brittle_toughness.hpp"
#include "engine/law/cohesive.hpp"
#include "engine/law/elastic.hpp"
#include "engine/law/plateau.hpp"
#include "engine/law/rate_dependent.hpp"
#include "engine/law/softening.hpp"

namespace demlua::law {

template <template <class> class Pairs, template <class> class Facets, template <class...> class List>
using ForEachBondLaw =
    List<Pairs<Elastic>, Pairs<Plateau>, Pairs<Softening>, Pairs<BrittleTensile>, Pairs<BrittleToughness>,
         Facets<Elastic>, Facets<Plateau>, Facets<Softening>, Facets<BrittleTensile>, Facets<BrittleToughness>,
         Facets<Cohesive>, Pairs<RateDependent<Plateau>>, Pairs<RateDependent<Softening>>,
         Facets<RateDependent<Plateau>>, Facets<RateDependent<Softening>>>;

} // namespace demlua::law
