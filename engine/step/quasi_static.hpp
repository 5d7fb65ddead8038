// Loads that grow slowly, without marching: the bonded network is solved at rest, event after event.
//
// Time is only what the loads depend on. The network is factorised once; bonds that yield or break are condensed out
// (failing_part.hpp), so that only what fails costs anything beyond. From one rest to the next the loads grow until some
// bond has come to its strength within a small overshoot; the bonds nearest to failing are then let fail first, for when
// they give way, others may be relieved. Equal ones fail together, and where their order matters it is that of their places, not
// of their numbers. Where bonds break one after another while the loads stand still, either a new rest
// is found or the crack runs: there is no rest beyond.
//
// Limits: displacements of first order from bonding; bonds only: no walls, rigid bodies or contacts but those of broken
// bonds with themselves; what an unstable event would turn into motion is gone.
#pragma once

#include "engine/model/scene.hpp"
#include "engine/state/state.hpp"
#include "engine/step/at_rest.hpp"
#include "engine/step/failing_part.hpp"
#include "engine/step/solved_sides.hpp"
#include "engine/step/step.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace demlua::step {

class QuasiStatic {
public:
    /// Throws SceneError as solve_static does when the scene knows more than bonds or holds too little.
    QuasiStatic(state::State& state, Stepper& stepper, const model::QuasiStaticRun& said);

    /// Moves the state on to a later rest, at most to the time `until` (s); counts as a step. False, and the state stays,
    /// when there is no rest beyond: `why` then says so.
    bool advance(double until);

    [[nodiscard]] const std::string& why() const { return why_; }

private:
    /// The network at rest under the loads of one instant, as far as it has been let fail.
    struct Trial {
        double use = 0.0;  ///< of the bond nearest to failing; above 1 it should
        double left = 0.0; ///< of a bond's strength, out of balance
    };

    struct Candidate {
        FailingBonds* set;
        std::size_t bond;
    };

    struct RestKnown {
        double time = 0.0; ///< s
        std::size_t broken = 0;
    };

    Trial settle(double time);
    bool follow(double time, Trial trial);
    void add(std::vector<Candidate> bonds);
    void let_fail(double use);
    bool no_rest(double time, const std::string& what);
    void keep();
    void restore();
    void place(double time);
    [[nodiscard]] std::size_t broken() const;
    [[nodiscard]] std::size_t broken_at(double time) const;

    state::State& state_;
    Stepper& stepper_;
    RestAsked asked_;
    model::QuasiStaticRun said_;
    Held held_;
    Eigen::VectorXd per_radius_;
    std::optional<HeldSystem> system_;
    std::optional<SolvedSides> loads_;
    std::vector<std::unique_ptr<FailingBonds>> sets_;
    std::optional<FailingPart> part_;
    Eigen::VectorXd displacements_; ///< m and rad, of the last settled instant
    std::size_t kept_ = 0;          ///< bonds of part_ at the last rest
    std::vector<RestKnown> rests_;
    double at_ = 0.0;    ///< time of the last rest, s
    double use_ = 0.0;   ///< there
    double ahead_ = 0.0; ///< by how much time goes on next, s
    std::string why_;
};

} // namespace demlua::step
