#include "engine/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace demlua::study {

namespace {

template <class Row, class Is>
Row& find_or_add(std::vector<Row>& rows, const Is& is) {
    const auto found = std::find_if(rows.begin(), rows.end(), is);
    return found != rows.end() ? *found : rows.emplace_back();
}

std::vector<Series> sorted(const std::vector<Run>& runs) {
    std::vector<Series> all;
    for (const Run& run : runs) {
        Series& series = find_or_add(all, [&](const Series& each) { return each.name == run.series; });
        series.name = run.series;
        Level& level = find_or_add(series.levels, [&](const Level& each) { return each.name == run.level; });
        level.name = run.level;
        level.size = run.size;
        level.runs.push_back(run);
    }
    for (Series& series : all) {
        std::stable_sort(series.levels.begin(), series.levels.end(),
                         [](const Level& a, const Level& b) { return a.size > b.size; });
    }
    return all;
}

template <class Get>
std::vector<double> gather(const Level& level, const Get& get) {
    std::vector<double> values;
    values.reserve(level.runs.size());
    for (const Run& run : level.runs) values.push_back(get(run));
    return values;
}

void weigh(Level& level) {
    const bool timed =
        std::all_of(level.runs.begin(), level.runs.end(), [](const Run& run) { return run.cost.has_value(); });
    if (timed) {
        level.wall_time = mean(gather(level, [](const Run& run) { return run.cost->wall_time; }));
        double stepping = 0.0;
        double work = 0.0;
        for (const Run& run : level.runs) {
            stepping += run.cost->stepping;
            work += static_cast<double>(run.elements) * static_cast<double>(run.steps);
        }
        if (work > 0.0) level.cost = stepping / work;
    }
    for (const Run& run : level.runs) level.peak_memory = std::max(level.peak_memory, run.peak_memory);
}

void average(Level& level) {
    const std::vector<double> values = gather(level, [](const Run& run) { return run.value; });
    level.value = mean(values);
    level.scatter = standard_deviation(values);
    level.reference = mean(gather(level, [](const Run& run) { return run.reference; }));
}

void compare(Level& level) {
    if (std::isnan(level.reference)) return;
    const std::vector<double> errors =
        gather(level, [](const Run& run) { return relative_error(run.value, run.reference); });
    level.error = mean(errors);
    level.error_scatter = standard_deviation(errors);
}

/// The finest level as the reference of those before it; it has no error of its own.
void measure_against_finest(Series& series) {
    const Level& finest = series.levels.back();
    for (Level& level : series.levels) {
        level.reference = finest.value;
        for (Run& run : level.runs) run.reference = finest.value;
    }
}

bool same(double a, double b) { return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b)); }

void describe_sizes(Series& series) {
    const std::vector<Level>& levels = series.levels;
    for (std::size_t k = 1; k < levels.size(); ++k) {
        if (!same(levels[k].reference, levels[0].reference)) series.scaled = true;
        // Sizes are often rounded by hand.
        const double change = levels[k - 1].size / levels[k].size / (levels[0].size / levels[1].size);
        if (std::abs(change - 1.0) > 1e-3) series.even_ratio = false;
    }
}

void find_orders(Series& series) {
    std::vector<Sample> values;
    std::vector<Sample> errors;
    for (Level& level : series.levels) {
        const double unit = series.scaled ? level.reference : 1.0;
        values.push_back({level.size, level.value / unit});
        if (level.error) errors.push_back({level.size, *level.error});
        const std::size_t n = values.size();
        if (level.error && errors.size() >= 2) {
            level.order_of_error = order_between(errors[errors.size() - 2], errors.back());
        }
        if (n < 3) continue;
        const Levels three{values[n - 3], values[n - 2], values[n - 1]};
        level.order = observed_order(three);
        level.extrapolated = extrapolated(three);
        if (level.extrapolated) *level.extrapolated *= unit;
    }
    series.slope = fitted_power(errors);
}

void work_out(Series& series, const Question& question) {
    for (Level& level : series.levels) {
        average(level);
        weigh(level);
    }
    if (question.against_finest) measure_against_finest(series);
    for (Level& level : series.levels) {
        if (!question.against_finest || &level != &series.levels.back()) compare(level);
    }
    if (question.levels.empty()) return;
    describe_sizes(series);
    find_orders(series);
}

} // namespace

Study study_of(Question question, const std::vector<Run>& runs) {
    Study study{std::move(question), sorted(runs)};
    for (Series& series : study.series) work_out(series, study.question);
    return study;
}

namespace {

template <class Is>
bool any_series(const Study& study, const Is& is) {
    return std::any_of(study.series.begin(), study.series.end(), is);
}

template <class Is>
bool any_level(const Study& study, const Is& is) {
    return any_series(
        study, [&](const Series& series) { return std::any_of(series.levels.begin(), series.levels.end(), is); });
}

} // namespace

std::vector<std::string> notes_on(const Study& study) {
    std::vector<std::string> notes;
    const auto note = [&](bool holds, const char* text) {
        if (holds) notes.emplace_back(text);
    };
    note(study.question.quick, "--quick: the two coarsest levels only, and one seed");
    note(study.question.against_finest, "errors are those against the finest level");
    note(any_level(study, [](const Level& level) { return level.error && level.reference == 0.0; }),
         "the reference is zero: errors are plain differences");
    const bool ordered = any_level(study, [](const Level& level) { return level.order.has_value(); });
    note(
        ordered && any_series(study, [](const Series& series) { return !series.even_ratio; }),
        "the sizes do not fall by a constant factor: p of three levels and the extrapolated value solve f = f0 + C h^p "
        "for the sizes as they are, in place of eqs 20 and 38");
    note(ordered && any_series(study, [](const Series& series) { return series.scaled; }),
         "references differ from level to level: p of three levels and the extrapolated value are those of value over "
         "reference, times the level's own reference");
    note(any_level(study, [](const Level& level) { return !level.wall_time; }),
         "no times where levels have run side by side; --fresh without --jobs takes them");
    return notes;
}

std::optional<bool> within_tolerance(const Study& study) {
    std::optional<bool> within;
    const auto require = [&](bool holds) { within = within.value_or(true) && holds; };
    for (const Series& series : study.series) {
        const Level& finest = series.levels.back();
        const double tolerance = finest.runs.front().tolerance;
        if (!std::isnan(tolerance) && finest.error) require(std::abs(*finest.error) <= tolerance);
        if (!study.question.order) continue;
        const auto& [low, high] = *study.question.order;
        require(finest.order_of_error && *finest.order_of_error >= low && *finest.order_of_error <= high);
    }
    return within;
}

} // namespace demlua::study
