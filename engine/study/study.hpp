// A study: one quantity of a scene at several levels, how far it is off, and what that cost.
#pragma once

#include "engine/study/convergence.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace demlua::study {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What a finished run took when nothing ran beside it.
struct Cost {
    double wall_time = 0.0; ///< s, of the whole process
    double stepping = 0.0;  ///< s, of the steps and what looks at them
};

/// One finished run.
struct Run {
    std::string name;           ///< what was set, e.g. "radius = 0.004, seed = 2"
    std::string series;         ///< what was set besides size and seed; empty when there is nothing
    std::string level;          ///< the value of the parameter that makes the levels, as it was set
    double size = unknown;      ///< element size (or what stands for it), positive; unknown where no size is varied
    double value = 0.0;         ///< the quantity measured
    double reference = 0.0;     ///< what it should be; unknown where the finest level says
    double tolerance = unknown; ///< greatest relative error allowed, if the scene says
    std::uint64_t elements = 0;
    std::uint64_t steps = 0;
    std::optional<Cost> cost;
    double peak_memory = 0.0; ///< B
};

/// What is studied.
struct Question {
    std::string scene; ///< file name
    std::string title;
    std::string measure;
    std::string unit;   ///< of the measure
    std::string levels; ///< name of the parameter that makes the levels; empty when none does
    std::string levels_unit;
    bool own_size = false; ///< sizes are worked out from the parameters; else they are the levels' own values
    std::string source;    ///< of the reference
    std::string because;   ///< why the tolerance is what it is
    std::optional<std::array<double, 2>> order; ///< within which the order of the error is expected
    bool against_finest = false;
    bool quick = false; ///< only the two coarsest levels, and one seed
};

/// All runs at one size of one series. Orders belong to this level and the one or two before it.
struct Level {
    std::string name; ///< the value that was set
    double size = unknown;
    std::vector<Run> runs;
    double value = 0.0;            ///< mean over seeds
    std::optional<double> scatter; ///< sample standard deviation over seeds
    double reference = 0.0;        ///< mean over seeds
    std::optional<double> error;   ///< relative (plain where the reference is zero), mean over seeds; none for the
                                   ///< finest level measured against itself
    std::optional<double> error_scatter;
    std::optional<double> order_of_error; ///< from the errors of this level and the one before
    std::optional<double> order;          ///< eq 20, from three levels
    std::optional<double> extrapolated;   ///< eq 38
    std::optional<double> wall_time;      ///< s, mean over seeds
    std::optional<double> cost;           ///< s per element and step
    double peak_memory = 0.0;             ///< B, the largest
};

struct Series {
    std::string name;
    std::vector<Level> levels;     ///< coarse to fine
    std::optional<PowerLaw> slope; ///< through the errors of all levels
    bool even_ratio = true;        ///< sizes fall by the same factor from level to level
    bool scaled = false;           ///< references differ between levels: orders are those of value / reference
};

struct Study {
    Question question;
    std::vector<Series> series; ///< in the order of their first runs
};

/// Sorts runs into series and levels and works out errors, orders and means. At least one run.
Study study_of(Question question, const std::vector<Run>& runs);

/// Notes a reader of the table needs: what was extrapolated how, and what is not there and why.
std::vector<std::string> notes_on(const Study& study);

/// Whether the finest level of every series keeps to the tolerance and the order expected; nothing when the scene states
/// neither.
std::optional<bool> within_tolerance(const Study& study);

} // namespace demlua::study
