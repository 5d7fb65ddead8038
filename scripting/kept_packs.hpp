// Where the program keeps packs.
#pragma once

#include "engine/packing/pack_store.hpp"

#include <memory>

namespace demlua::scripting {

/// The folder that the environment names: DEMLUA_CACHE, or else demlua in XDG_CACHE_HOME or ~/.cache. None where
/// DEMLUA_CACHE is empty, where there is no home, and for a program built from changed sources unless DEMLUA_CACHE is
/// given: what it was built from then has no name.
std::shared_ptr<const packing::PackStore> kept_packs();

} // namespace demlua::scripting
