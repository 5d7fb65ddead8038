// The same work for other programs: the first instant, and what becomes of it.
#pragma once

#include "tools/benchmark/works.hpp"

#include "engine/packing/pack_store.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace demlua::bench {

/// Writes the elements, bonds, contact law and walls of the first instant to `file` ("-": to none), takes the steps that come
/// before measuring, and then batches that are timed one by one. Returns seconds per step of each batch and the energies
/// and mean height at the end. SI units; velocities are those of the instant.
nlohmann::ordered_json follow(const Work& work, int threads, const packing::PackStore* packs, const std::string& file);

} // namespace demlua::bench
