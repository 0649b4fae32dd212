#pragma once

// One robot of a run: its genotype, where it came from and, once evaluated, how
// it did. Populations are vectors of these.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/genotype.h"
#include "runtime/evolve/consolidate.h"
#include "runtime/life/disturbances.h"
#include "runtime/life/season_result.h"
#include "runtime/vary/mutate.h"

namespace plsc {

/// How a genotype came about; all empty in the initial population.
struct Heritage {
  std::vector<int> parents;  ///< ids; the first gives what is not crossed
  /// Heads of the rules that came of the second parent; empty if there was no
  /// crossover, or nothing was taken.
  std::vector<SymbolId> from_second;
  std::optional<Mutation> mutation;
  /// What the robot is regulated by in its first season, instead of its own
  /// senses: state to value. Empty unless the experiment inherits senses.
  std::map<std::string, std::string> senses;
};

struct Individual {
  int id = 0;          ///< from 1, in order of birth
  int generation = 0;  ///< of birth, 0 the initial population
  Heritage heritage;
  Genotype genotype;  ///< its name ends in its id
  /// What happens to it in its life that does not happen to all.
  Disturbances disturbances;
  Evaluation evaluation;
};

inline SeasonFitnesses FitnessesOf(const Individual& individual) {
  SeasonFitnesses fitnesses;
  for (const SeasonResult& season : individual.evaluation.seasons)
    fitnesses.push_back(season.fitness);
  return fitnesses;
}

}  // namespace plsc
