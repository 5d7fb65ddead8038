#include "engine/study/page.hpp"

#include "engine/study/plot.hpp"
#include "engine/study/table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace demlua::study {

namespace {

constexpr double percent = 100.0;

bool relative(const Study& study) { return study.series.front().levels.front().reference != 0.0; }

std::string with_unit(const std::string& name, const std::string& unit) {
    return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

std::string error_label(const Study& study) {
    return with_unit("error of " + study.question.measure, relative(study) ? "%" : study.question.unit);
}

double error_of(const Study& study, double error) { return std::abs(error) * (relative(study) ? percent : 1.0); }

std::string name_of(const Series& series, const Question& question) {
    return series.name.empty() ? question.measure : series.name;
}

/// A curve of error over what `x` reads from a level; `x_of_run` reads it from a single run.
template <class OfLevel, class OfRun>
Curve curve_of(const Study& study, const Series& series, const OfLevel& x, const OfRun& x_of_run) {
    Curve curve{name_of(series, study.question), {}};
    for (const Level& level : series.levels) {
        if (!level.error) continue;
        curve.points.push_back({x(level), error_of(study, *level.error)});
        if (level.runs.size() < 2) continue;
        for (const Run& run : level.runs) {
            curve.single.push_back({x_of_run(run), error_of(study, relative_error(run.value, run.reference))});
        }
    }
    return curve;
}

Line slope_of(const Study& study, const Series& series, std::size_t curve) {
    const std::string of = series.name.empty() ? "" : fmt::format(" ({})", series.name);
    return {fmt::format("slope {:.2f}{}", series.slope->exponent, of), error_of(study, series.slope->factor),
            series.slope->exponent, curve};
}

constexpr const char* style =
    R"(body { font: 15px/1.45 sans-serif; color: #202020; max-width: 1200px; margin: 2em auto; padding: 0 1em; }
table { border-collapse: collapse; margin: 1em 0; font-variant-numeric: tabular-nums; }
th, td { padding: 0.3em 0.7em; text-align: right; border-bottom: 1px solid #d8d8d8; white-space: nowrap; }
th { border-bottom: 2px solid #404040; }
.wide { overflow-x: auto; }
svg { max-width: 100%; height: auto; }
.quiet { color: #606060; }
)";

std::string html_of(const Table& table) {
    std::string text = "<div class=\"wide\"><table>\n<tr>";
    for (const auto& heading : table.headings) text += fmt::format("<th>{}</th>", escaped(heading));
    text += "</tr>\n";
    for (const auto& row : table.rows) {
        text += "<tr>";
        for (const auto& cell : row) text += fmt::format("<td>{}</td>", escaped(cell));
        text += "</tr>\n";
    }
    return text + "</table></div>\n";
}

} // namespace

std::string error_size_svg(const Study& study) {
    const Question& question = study.question;
    const bool plain = !question.own_size && !question.levels.empty();
    const std::string size_name = plain ? question.levels : "size";
    const std::string size_label = plain ? with_unit(question.levels, question.levels_unit)
                                   : question.own_size
                                       ? fmt::format("size that the scene gives for {}", question.levels)
                                       : "size";
    Plot plot{fmt::format("{}: error against {}", question.measure, size_name), size_label, error_label(study), {}};
    plot.instead = question.levels.empty() ? "no size is varied" : "there is no error to draw";
    for (const Series& series : study.series) {
        plot.curves.push_back(curve_of(
            study, series, [](const Level& level) { return level.size; }, [](const Run& run) { return run.size; }));
        if (series.slope) plot.lines.push_back(slope_of(study, series, plot.curves.size() - 1));
    }
    return svg_of(plot);
}

std::string error_time_svg(const Study& study) {
    Plot plot{
        fmt::format("{}: error against wall time", study.question.measure), "wall time (s)", error_label(study), {}};
    plot.instead = "no times: levels have run side by side";
    for (const Series& series : study.series) {
        plot.curves.push_back(curve_of(
            study, series, [](const Level& level) { return level.wall_time.value_or(unknown); },
            [](const Run& run) { return run.cost ? run.cost->wall_time : unknown; }));
    }
    return svg_of(plot);
}

std::string page_of(const Study& study, const std::string& version) {
    const Question& question = study.question;
    const std::string title = question.title.empty() ? question.scene : question.title;
    std::string text = fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                                   "<title>{0}</title>\n<style>\n{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n",
                                   escaped(title), style);
    text += fmt::format("<p>{} of {}", escaped(question.measure), escaped(question.scene));
    if (!question.source.empty()) text += fmt::format("; reference: {}", escaped(question.source));
    text += ".</p>\n" + html_of(table_of(study));
    for (const auto& note : notes_on(study)) text += fmt::format("<p class=\"quiet\">{}</p>\n", escaped(note));
    text += error_size_svg(study) + error_time_svg(study);
    return text + fmt::format("<p class=\"quiet\">{}</p>\n</body>\n</html>\n", escaped(version));
}

} // namespace demlua::study
