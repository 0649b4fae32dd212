#pragma once

// The judgement of one genotype: all seasons of a scenario, each with the
// robot that developed for it, what it did and its fitness.

#include <optional>
#include <string>
#include <vector>

#include "runtime/descriptors.h"
#include "runtime/scenario.h"
#include "sim/measures.h"
#include "sim/outcome.h"
#include "sim/trajectory.h"

namespace plsc {

struct SeasonResult {
  std::string season;
  Outcome outcome = Outcome::kCompleted;
  BodyDescriptors body;
  BrainDescriptors brain;
  Behaviour behaviour;
  /// m/s (Eq. 2 of the paper); nothing when the life was not completed, which
  /// is worse than any number.
  std::optional<double> fitness;
  std::uint64_t state_hash = 0;  ///< of the final physical state
};

struct Evaluation {
  std::vector<SeasonResult> seasons;  ///< in the scenario's order
};

/// Eq. 2: s if s > 0, s/10 if s < 0; -0.1 if s = 0 or the robot has no joint
/// at all (authors' program, fitness.py:65). `speed` in m/s.
double SeasonFitness(double speed, int hinge_count);

/// Develops for each season's environment and simulates it. The states of the
/// genotype are sensed in every season (checked before with Sense).
Evaluation Evaluate(const Genotype& genotype, const Scenario& scenario);

/// One season of it, with the whole trajectory.
struct SeasonLife {
  SeasonResult result;
  Trajectory trajectory;
};
SeasonLife LiveSeason(const Genotype& genotype, const Scenario& scenario,
                      const Season& season);

}  // namespace plsc
