#pragma once

// How a simulated life ended. Data, stored with every result: a world that
// goes wrong is never an abort and never a silent zero.

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace plsc {

enum class Outcome : std::uint8_t {
  kCompleted,     ///< lived the whole season
  kOverlapping,   ///< modules intersect in the rest pose; not simulated
  kUndeveloped,   ///< development passed its limits: there is no robot
  kUnstable,      ///< a state was not finite or moved faster than a servo can
  kWorkerDied,    ///< the process that simulated it died, twice
  kFellThrough,   ///< a link was far below the ground
  kSolverFailed,  ///< the solver failed more often than it may
  kOutOfSteps,    ///< asks for more steps than it may have, or for none
  kTooLarge,      ///< has more links than it may have; not simulated
  kNotReached,    ///< the one life ended in a season before
  kStopped,       ///< by the user, in mid-life
  /// Lived the whole season, of which what it is worth is no number.
  kUndefinedFitness,
};

/// As results and JSON name it.
inline constexpr std::array<std::pair<Outcome, std::string_view>, 12>
    kOutcomeNames{{{Outcome::kCompleted, "completed"},
                   {Outcome::kOverlapping, "overlapping"},
                   {Outcome::kUndeveloped, "undeveloped"},
                   {Outcome::kUnstable, "unstable"},
                   {Outcome::kWorkerDied, "worker_died"},
                   {Outcome::kFellThrough, "fell_through"},
                   {Outcome::kSolverFailed, "solver_failed"},
                   {Outcome::kOutOfSteps, "out_of_steps"},
                   {Outcome::kTooLarge, "too_large"},
                   {Outcome::kNotReached, "not_reached"},
                   {Outcome::kStopped, "stopped"},
                   {Outcome::kUndefinedFitness, "undefined_fitness"}}};
std::string_view OutcomeName(Outcome outcome);

}  // namespace plsc
