#pragma once

// How a simulated life ended. Data, stored with every result: a world that
// goes wrong is never an abort and never a silent zero.

#include <cstdint>
#include <string_view>

namespace plsc {

enum class Outcome : std::uint8_t {
  kCompleted,    ///< lived the whole season
  kOverlapping,  ///< modules intersect in the rest pose; not simulated
  kUndeveloped,  ///< development passed its limits: there is no robot
  kUnstable,     ///< a state was not finite or moved faster than a servo can
  kWorkerDied,   ///< the process that simulated it died, twice
};

/// "completed", "overlapping", "undeveloped", "unstable", "worker_died": as
/// results and JSON name it.
std::string_view OutcomeName(Outcome outcome);

}  // namespace plsc
