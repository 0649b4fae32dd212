#pragma once

// How a simulated life ended. Data, stored with every result: a world that
// goes wrong is never an abort and never a silent zero.

#include <cstdint>
#include <string_view>

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
};

/// "completed", "overlapping", "undeveloped", "unstable", "worker_died",
/// "fell_through", "solver_failed", "out_of_steps", "too_large",
/// "not_reached", "stopped": as results and JSON name it.
std::string_view OutcomeName(Outcome outcome);

}  // namespace plsc
