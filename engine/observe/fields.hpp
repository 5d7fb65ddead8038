// The fields that can be seen of elements and bonds, one row each.
#pragma once

#include "engine/observe/snapshot.hpp"
#include "engine/state/state.hpp"

#include <string>
#include <vector>

namespace demlua::observe {

/// How a probe combines a field over the elements it looks at.
enum class Combine { mean, sum };

using FieldValues = std::variant<std::vector<double>, std::vector<std::int32_t>>;

struct ElementField {
    const char* name;
    const char* unit;
    int components;
    Combine combine;
    const char* meaning;
    bool (*present)(const state::State&); ///< whether the scene has any use for it
    FieldValues (*values)(const state::State&);
};

const std::vector<ElementField>& element_fields();

/// Every component a probe can name: `speed`, `velocity_x`, `stress_yy` ...
std::vector<std::string> component_names(const ElementField& field);

/// All bonds of the scene with their fields, in the order of the bond sets.
void add_bonds_to(Snapshot& snapshot, const state::State& state);

} // namespace demlua::observe
