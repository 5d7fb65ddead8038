// What a study keeps of its runs on disk, so that finished ones are not run again.
#pragma once

#include "engine/study/study.hpp"
#include "scripting/child.hpp"
#include "scripting/study_plan.hpp"

#include <filesystem>
#include <optional>

namespace demlua::scripting {

/// Name of the file, in the run's folder.
inline constexpr const char* record_name = "study_run.json";

/// Notes that a run has ended as it should. `cost` is none when others ran beside it.
void write_record(const std::filesystem::path& folder, const PlannedRun& planned,
                  const std::optional<study::Cost>& cost, double peak_memory);
/// Forgets it.
void remove_record(const std::filesystem::path& folder);

/// Whether the folder holds this very run, finished.
bool is_finished(const std::filesystem::path& folder, const PlannedRun& planned);

/// Wall time of the steps of the run in the folder, s.
double stepping_time(const std::filesystem::path& folder);

/// The run whose summary is in the folder, with what it measured. Throws SceneError when the quantity or the reference is
/// not among its results or no finite number.
study::Run measured(const std::filesystem::path& folder, const StudyPlan& plan, const PlannedRun& planned);

/// The same of a finished run, with what it took.
study::Run finished_run(const std::filesystem::path& folder, const StudyPlan& plan, const PlannedRun& planned);

} // namespace demlua::scripting
