#pragma once

// When, in steps, things happen in a simulated life. Whole numbers, each from
// its own ordinal, so that nothing drifts: what is due at k intervals happens
// at the step nearest to it, however many went before.

#include <cstdint>
#include <vector>

#include "sim/options.h"

namespace plsc {

/// The number of the step that starts nearest to `time`; halves go up.
std::int64_t NearestStep(double time, double step);

/// Before which steps samples are taken: 0, each sample_interval, and the end
/// of life, which is last. At most one a step.
std::vector<std::int64_t> SampleSteps(const SimulationOptions& options);

}  // namespace plsc
