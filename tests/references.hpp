// The numbers of tests/references.json, for tests that compare the engine with finite elements.
#pragma once

#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace demlua::test {

inline std::string references_file() { return std::string(DEMLUA_SOURCE_DIR) + "/tests/references.json"; }

/// The whole file; each case states its geometry, material, support, load and meshes.
inline const nlohmann::json& references() {
    static const nlohmann::json all = nlohmann::json::parse(std::ifstream(references_file()));
    return all;
}

/// One value, e.g. reference("slab_cantilever", "end_deflection"). Throws nlohmann::json::out_of_range for unknown names.
inline double reference(const std::string& name, const std::string& quantity) {
    return references().at(name).at("quantities").at(quantity).at("value").get<double>();
}

} // namespace demlua::test
