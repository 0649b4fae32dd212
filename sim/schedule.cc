#include "sim/schedule.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plsc {

std::int64_t NearestStep(double time, double step) {
  assert(step > 0 && time >= 0);
  return std::llround(time / step);
}

std::vector<std::int64_t> SampleSteps(const SimulationOptions& options) {
  const double step = options.physics.step;
  const std::int64_t end = NearestStep(options.duration, step);
  const double interval = std::max(options.sample_interval, step);
  std::vector<std::int64_t> steps;
  for (std::int64_t ordinal = 0;; ++ordinal) {
    const std::int64_t due =
        NearestStep(static_cast<double>(ordinal) * interval, step);
    if (due >= end) break;
    steps.push_back(due);
  }
  steps.push_back(end);
  return steps;
}

}  // namespace plsc
