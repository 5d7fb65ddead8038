// The runs of a study, each a process of its own: one after the other, or side by side.
#pragma once

#include "scripting/child.hpp"
#include "scripting/study_plan.hpp"
#include "scripting/terminal.hpp"

#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace demlua::scripting {

struct StudySettings {
    std::filesystem::path folder;
    int jobs = 1;    ///< runs side by side; with more than one, none is timed
    int threads = 0; ///< of each run; 0: as many as there are processors, shared out among the jobs
};

enum class StudyEnding { done, failed, interrupted };

class StudyRunner {
public:
    /// `interrupted` is polled; all references outlive the runner.
    StudyRunner(const StudyPlan& plan, const StudySettings& settings, Terminal& terminal,
                const std::atomic<bool>& interrupted);

    /// Makes the runs that are not finished yet and tells of each. When one fails, or does not bring what is measured,
    /// those under way are ended. What was finished stays.
    StudyEnding run();

    /// The complaint of the first run that failed.
    [[nodiscard]] const std::string& failure() const { return failure_; }

    /// How many runs are finished by now.
    [[nodiscard]] std::size_t finished() const { return finished_; }

private:
    /// One place where runs are made, one after the other.
    struct Lane {
        Child child;
        std::optional<std::size_t> run; ///< under way
        double begin = 0.0;             ///< s, on a steady clock
    };

    [[nodiscard]] std::filesystem::path folder_of(const PlannedRun& planned) const;
    [[nodiscard]] std::vector<std::string> arguments_for(const PlannedRun& planned) const;
    [[nodiscard]] bool stopping() const;
    void work(Lane& lane);
    void make(Lane& lane, const PlannedRun& planned);
    ChildEnd make_once(Lane& lane, const PlannedRun& planned);
    void watch(std::vector<Lane>& lanes);
    void tell(std::vector<Lane>& lanes);
    [[nodiscard]] std::string passing_line(const Lane& lane) const;

    const StudyPlan& plan_;
    const StudySettings& settings_;
    Terminal& terminal_;
    const std::atomic<bool>& interrupted_;

    std::mutex mutex_;                 ///< of all that follows
    std::vector<std::size_t> waiting_; ///< the next one last
    std::vector<std::string> news_;
    std::string failure_;
    std::size_t finished_ = 0;
    std::size_t working_ = 0; ///< lanes
};

} // namespace demlua::scripting
