// A scene set in motion: assemble it, run it, look at it, change it, run it again.
#pragma once

#include "engine/base/team.hpp"
#include "engine/model/scene.hpp"
#include "engine/observe/snapshot.hpp"
#include "engine/packing/pack_store.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace demlua::state {
struct Drive;
struct State;
} // namespace demlua::state

namespace demlua::observe {

class Simulation;

/// Something that looks at the simulation between steps: at the start of a run, then every `every` seconds (at the first
/// step that reaches the time; every step when `every` is zero), and at its end. The time step is made to fit the shortest
/// interval where that costs little. `act` may read, change loads and velocities, or call stop().
struct Watcher {
    double every = 0.0; ///< s
    std::function<void(Simulation&)> act;
};

/// Why a run came back.
enum class Ending { finished, stopped, interrupted };

struct RunReport {
    Ending ending = Ending::finished;
    std::string reason;      ///< given to stop()
    std::uint64_t steps = 0; ///< in this run
    double wall_time = 0.0;  ///< s
    int solutions = 0;       ///< of linear systems, when it was a static solution
    double residual = 0.0;   ///< likewise, of the loads, what is left on free elements
};

/// Time spent in one stage since the start.
struct StageTime {
    std::string stage;
    double seconds = 0.0;
};

class Simulation {
public:
    /// Packs, bonds and checks the scene. `threads` 0: as many as there are processors and work for. Throws SceneError with every problem that only the packed scene shows.
    /// `packs` may keep packs from run to run; it is asked only here.
    Simulation(const model::Scene& scene, Threads threads, const packing::PackStore* packs = nullptr);
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    Simulation(Simulation&&) = delete;
    Simulation& operator=(Simulation&&) = delete;

    // --- running ---------------------------------------------------------------------------------------------------

    /// Advances by `duration` (s). Watchers that are due at one instant act in the order given. Throws RunError when
    /// the run cannot go on; the state is then that of the last good instant at which watchers looked.
    /// `interrupted`, when given, is polled between steps. With `until_rest` the run stops as soon as all is at rest (rest.hpp).
    RunReport run(double duration, const std::vector<Watcher>& watchers, const std::atomic<bool>* interrupted = nullptr,
                  bool until_rest = false);
    /// The same from rest to rest (step/quasi_static.hpp); loads are taken to grow slowly, as by solve_static. Ends as
    /// stopped, with the reason, where there is no rest beyond; the state is then the last one at rest.
    RunReport run_quasi_static(const model::QuasiStaticRun& said, const std::vector<Watcher>& watchers,
                               const std::atomic<bool>* interrupted = nullptr);
    /// Moves the elements to rest under the loads of this instant (step/static_solve.hpp); watchers act before and after.
    /// Counts as one step. Loads are taken to grow slowly: their work is what the stored energies change by; the kinetic
    /// energy of what moved is gone. Throws SceneError, leaving the state as it was.
    RunReport solve_static(const model::StaticSolve& said, const std::vector<Watcher>& watchers);
    /// Ends the run after the watchers of this instant.
    void stop(std::string reason);

    // --- changing, between runs or from a watcher ------------------------------------------------------------------

    /// Takes in what was added to the scene since the last call: supports, motions, forces, tractions, notches,
    /// damping and probes of both kinds. Bodies and walls cannot be added once assembled: SceneError.
    void take_in(const model::Scene& scene);
    /// Replaced loads and motions keep the elements they were first said for.
    void replace_force(std::size_t row, const model::Force& force);
    void replace_traction(std::size_t row, const model::Traction& traction);
    void replace_motion(std::size_t row, const model::Motion& motion);
    void replace_wall(std::size_t row, const model::Wall& wall);
    void replace_outline(std::size_t row, const model::Outline& outline);
    void set_velocity(const model::Selection& selection, Vec2 velocity);

    // --- looking ---------------------------------------------------------------------------------------------------

