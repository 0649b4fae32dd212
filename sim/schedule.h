#pragma once

// When, in steps, things happen in a simulated life. Whole numbers, each from
// its own ordinal, so that nothing drifts: what is due at k intervals happens
// at the step nearest to it, however many went before.

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/options.h"

namespace plsc {

/// The number of the step that starts nearest to `time`; halves go up. Beyond
/// 2^62 steps, which no life takes, it is 2^62.
std::int64_t NearestStep(double time, double step);

/// When joints get new targets.
class RefreshSchedule {
 public:
  RefreshSchedule(const ServoOptions& servo, double step)
      : servo_(servo), step_(step) {}

  /// Asked once before each step, in order: the time of the update that is due
  /// before it, s since the first step; nothing if none is.
  std::optional<double> Due(std::int64_t step);

 private:
  ServoOptions servo_;
  double step_;
  std::int64_t updates_ = 0;  ///< kExact only
  std::int64_t latest_ = 0;   ///< kLate only, a step
};

/// Steps that a life takes; limits are counted in them.
std::int64_t StepsOf(const SimulationOptions& options);

/// Before which steps samples are taken: 0, each sample_interval, and the end
/// of life, which is last. At most one a step.
std::vector<std::int64_t> SampleSteps(const SimulationOptions& options);

}  // namespace plsc
