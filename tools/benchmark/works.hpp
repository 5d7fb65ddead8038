// The scenes that are measured, by name.
#pragma once

#include "engine/model/scene.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace demlua::bench {

struct Work {
    std::string name;
    std::string what;
    model::Scene scene;
    double speed = 0.0;             ///< m/s, amplitude of the waves that the bodies start with
    std::uint64_t steps_before = 0; ///< taken before anything is measured
};

/// All there are, in the order of the table.
std::vector<std::string> names_of_works();

/// Throws std::invalid_argument, naming those there are, for a name that is none of them.
Work work_of(const std::string& name);

} // namespace demlua::bench
