// What a scene says with dem.study.
#pragma once

#include "engine/base/problems.hpp"
#include "engine/model/settings.hpp"
#include "scripting/plain.hpp"

#include <optional>
#include <string>
#include <vector>

namespace demlua::scripting {

inline constexpr const char* seed_parameter = "seed";

struct Varied {
    std::string parameter;
    std::vector<Plain> values; ///< all of the parameter's kind
};

/// Where the reference comes from: a result of that name, the study itself, or the finest level.
enum class ReferenceFrom { result, study, finest };

struct StudyDeclaration {
    Place place;
    model::StudySaid said;
    std::vector<Varied> vary;      ///< by name, without seeds
    std::string levels;            ///< the varied parameter whose values make the levels; empty when none does
    bool size_is_function = false; ///< else the level's own value is the size
    std::vector<Plain> seeds;      ///< whole numbers; empty: seeds are not varied
    ReferenceFrom reference_from = ReferenceFrom::result;

    // As the parameters of this reading have them.
    std::optional<double> reference;
    std::optional<double> tolerance;
    std::optional<double> size; ///< positive; none when `levels` is empty
};

/// What the scene gave as functions of the parameters, asked once these are all known.
struct StudyFunctions {
    Function reference;
    Function tolerance;
    Function size;
};

} // namespace demlua::scripting
