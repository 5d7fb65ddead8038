// Studies put together from runs whose results follow a known law, and how they are shown.
#include "engine/study/axis.hpp"
#include "engine/study/page.hpp"
#include "engine/study/table.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>

using namespace demlua;
using Catch::Approx;
using namespace demlua::study;

namespace {

/// A run whose value is reference (1 + error).
Run run_of(const std::string& series, double size, double reference, double error) {
    Run run;
    run.series = series;
    run.level = std::to_string(size);
    run.size = size;
    run.value = reference * (1.0 + error);
    run.reference = reference;
    run.elements = 100;
    run.steps = 1000;
    run.cost = Cost{2.0, 1.0};
    return run;
}

Question question_of_size() {
    Question question;
    question.measure = "height";
    question.levels = "radius";
    return question;
}

} // namespace

TEST_CASE("runs become series and levels, coarse to fine, with means and scatter over seeds", "[study]") {
    const Study made = study_of(question_of_size(), {run_of("b", 1.0, 2.0, 0.1), run_of("b", 2.0, 2.0, 0.39),
                                                     run_of("b", 2.0, 2.0, 0.41), run_of("a", 1.0, 2.0, -0.1)});
    REQUIRE(made.series.size() == 2);
    CHECK(made.series[0].name == "b");
    REQUIRE(made.series[0].levels.size() == 2);
    const Level& coarse = made.series[0].levels[0];
    CHECK(coarse.size == 2.0);
    CHECK(coarse.value == Approx(2.8));
    CHECK(coarse.error.value() == Approx(0.4));
    CHECK(coarse.error_scatter.value() == Approx(0.02 / std::sqrt(2.0)));
    CHECK(coarse.wall_time.value() == 2.0);
    CHECK(coarse.cost.value() == Approx(1.0 / 1e5));
    CHECK(made.series[0].levels[1].order_of_error.value() == Approx(2.0));
    CHECK_FALSE(made.series[1].slope.has_value());
}

TEST_CASE("where references differ between levels, orders are those of value over reference", "[study]") {
    std::vector<Run> runs;
    for (const double size : {4.0, 2.0, 1.0}) runs.push_back(run_of("", size, 10.0 + size, 0.01 * size * size));
    const Study made = study_of(question_of_size(), runs);
    const Level& finest = made.series[0].levels.back();
    CHECK(made.series[0].scaled);
    CHECK(finest.order.value() == Approx(2.0));
    CHECK(finest.extrapolated.value() == Approx(11.0));
    CHECK(made.series[0].slope->exponent == Approx(2.0));
}

TEST_CASE("the finest level as reference has no error of its own", "[study]") {
    Question question = question_of_size();
    question.against_finest = true;
    std::vector<Run> runs;
    for (const double size : {4.0, 2.0, 1.0}) {
        runs.push_back(run_of("", size, 1.0, 0.1 * size));
        runs.back().reference = unknown;
    }
    const Study made = study_of(question, runs);
    const auto& levels = made.series[0].levels;
    CHECK(levels[0].error.value() == Approx((1.4 - 1.1) / 1.1));
    CHECK_FALSE(levels[2].error.has_value());
    CHECK_FALSE(levels[2].order_of_error.has_value());
    CHECK(levels[2].order.value() == Approx(1.0));
}

TEST_CASE("a study keeps to its tolerance or does not", "[study]") {
    std::vector<Run> runs{run_of("", 2.0, 1.0, 0.04), run_of("", 1.0, 1.0, 0.01)};
    Question question = question_of_size();
    CHECK_FALSE(within_tolerance(study_of(question, runs)).has_value());
    runs[1].tolerance = 0.02;
    CHECK(within_tolerance(study_of(question, runs)).value());
    question.order = {{1.9, 2.1}};
    CHECK(within_tolerance(study_of(question, runs)).value());
    question.order = {{2.5, 3.5}};
    CHECK_FALSE(within_tolerance(study_of(question, runs)).value());
    question.order.reset();
    runs[1].tolerance = 0.005;
    CHECK_FALSE(within_tolerance(study_of(question, runs)).value());
}

TEST_CASE("tables leave out what nobody said, and lines are equally long", "[study]") {
    std::vector<Run> runs{run_of("", 2.0, 1.0, 0.04), run_of("", 1.0, 1.0, 0.01)};
    runs[0].cost.reset();
    const Table table = table_of(study_of(question_of_size(), runs));
    const auto& headings = table.headings;
    CHECK(std::find(headings.begin(), headings.end(), "series") == headings.end());
    CHECK(std::find(headings.begin(), headings.end(), "scatter") == headings.end());
    CHECK(std::find(headings.begin(), headings.end(), "p of error") != headings.end());
    const auto lines = lines_of(table);
    REQUIRE(lines.size() == 3);
    CHECK(lines[1].size() == lines[0].size());
    CHECK(lines[2].size() == lines[0].size());
}

TEST_CASE("what users write cannot end a tag of the page or a cell of the table", "[study]") {
    Question question = question_of_size();
    question.title = "<b> & \"more\"";
    const Study made = study_of(question, {run_of("scheme = \"<x>\"", 1.0, 1.0, 0.1)});
    const std::string page = page_of(made, "demlua");
    CHECK_THAT(page, Catch::Matchers::ContainsSubstring("<h1>&lt;b&gt; &amp; &quot;more&quot;</h1>"));
    CHECK(page.find("<x>") == std::string::npos);
    CHECK_THAT(csv_of(made), Catch::Matchers::ContainsSubstring("\"scheme = \"\"<x>\"\"\",1,"));
}

TEST_CASE("axes hold all values, with labels one can read", "[study]") {
    for (const auto& values : {std::vector{1.0}, std::vector{2e-3, 8e-3}, std::vector{1e-9, 3e4}}) {
        const Axis axis = axis_over(values);
        for (const double value : values) CHECK((axis.low < value && value < axis.high));
        const auto labelled =
            std::count_if(axis.ticks.begin(), axis.ticks.end(), [](const Tick& tick) { return !tick.label.empty(); });
        CHECK(labelled >= 2);
        CHECK(labelled <= 15);
    }
    CHECK(tick_text(0.002) == "0.002");
    CHECK(tick_text(20.0) == "20");
    CHECK(tick_text(2e-6) == "2e-6");
    CHECK(tick_text(1e7) == "1e7");
}
