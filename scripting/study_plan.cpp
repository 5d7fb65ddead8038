#include "scripting/study_plan.hpp"

#include "demlua/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <set>
#include <utility>

namespace demlua::scripting {

namespace {

/// What one combination sets, apart from the user's own overrides.
struct Combination {
    std::vector<std::pair<std::string, Plain>> series; ///< neither level nor seed
    std::vector<std::pair<std::string, Plain>> level;  ///< at most one
    std::vector<std::pair<std::string, Plain>> seed;   ///< at most one

    [[nodiscard]] std::vector<std::pair<std::string, Plain>> all() const {
        auto together = series;
        together.insert(together.end(), level.begin(), level.end());
        together.insert(together.end(), seed.begin(), seed.end());
        return together;
    }
};

using Part = std::vector<std::pair<std::string, Plain>> Combination::*;

/// Every combination so far with every one of the values.
std::vector<Combination> crossed(const std::vector<Combination>& so_far, Part part, const std::string& name,
                                 const std::vector<Plain>& values) {
    std::vector<Combination> made;
    for (const Combination& each : so_far) {
        for (const Plain& value : values) {
            made.push_back(each);
            (made.back().*part).emplace_back(name, value);
        }
    }
    return made;
}

std::vector<Combination> combinations(const StudyDeclaration& study, bool quick) {
    std::vector<Combination> all(1);
    for (const Varied& varied : study.vary) {
        if (varied.parameter != study.levels) all = crossed(all, &Combination::series, varied.parameter, varied.values);
    }
    for (const Varied& varied : study.vary) {
        if (varied.parameter == study.levels) all = crossed(all, &Combination::level, varied.parameter, varied.values);
    }
    std::vector<Plain> seeds = study.seeds;
    if (quick && !seeds.empty()) seeds.resize(1);
    return seeds.empty() ? all : crossed(all, &Combination::seed, seed_parameter, seeds);
}

std::string named(const std::vector<std::pair<std::string, Plain>>& set) {
    std::string text;
    for (const auto& [name, value] : set) {
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, text_of(value));
    }
    return text;
}

/// "radius=0.004_seed=2", or "run" when nothing is varied; letters that a folder's name should not have become "-".
std::string folder_name(const Combination& combination) {
    std::string text;
    for (const auto& [name, value] : combination.all()) {
        text += fmt::format("{}{}={}", text.empty() ? "" : "_", name, text_of(value));
    }
    for (char& c : text) {
        const bool plain =
            std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string("=_.+-").find(c) != std::string::npos;
        if (!plain) c = '-';
    }
    return text.empty() ? "run" : text;
}

/// FNV-1a over everything added.
class Fingerprint {
public:
    void add(const std::string& text) {
        for (const char c : text + '\n') {
            sum_ = (sum_ ^ static_cast<unsigned char>(c)) * 1099511628211U;
        }
    }
    [[nodiscard]] std::string text() const { return fmt::format("{:016x}", sum_); }

private:
    std::uint64_t sum_ = 14695981039346656037U;
};

std::string identity_of(const SceneSummary& scene, std::uint64_t repeats) {
    Fingerprint print;
    print.add(fmt::format("{} {} {} {}", version, revision, compiler, build_type));
    for (const SourceFile& file : scene.files) print.add(file.text);
    for (const Parameter& parameter : scene.parameters) {
        print.add(parameter.name + " = " + text_of(Plain{parameter.value, false}));
    }
    print.add(std::to_string(repeats));
    return print.text();
}

/// The problems of a scene that is right only with other values.
[[noreturn]] void throw_with(const SceneError& error, const std::string& set) {
    std::vector<Problem> problems = error.problems();
    for (Problem& problem : problems) {
        if (!set.empty()) problem.hint += (problem.hint.empty() ? "with " : "; with ") + set;
    }
    throw SceneError(std::move(problems));
}

PlannedRun planned(const std::filesystem::path& file, const Overrides& overrides, const Combination& combination) {
    PlannedRun planned{overrides, folder_name(combination), {}, 0.0, {}};
    for (const auto& [name, value] : combination.all()) planned.overrides.emplace_back(name, text_of(value));
    study::Run& run = planned.run;
    run.name = named(combination.all());
    run.series = named(combination.series);
    if (!combination.level.empty()) run.level = text_of(combination.level.front().second);
    try {
        const SceneSummary scene = check_scene(file, planned.overrides);
        for (const RunRequest& request : scene.runs) planned.duration += request.duration;
        const StudyDeclaration& study = scene.study.value();
        planned.identity = identity_of(scene, study.said.repeats);
        run.size = study.size.value_or(study::unknown);
        run.reference = study.reference.value_or(study::unknown);
        run.tolerance = study.tolerance.value_or(study::unknown);
    } catch (const SceneError& error) {
        throw_with(error, run.name);
    }
    return planned;
}

/// Coarse to fine within each series, the order of the series kept.
void sort_levels(std::vector<PlannedRun>& runs) {
    for (auto begin = runs.begin(); begin != runs.end();) {
        const auto end = std::find_if(begin, runs.end(),
                                      [&](const PlannedRun& each) { return each.run.series != begin->run.series; });
        std::stable_sort(begin, end, [](const PlannedRun& a, const PlannedRun& b) { return a.run.size > b.run.size; });
        begin = end;
    }
}

void keep_coarsest(std::vector<PlannedRun>& runs) {
    constexpr std::size_t kept_levels = 2;
    std::vector<PlannedRun> kept;
    std::string series;
    std::set<std::string> levels;
    for (PlannedRun& each : runs) {
        if (each.run.series != series) levels.clear();
        series = each.run.series;
        levels.insert(each.run.level);
        if (levels.size() <= kept_levels) kept.push_back(std::move(each));
    }
    runs = std::move(kept);
}

/// Different texts may have come to the same folder.
void make_folders_differ(std::vector<PlannedRun>& runs) {
    std::set<std::string> taken;
    for (PlannedRun& each : runs) {
        const std::string name = each.folder;
        for (int k = 2; !taken.insert(each.folder).second; ++k) each.folder = fmt::format("{}_{}", name, k);
    }
}

study::Question question_of(const std::filesystem::path& file, const SceneSummary& scene) {
    const StudyDeclaration& study = scene.study.value();
    study::Question question;
    question.scene = file.filename().string();
    question.title = scene.scene.title;
    question.measure = study.said.measure;
    question.unit = study.said.unit;
    question.source = study.said.source;
    question.because = study.said.because;
    if (study.said.order) question.order = {{study.said.order->x, study.said.order->y}};
    question.levels = study.levels;
    question.own_size = study.size_is_function;
    for (const Parameter& parameter : scene.parameters) {
        if (parameter.name == study.levels) question.levels_unit = parameter.unit;
    }
    question.against_finest = study.reference_from == ReferenceFrom::finest;
    return question;
}

void refuse_overrides_of_varied(const StudyDeclaration& study, const Overrides& overrides) {
    std::vector<Problem> problems;
    for (const auto& [name, value] : overrides) {
        const bool varied =
            std::any_of(study.vary.begin(), study.vary.end(),
                        [&, &parameter = name](const Varied& each) { return each.parameter == parameter; });
        if (varied || (name == seed_parameter && !study.seeds.empty())) {
            problems.push_back({Place(), "--set " + name, value, "is varied by the study", ""});
        }
    }
    if (!problems.empty()) throw SceneError(std::move(problems));
}

} // namespace

StudyPlan plan_study(const std::filesystem::path& file, const Overrides& overrides, bool quick) {
    const SceneSummary scene = check_scene(file, overrides);
    if (!scene.study) {
        throw SceneError(
            Problem{Place{file.string(), 0}, "dem.study", "", "is missing",
                    scene.read_to_end ? "" : "lines that need what a run brings are not read; put it before sim:run"});
    }
    refuse_overrides_of_varied(*scene.study, overrides);
    StudyPlan plan{file, *scene.study, question_of(file, scene), {}};
    plan.question.quick = quick;
    for (const Combination& each : combinations(*scene.study, quick)) {
        plan.runs.push_back(planned(file, overrides, each));
    }
    sort_levels(plan.runs);
    if (quick) keep_coarsest(plan.runs);
    make_folders_differ(plan.runs);
    return plan;
}

} // namespace demlua::scripting
