#include "engine/study/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace demlua::study {

namespace {

/// "1,234,567"
std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t tail = 3; tail < text.size(); tail += 4) text.insert(text.size() - tail, ",");
    return text;
}

std::string text_of(const std::optional<double>& number, const char* format) {
    return number ? fmt::format(fmt::runtime(format), *number) : "";
}

std::string share_text(const std::optional<double>& error, bool relative) {
    if (!error) return "";
    return relative ? fmt::format("{:+.3g} %", 100.0 * *error) : fmt::format("{:+.3g}", *error);
}

std::string time_text(const std::optional<double>& seconds) {
    if (!seconds) return "";
    return *seconds < 0.1 ? fmt::format("{:.3f} s", *seconds) : fmt::format("{:.4g} s", *seconds);
}

std::string with_unit(const std::string& name, const std::string& unit) {
    return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

struct Column {
    std::string heading;
    std::function<std::string(const Series&, const Level&)> cell;
};

std::vector<Column> columns_of(const Question& question) {
    const auto relative = [](const Level& level) { return level.reference != 0.0; };
    return {
        {"series", [](const Series& series, const Level& /*l*/) { return series.name; }},
        {with_unit(question.levels, question.levels_unit),
         [](const Series& /*s*/, const Level& level) { return level.name; }},
        {"size", [own = question.own_size](
                     const Series& /*s*/, const Level& level) { return own ? fmt::format("{:.4g}", level.size) : ""; }},
        {"runs", [](const Series& /*s*/,
                    const Level& level) { return level.runs.size() > 1 ? std::to_string(level.runs.size()) : ""; }},
        {"elements", [](const Series& /*s*/, const Level& level) { return grouped(level.runs.front().elements); }},
        {"steps", [](const Series& /*s*/, const Level& level) { return grouped(level.runs.front().steps); }},
        {with_unit(question.measure, question.unit),
         [](const Series& /*s*/, const Level& level) { return fmt::format("{:.6g}", level.value); }},
        {"scatter", [](const Series& /*s*/, const Level& level) { return text_of(level.scatter, "{:.2g}"); }},
        {"reference", [](const Series& /*s*/, const Level& level) { return fmt::format("{:.6g}", level.reference); }},
        {"error", [=](const Series& /*s*/, const Level& level) { return share_text(level.error, relative(level)); }},
        {"its scatter",
         [](const Series& /*s*/, const Level& level) {
             const auto& scatter = level.error_scatter;
             return !scatter                 ? ""
                    : level.reference == 0.0 ? fmt::format("{:.2g}", *scatter)
                                             : fmt::format("{:.2g} %", 100.0 * *scatter);
         }},
        {"p of error", [](const Series& /*s*/, const Level& level) { return text_of(level.order_of_error, "{:.2f}"); }},
        {"p (eq 20)", [](const Series& /*s*/, const Level& level) { return text_of(level.order, "{:.2f}"); }},
        {"extrapolated", [](const Series& /*s*/, const Level& level) { return text_of(level.extrapolated, "{:.6g}"); }},
        {"wall time", [](const Series& /*s*/, const Level& level) { return time_text(level.wall_time); }},
        {"ns/el./step", [](const Series& /*s*/,
                           const Level& level) { return level.cost ? fmt::format("{:.1f}", 1e9 * *level.cost) : ""; }},
        {"peak memory",
         [](const Series& /*s*/, const Level& level) { return fmt::format("{:.1f} MB", 1e-6 * level.peak_memory); }},
    };
}

std::string quoted(const std::string& text) {
    std::string made = "\"";
    for (const char c : text) made += c == '"' ? "\"\"" : std::string(1, c);
    return made + "\"";
}

} // namespace

Table table_of(const Study& study) {
    Table table;
    for (const Column& column : columns_of(study.question)) {
        std::vector<std::string> cells;
        for (const Series& series : study.series) {
            for (const Level& level : series.levels) cells.push_back(column.cell(series, level));
        }
        if (std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return cell.empty(); })) continue;
        table.headings.push_back(column.heading);
        table.rows.resize(cells.size());
        for (std::size_t k = 0; k < cells.size(); ++k) table.rows[k].push_back(std::move(cells[k]));
    }
    return table;
}

std::vector<std::string> lines_of(const Table& table) {
    std::vector<std::size_t> widths;
    for (const std::string& heading : table.headings) widths.push_back(heading.size());
    for (const auto& row : table.rows) {
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    }
    const auto line = [&](const std::vector<std::string>& cells) {
        std::string text;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            text += fmt::format("{}{:>{}}", k == 0 ? "" : "  ", cells[k].empty() ? "-" : cells[k], widths[k]);
        }
        return text;
    };
    std::vector<std::string> lines{line(table.headings)};
    for (const auto& row : table.rows) lines.push_back(line(row));
    return lines;
}

std::string csv_of(const Study& study) {
    const auto number = [](const std::optional<double>& value) {
        return value && std::isfinite(*value) ? fmt::format("{}", *value) : "";
    };
    std::string text =
        "series,size,runs,elements,steps,value,scatter,reference,error,error_scatter,order_of_error,order,"
        "extrapolated,wall_time_s,s_per_element_step,peak_memory_bytes\n";
    for (const Series& series : study.series) {
        for (const Level& level : series.levels) {
            const Run& run = level.runs.front();
            text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", quoted(series.name),
                                number(level.size), level.runs.size(), run.elements, run.steps, number(level.value),
                                number(level.scatter), number(level.reference), number(level.error),
                                number(level.error_scatter), number(level.order_of_error), number(level.order),
                                number(level.extrapolated), number(level.wall_time), number(level.cost),
                                number(level.peak_memory));
        }
    }
    return text;
}

} // namespace demlua::study
