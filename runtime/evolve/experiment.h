#pragma once

// What a run of evolution is a function of, together with the version: the
// paper's parameter table, the seed and the scenario. Read from YAML;
// docs/experiments.md lists every key.

#include <cstdint>
#include <string>

#include "grammar/result.h"
#include "runtime/evolve/trial_options.h"
#include "runtime/scenario/scenario_profile.h"
#include "runtime/vary/initialise.h"
#include "runtime/vary/mutate.h"

namespace plsc {

class YamlMap;

/// What children get of a parent.
enum class Inheritance : std::uint8_t {
  kGenotype,  ///< its rules as they are written
  /// Its rules as the last season of its life joined them, and never apart
  /// again: what the authors' program did unawares (decision 1).
  kJoined,
  /// kGenotype, and what the first parent sensed in its last season regulates
  /// the child in its first one: inherited regulation, the paper's future work.
  kSenses,
};

/// Defaults are the paper's (Table 2 and "Evolution").
struct Experiment {
  std::string name;
  std::uint64_t seed = 1;
  std::string robots = "robot";  ///< genotypes are called robot_1, robot_2, ...
  int population = 100;          ///< mu, at least 2
  int offspring = 100;           ///< lambda, at least 1
  int generations = 200;         ///< the initial population counted as one
  double mutation = 0.8;         ///< probability that a child is mutated
  double crossover = 0.8;  ///< probability that a child has two parents' rules
  int tournament = 2;      ///< contestants, of parents and of survivors
  Inheritance inheritance = Inheritance::kGenotype;
  MutationOptions variation;  ///< how a child is mutated
  GenotypeOptions genotype;
  TrialOptions trials;  ///< how often, and how disturbed, a robot lives
  Scenario scenario = PaperScenario();
  /// Where the scenario is when it has a file of its own, as written in the
  /// experiment; empty otherwise. Whoever read the experiment reads that file
  /// too, with the profile of `scenario` if it names none, puts it there and
  /// calls CheckSenses.
  std::string scenario_file;

  friend bool operator==(const Experiment&, const Experiment&) = default;
};

/// Whether a run of the one is a run of the other: equal, wherever the scenario
/// was read from.
bool AreSame(const Experiment& one, const Experiment& other);

/// Whether seasons are worth something else than the paper's.
bool HasOwnFitness(const Experiment& experiment);

/// Robots that a whole run evaluates.
inline std::int64_t Evaluations(const Experiment& experiment) {
  return experiment.population +
         std::int64_t{experiment.generations - 1} * experiment.offspring;
}

/// As many errors as can be found, those of an inline scenario included.
Result<Experiment> ParseExperiment(const Source& yaml);

/// Every value written out, the scenario inline; ParseExperiment returns an
/// equal one (but for scenario_file, which is empty then).
std::string PrintExperiment(const Experiment& experiment);

/// For experiments inside another file: reads and closes the map; what is
/// wrong is reported in its file, and replaced by a default.
Experiment ReadExperiment(YamlMap& map);

/// The keys but plsc_experiment, name and seed, every line indented by
/// `indent` blanks.
std::string PrintExperimentKeys(const Experiment& experiment, int indent);

/// Errors where a season has no value, or none of the right type, for a state
/// that the experiment's clauses ask about. Without places in a text.
std::vector<Diagnostic> CheckSenses(const Experiment& experiment);

}  // namespace plsc