    [[nodiscard]] double time() const; ///< s
    [[nodiscard]] std::uint64_t step() const;
    [[nodiscard]] double time_step() const;             ///< s
    [[nodiscard]] std::string time_step_reason() const; ///< one line: the rule, the bound, where it is tightest
    [[nodiscard]] int threads() const;
    [[nodiscard]] std::size_t element_count() const;
    [[nodiscard]] std::size_t bond_count() const;
    [[nodiscard]] std::size_t contact_count() const; ///< touching now
    [[nodiscard]] std::size_t broken_bonds() const;
    [[nodiscard]] double
    crack_length() const; ///< m, sum over broken bonds of their facets, or else of the mean diameter of their elements
    [[nodiscard]] double surface_energy() const; ///< J, what broken bonds took: plastic work and what they still held
    [[nodiscard]] std::size_t worn_elements() const;    ///< that have left their cluster
    [[nodiscard]] std::size_t removed_elements() const; ///< that have left the domain
    [[nodiscard]] std::size_t fragments() const;        ///< parts held together by bonds that are not broken
    [[nodiscard]] Ledger ledger() const;
    [[nodiscard]] Momentum momentum() const;
    [[nodiscard]] BodyMotion body_motion(std::size_t body) const;
    [[nodiscard]] Vec2 wall_force(std::size_t wall) const;        ///< on the wall, N
    [[nodiscard]] WallMotion wall_motion(std::size_t wall) const; ///< walls in the scene's order, then outlines
    [[nodiscard]] Snapshot snapshot() const;
    /// Names: those of element fields of the snapshot; components by suffix (_x, _y, _xx, _yy, _xy). Empty selection:
    /// all elements. Throws SceneError for an unknown name, listing the known ones.
    [[nodiscard]] std::vector<double> field(const std::string& name, const model::Selection& selection) const;
    /// What a probe reads: the sum for forces and energies, the mean otherwise.
    [[nodiscard]] double measure(const std::string& name, const model::Selection& selection) const;
    /// The standing columns of the history (time, ledger, momentum, bonds, cracks, fragments, probes), without those of
    /// features the scene does not use.
    [[nodiscard]] HistoryRow history_row() const;
    /// What runs in a step, how it is chosen, and what does not run: `step: bonds[plateau] > ...; unused: ...`.
    [[nodiscard]] std::string schedule() const;
    [[nodiscard]] std::vector<StageTime> stage_times() const;
    /// Facts a reader should know (coordination, elements removed, ...), one sentence each, in order.
    [[nodiscard]] std::vector<std::string> notes() const;
    /// Hash of positions, velocities, rotations and bond states; equal for equal states, whatever the thread count.
    [[nodiscard]] std::uint64_t hash() const;

    [[nodiscard]] const state::State& state() const { return *state_; }

private:
    static constexpr std::uint64_t energy_checked_every = 1000; ///< steps
    static constexpr std::uint64_t rest_checked_every = 100;    ///< steps
    static constexpr double rest_share = 1e-3;

    void check_period() const;
    void take_in(const model::Notch& notch);
    void take_in(const model::Damping& said);
    void release(std::size_t body, double before);
    void add_drives(std::vector<std::size_t>& rows, std::vector<state::Drive> drives);
    void prepare(const std::vector<double>& intervals);
    void start_once();
    [[nodiscard]] double step_in_flight(double ahead) const;
    /// `go` moves the state on, to the time it is given at most if it can; false when it cannot go on.
    RunReport run_until(double end, const std::vector<Watcher>& watchers, const std::atomic<bool>* interrupted,
                        const std::function<bool(double)>& go);
    void check_energy() const;
    void add_probes(HistoryRow& row) const;

    struct Inside;
    std::unique_ptr<state::State> state_;
    std::unique_ptr<Inside> inside_;
};

/// Names of the fields a probe can measure, for the reader's check.
std::vector<std::string> measurable_fields();

} // namespace demlua::observe
