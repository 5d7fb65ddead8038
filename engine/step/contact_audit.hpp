// The energy ledger of each contact by itself: whatever a contact does, it never gives more than it has taken.
//
//   given = - sum over steps of [ mean(N) closing + mean(ft) sliding + mean(M) rolling ] dt,   mean: of both ends of a step
//
// is what the contact has done on its two elements, as central difference exchanges it. Spring energy is never below zero and
// friction and dashpots only take, so `given` stays at or below what the contact began with: nothing, or what a broken bond
// left in it. Central difference allows it a little more:
//
//   Kn (closing dt)^2/8          where it lets go: the last overlap d ends within a step that is longer than d by s - d, over
//                                which the mean force Kn d/2 still acts; d (s - d) <= s^2/4, s = closing dt
//   Kt (sliding dt)^2/8          where it slips back, or lets go, faster than its spring: likewise
//   D closing dt/2, D sliding dt/2   there too: what the dashpots D of the instant before give when the motion has turned
//                                since, and those of this instant, cut off, do not take
//   N (v.t dt)^2/(2 |d|)         in a step: the displacement is taken along the normal at its end, which has turned
//
// Not part of a step in a release build.
#pragma once

#include "engine/state/state.hpp"

#include <cstdint>
#include <unordered_map>

namespace demlua::step {

class ContactAudit {
public:
    /// Books the step that led to the present instant, whose forces stand in the contacts. To be called after every step.
    /// Throws RunError naming a contact that has given too much.
    void book(const state::State& state);

    struct Account {
        double given = 0.0;                               ///< J
        double allowed = 0.0;                             ///< J
        double exchanged = 0.0;                           ///< to and fro, J
        double pressure = 0.0, shear = 0.0, couple = 0.0; ///< at the last instant, N, N, N m
        double dashpot = 0.0, shear_dashpot = 0.0;        ///< their part in these, N
    };
    /// Of the pairs listed at the last instant, by i * elements + j.
    [[nodiscard]] const std::unordered_map<std::uint64_t, Account>& accounts() const { return accounts_; }

private:
    std::unordered_map<std::uint64_t, Account> accounts_;
};

/// Whether this build audits every contact of every run.
#ifdef NDEBUG
inline constexpr bool audits_contacts = false;
#else
inline constexpr bool audits_contacts = true;
#endif

} // namespace demlua::step
