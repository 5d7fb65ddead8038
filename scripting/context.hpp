// What one reading of a scene file carries from the first line to the last.
#pragma once

#include "engine/model/scene.hpp"
#include "scripting/host.hpp"
#include "scripting/lua.hpp"
#include "scripting/objects.hpp"
#include "scripting/plain.hpp"
#include "scripting/script.hpp"
#include "scripting/study_declaration.hpp"

#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace demlua::scripting {

/// Whether a problem lies in how a scene is written, or may come of a value. Values cannot be judged after the first run
/// of a reading that does not simulate, for they may hang on results that are not there.
enum class Cause { wording, value };

/// A signal said as a function of time; sampled when a run begins, for the time it takes.
struct TimeFunction {
    LoadHandle load;
    std::string setting;
    int component = 0; ///< of a pair of signals
    Function function;
    Place place;
};

/// A column the scene adds to the history: a function of now, or else a field.
struct HistoryColumn {
    std::string name;
    Function function;
    std::string measure;
};
struct History {
    SharedInterval interval;
    std::vector<HistoryColumn> columns;
    Place place;
};
struct Periodic {
    double every = 0.0;
    Function act;
};

/// A file being read, with what the file that includes it wants its parameters to be.
struct Inclusion {
    std::filesystem::path file;
    std::map<std::string, Plain> values;
};

/// How many rows of each kind the simulation knows.
using RowCounts = std::map<LoadKind, std::size_t>;

struct Context {
    Context(const Overrides& set, Host* program);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    Context(Context&&) = delete;
    Context& operator=(Context&&) = delete;

    static Context& of(lua_State* L) { return *Interpreter::of(L).context; }

    // --- what the scene said ---------------------------------------------------------------------------------------
    model::Scene scene;
    bool simulation_said = false;
    std::vector<Parameter> parameters;
    std::vector<TimeFunction> time_functions;
    std::vector<std::function<bool(Vec2)>> place_functions; ///< not yet tried
    std::vector<SharedInterval> outputs;
    std::vector<History> histories;
    std::vector<Periodic> periodics;
    std::vector<Function> on_bond_break;
    std::vector<Function> functions; ///< what model::Callback::key counts from one
    std::optional<StudyDeclaration> study;
    StudyFunctions study_functions;
    std::vector<std::string> result_names; ///< published so far
    std::vector<Problem> problems;
    std::size_t complaints = 0;                   ///< problems seen, those not kept included
    std::set<std::pair<std::string, int>> blamed; ///< places of problems found while reading

    // --- where the reading stands ----------------------------------------------------------------------------------
    Overrides overrides;
    std::vector<Inclusion> inclusions;  ///< files being read, the innermost last
    bool read_to_end = false;           ///< nothing stopped the script
    std::vector<SourceFile> files;      ///< read so far, the scene's own first
    std::vector<Place> open_inclusions; ///< dem.include "file" not yet followed by its table
    std::exception_ptr fatal;           ///< ends the reading even if the user's code catches it

    // --- the run -----------------------------------------------------------------------------------------------------
    Host* host;                             ///< null: nothing is simulated
    observe::Simulation* watched = nullptr; ///< during a callback
    std::vector<RunRequest> runs;           ///< so far, without functions
    model::Scene scene_at_first_run;
    double skipped_time = 0.0; ///< that runs would have taken when nothing is simulated, s
    double run_end = 0.0;      ///< s
    RowCounts assembled;
    std::vector<LoadHandle> changed; ///< since the simulation last heard
    bool grown = false;              ///< rows have been added since
    bool interrupted = false;

    // Last, so that the functions above are let go while their state still is there.
    std::shared_ptr<Interpreter> interpreter;

    [[nodiscard]] bool simulates() const { return host != nullptr; }
    /// The simulation as it stands, or null when nothing has run or nothing is simulated.
    [[nodiscard]] observe::Simulation* simulation() const;
    /// Throws LuaFailure while there is nothing to read.
    void require_run() const;
    [[nodiscard]] double time() const;

    void complain(Problem problem, Cause cause);
    /// Runs the model's checker; what it finds where reading already found fault is not told again.
    void check_model();
    /// Throws SceneError with all problems, if there are any.
    void throw_problems() const;

    /// Runs the file `name` (as messages call it) with its parameters as `values` have them, and leaves as many of the
    /// values it returns on the stack. Throws SceneError.
    void run_file(const std::filesystem::path& name, const std::map<std::string, Plain>& values, int results = 0);
};

} // namespace demlua::scripting
