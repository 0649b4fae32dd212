#pragma once

// The trials of a robot: its life lived several times, each time disturbed
// otherwise, and one evaluation made of them.

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/evolve/individual.h"
#include "runtime/evolve/trial_options.h"
#include "runtime/life/life_plan.h"

namespace plsc {

/// What a run's robots live.
struct TrialPlan {
  std::uint64_t seed = 0;  ///< of the run
  TrialOptions options;
};

/// How each trial of the individual is disturbed; by default as
/// Individual::disturbances say, once.
std::vector<Disturbances> TrialsOf(const TrialPlan& plan,
                                   const LifePlanner& planner,
                                   const Individual& one);

/// The fitness of a season over its trials, by TrialOptions::quantile; nothing
/// if one of them has none. `fitnesses` is not empty.
std::optional<double> FitnessOver(
    const std::vector<std::optional<double>>& fitnesses,
    std::optional<double> quantile);

/// One evaluation of `trials`, of which there is one at least; `disturbances`
/// are TrialsOf. Fitness, outcome and reason of a season are over all trials
/// (the outcome that of the first trial that was not completed), all else is
/// the first trial's.
EvaluatedLife OverTrials(std::vector<EvaluatedLife> trials,
                         const std::vector<Disturbances>& disturbances,
                         const TrialOptions& options);

}  // namespace plsc
