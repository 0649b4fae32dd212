// Steps are counted in whole numbers, and each event's step is computed from
// its ordinal: round(k * interval / step). Were intervals added up instead,
// rounding errors would add up with them until a step is gained or lost. kLate
// is the clock of the authors' program, which waits until more than an interval
// has passed and starts counting anew (RobotController.cpp:243); at a step of 5
// ms its eight updates a second come every 130 ms.

#include "sim/schedule.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plsc {

namespace {

// Beyond any life: what is due then never is. A number of steps that does not
// fit the integer would round to anything, a negative one too.
constexpr std::int64_t kNever = std::int64_t{1} << 62;

std::int64_t Whole(double steps) {
  if (!(steps < static_cast<double>(kNever))) return kNever;
  return static_cast<std::int64_t>(steps);
}

}  // namespace

std::int64_t NearestStep(double time, double step) {
  assert(step > 0 && time >= 0);
  return Whole(std::round(time / step));
}

std::optional<double> RefreshSchedule::Due(std::int64_t step) {
  const double period = 1 / servo_.update_rate;
  if (servo_.refresh == Refresh::kLate) {
    // The first step strictly later; the nudge takes 25.000000000000004 steps
    // for the 25 they are.
    constexpr double kNudge = 1e-9;
    const std::int64_t wait = Whole(std::floor(period / step_ + kNudge)) + 1;
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
