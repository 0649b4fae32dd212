#include "sim/schedule.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plsc {

std::int64_t NearestStep(double time, double step) {
  assert(step > 0 && time >= 0);
  return std::llround(time / step);
}

std::optional<double> RefreshSchedule::Due(std::int64_t step) {
  const double period = 1 / servo_.update_rate;
  if (servo_.refresh == Refresh::kLate) {
    // The first step strictly later; the nudge takes 25.000000000000004 steps
    // for the 25 they are.
    constexpr double kNudge = 1e-9;
    const auto wait =
        static_cast<std::int64_t>(std::floor(period / step_ + kNudge)) + 1;
    if (step - latest_ < wait) return std::nullopt;
    latest_ = step;
    return static_cast<double>(step) * step_;
  }
  const auto due = [&] {
    return static_cast<double>(updates_) / servo_.update_rate;
  };
  if (step < NearestStep(due(), step_)) return std::nullopt;
  const double time = due();
  // More than once only if the pace is quicker than the steps.
  do {
    ++updates_;
  } while (NearestStep(due(), step_) <= step);
  return time;
}

std::int64_t StepsOf(const SimulationOptions& options) {
  return NearestStep(options.duration, options.physics.step);
}

std::vector<std::int64_t> SampleSteps(const SimulationOptions& options) {
  const double step = options.physics.step;
  const std::int64_t end = StepsOf(options);
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
