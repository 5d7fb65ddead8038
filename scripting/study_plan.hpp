// Which runs a study is made of.
#pragma once

#include "engine/study/study.hpp"
#include "scripting/script.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace demlua::scripting {

/// One run to be made: the scene with these parameters.
struct PlannedRun {
    Overrides overrides;   ///< the user's own and what the study varies
    std::string folder;    ///< name below the study's folder
    std::string identity;  ///< the same for runs that must come out the same: texts, parameters, version of the program
    double duration = 0.0; ///< s that the scene asks to be simulated, as far as is known beforehand
    study::Run run;        ///< what is known of it; the reference is unknown when a result brings it
};

struct StudyPlan {
    std::filesystem::path scene;
    StudyDeclaration declaration;
    study::Question question;
    std::vector<PlannedRun> runs; ///< series by series, coarse to fine
};

/// Reads and checks the scene once for every combination of what its study varies. With `quick` only the two coarsest
/// levels of each series and the first seed remain. Throws SceneError with every problem of the declaration, or of the
/// first combination that is no right scene.
StudyPlan plan_study(const std::filesystem::path& scene, const Overrides& overrides, bool quick);

} // namespace demlua::scripting
