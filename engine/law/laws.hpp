// The bond laws, one row each. To add one: write its file like elastic.hpp (equation, Params, History, derive, respond,
// has_yielded, stored_energy; if it breaks, broken, caps and damage, and the plastic stretch and shear in its History), put it
// in this list, give it a choice in model/scene.hpp with its settings, and a line in state/bond_assembly.cpp that derives
// its Params. Loops, files and ledger follow.
#pragma once

#include "engine/law/elastic.hpp"
#include "engine/law/plateau.hpp"

namespace demlua::law {

template <template <class> class Pairs, template <class> class Facets, template <class...> class List>
using ForEachBondLaw = List<Pairs<Elastic>, Pairs<Plateau>, Facets<Elastic>, Facets<Plateau>>;

} // namespace demlua::law
