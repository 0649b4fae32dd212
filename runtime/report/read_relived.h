#pragma once

// What a run's relived lives say of the generation that a report compares, or
// why there are none.

#include <cstdint>
#include <string>

#include "grammar/enum_names.h"
#include "runtime/report/relived.h"

namespace plsc {

enum class RelivedState : std::uint8_t {
  kMissing,   ///< no lives were lived again
  kOlder,     ///< those of another generation were: the run has gone on since
  kUnusable,  ///< damaged, or of another run
  kHere,
};
inline constexpr EnumNames<RelivedState, 4> kRelivedStateNames{
    {{RelivedState::kMissing, "missing"},
     {RelivedState::kOlder, "older"},
     {RelivedState::kUnusable, "unusable"},
     {RelivedState::kHere, "here"}}};

struct RelivedReading {
  RelivedState state = RelivedState::kMissing;
  std::string problem;           ///< kUnusable only: ready for the user
  RelivedGeneration generation;  ///< kHere only
};

/// `generation`: of those that the run has completed.
RelivedReading ReadRelived(const std::string& run, int generation);

}  // namespace plsc
