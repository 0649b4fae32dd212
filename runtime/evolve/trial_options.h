#pragma once

// How often each robot lives its seasons, what disturbs these lives at random,
// and what its fitness is over them. Read from YAML by
// runtime/evolve/trials_yaml, which has the ranges.

#include <optional>

namespace plsc {

/// The most of each disturbance; 0: there is none of it. All are drawn evenly
/// (runtime/evolve/trials).
struct LifeNoise {
  double start_height = 0;  ///< m: a start is higher by 0 to this
  double place = 0;         ///< m: off along x, and along y, to either side
  double yaw = 0;           ///< rad: turned to either side
  double inclination = 0;   ///< rad: what the IMU tells, more or less by this
  double touch = 0;     ///< probability that a touch sensor tells the contrary
  double motor = 0;     ///< rad: a servo's target, to either side
  double friction = 0;  ///< share of it, more or less; below 1

  friend bool operator==(const LifeNoise&, const LifeNoise&) = default;
};

struct TrialOptions {
  int count = 1;  ///< lives of a robot, at least 1
  LifeNoise noise;
  /// Of the fitnesses of a season's trials, 0 to 1: which quantile is the
  /// season's fitness; nothing: their mean.
  std::optional<double> quantile;
  /// Every individual lives its own lives, and none is looked up.
  bool own_lives = false;

  friend bool operator==(const TrialOptions&, const TrialOptions&) = default;
};

/// Whether lives are more than one a robot, or differ between equal robots'
/// trials: then each is told of by itself (SeasonEvidence::trials).
inline bool HasTrials(const TrialOptions& options) {
  return options.count > 1 || options.noise != LifeNoise{};
}

}  // namespace plsc
