#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "compiler/print.h"
#include "grammar/shown_line.h"
#include "runtime/cli/arguments/runs.h"
#include "runtime/cli/commands/robot_text.h"
#include "runtime/cli/commands/trials_text.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/evolve/trials_yaml.h"
#include "runtime/life/season_json.h"
#include "runtime/scenario/scenario_fitness.h"
#include "runtime/store/census_json.h"
#include "runtime/store/heritage_json.h"
#include "runtime/store/lock.h"
#include "runtime/store/trials_json.h"
#include "runtime/store/verify.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

/// "child of 12 and 7 (B, T of 7), rule 3 changed by add".
std::string Origin(const Heritage& heritage, const Alphabet& alphabet) {
  if (heritage.parents.empty()) return "drawn at random";
  std::string text = fmt::format("child of {} and {}", heritage.parents[0],
                                 heritage.parents[1]);
  if (!heritage.from_second.empty()) {
    std::vector<std::string> heads;
    for (const SymbolId head : heritage.from_second)
      heads.push_back(alphabet[head].name);
    text +=
        fmt::format(" ({} of {})", fmt::join(heads, ", "), heritage.parents[1]);
  }
  if (heritage.mutation)
    text += fmt::format(", {} of rule {}",
                        NameIn(kMutationNames, heritage.mutation->kind),
                        RuleNumber(*heritage.mutation));
  return text;
}

std::string LineageText(const std::vector<Ancestor>& lineage,
                        const Alphabet& alphabet, bool has_own_fitness) {
  std::string text;
  for (const Ancestor& ancestor : lineage)
    text +=
        fmt::format("  {:>2} back  {:>6} of generation {:<4} {:<24} {}\n",
                    ancestor.distance, ancestor.id, ancestor.generation,
                    ancestor.fitnesses.empty()
                        ? "not evaluated yet"
                        : FitnessesText(ancestor.fitnesses, has_own_fitness),
                    Origin(ancestor.heritage, alphabet));
  return text;
}

Json FitnessesJson(const SeasonFitnesses& fitnesses) {
  Json json = Json::array();
  for (const std::optional<double>& fitness : fitnesses)
    json.push_back(fitness ? Json(*fitness) : Json(nullptr));
  return json;
}

using Trials = std::vector<std::vector<StoredTrial>>;

Json IndividualJson(const Individual& one, const Trials& trials,
                    const std::vector<Ancestor>& lineage) {
  const auto heritage_of = [&](const Heritage& heritage) {
    return HeritageJson(heritage, *one.genotype.alphabet, one.genotype.states);
  };
  Json json;
  json["id"] = one.id;
  json["generation"] = one.generation;
  json.update(heritage_of(one.heritage));
  json["genotype"] = Print(one.genotype);
  json["seasons"] = Json::array();
  for (const SeasonResult& season : one.evaluation.seasons)
    json["seasons"].push_back(Json::parse(SeasonJson(one.genotype, season)));
  if (!trials.empty()) json["trials"] = TrialsJson(trials);
  json["lineage"] = Json::array();
  for (const Ancestor& ancestor : lineage) {
    Json of;
    of["distance"] = ancestor.distance;
    of["id"] = ancestor.id;
    of["generation"] = ancestor.generation;
    of.update(heritage_of(ancestor.heritage));
    of["fitness"] = FitnessesJson(ancestor.fitnesses);
    json["lineage"].push_back(std::move(of));
  }
  return json;
}

Exit ShowIndividual(const ShowCommand& command, RunStore& store, Io& io) {
  const Expected<int, Failure> id = IdOf(store, command.individual);
  if (!id) return Complain(id.error(), io);
  const Expected<Individual, Failure> one = store.Find(*id);
  if (!one) return Complain(one.error(), io);
  if (command.genotype) {
    io.out << Print(one->genotype);
    return Exit::kFine;
  }
  const Expected<std::vector<Ancestor>, Failure> lineage =
      store.Lineage(*id, command.lineage);
  if (!lineage) return Complain(lineage.error(), io);
  const Expected<Trials, Failure> trials = store.TrialsOf(*id);
  if (!trials) return Complain(trials.error(), io);
  if (command.format == OutputFormat::kJson) {
    io.out << DumpJson(IndividualJson(*one, *trials, *lineage)) << '\n';
    return Exit::kFine;
  }
  const Alphabet& alphabet = *one->genotype.alphabet;
  io.out << fmt::format("{} of generation {}: {}\n\nlineage:\n{}\n{}\n{}{}",
                        one->genotype.name, one->generation,
                        Origin(one->heritage, alphabet),
                        LineageText(*lineage, alphabet,
                                    HasOwnFitness(store.experiment().scenario)),
                        Print(one->genotype), SeasonsText(*one),
                        TrialsText(store.experiment(), *trials));
  return Exit::kFine;
}

struct Standing {
  RunStatus status;
  std::string worker;  ///< who works on it; empty: nobody
  const char* state = "";
  /// Of the last completed generation.
  std::optional<CensusCounts> census;
};

void PrintRunJson(const ShowCommand& command, const RunStore& store,
                  const Standing& standing, std::ostream& out) {
  const Experiment& experiment = store.experiment();
  const RunStatus& status = standing.status;
  Json json;
  json["run"] = command.run;
  json["name"] = experiment.name;
  json["seed"] = std::to_string(experiment.seed);
  json["state"] = standing.state;
  json["generations"] = status.generations;
  json["total_generations"] = experiment.generations;
  json["evaluations"] = status.evaluations;
  json["total_evaluations"] = Evaluations(experiment);
  json["best"] = status.best == 0 ? Json(nullptr) : Json(status.best);
  json["census"] =
      standing.census ? CensusJson(*standing.census) : Json(nullptr);
  const std::string lives = DescribeTrials(experiment.trials);
  json["lives"] = lives.empty() ? Json(nullptr) : Json(lives);
  json["fitness"] = DescribeFitness(experiment.scenario);
  json["schema"] = store.schema();
  json["versions"] = {{"plsc", store.versions().plsc},
                      {"ode", store.versions().ode},
                      {"compiler", store.versions().compiler},
                      {"machine", store.versions().machine},
                      {"results", store.versions().results}};
  json["verified"] = command.verify;
  out << DumpJson(json) << '\n';
}

void PrintRunText(const RunStore& store, const Standing& standing,
                  std::ostream& out) {
  const Experiment& experiment = store.experiment();
  const RunStatus& status = standing.status;
  out << fmt::format(
      "{} (seed {}), by {}\n{}{}: {} of {} generations, {} of {} robots "
      "evaluated\n",
      experiment.name.empty() ? "run without a name" : Escaped(experiment.name),
      experiment.seed, VersionsText(store.versions()), standing.state,
      standing.worker.empty() ? "" : " by " + Escaped(standing.worker),
      status.generations, experiment.generations, status.evaluations,
      Evaluations(experiment));
  if (const std::string trials = DescribeTrials(experiment.trials);
      !trials.empty())
    out << fmt::format("lives: {}\n", trials);
  if (HasOwnFitness(experiment.scenario))
    out << fmt::format("fitness: {}\n",
                       Escaped(DescribeFitness(experiment.scenario)));
}

/// How alike the robots of the last generation are, and how plastic.
void PrintCensus(const CensusCounts& counts, const Experiment& experiment,
                 std::ostream& out) {
  out << fmt::format(
      "population: {} different genotypes and {} different robots, of {} of {} "
      "founders\n",
      counts.genotypes, counts.phenotypes, counts.founders,
      experiment.population);
  if (counts.regulated_rules == 0) return;
  const auto percent = [](std::int64_t part, std::int64_t of) {
    return 100 * static_cast<double>(part) / static_cast<double>(of);
  };
  out << fmt::format(
      "plasticity: {} with other bodies and {} with other brains only, of {} "
      "robots; {:.0f} % of rules have a clause, {:.0f} % were never active\n",
      counts.plastic_bodies, counts.plastic_brains, experiment.population,
      percent(counts.regulated_rules, counts.rules),
      percent(counts.silent_rules, counts.rules));
}

void PrintBest(const Individual& best, std::ostream& out) {
  out << fmt::format("best: {} of generation {}\n", best.id, best.generation);
  for (const SeasonResult& season : best.evaluation.seasons)
    out << "  " << SeasonLine(season) << '\n';
}

Exit ShowRun(const ShowCommand& command,
             const std::optional<std::string>& worker, RunStore& store,
             Io& io) {
  const Expected<RunStatus, Failure> status = store.Status();
  if (!status) return Complain(status.error(), io);
  Standing standing{*status,
                    worker.value_or(""),
                    status->is_finished ? "finished"
                    : worker            ? "running"
                                        : "unfinished",
                    {}};
  const Expected<std::vector<CensusCounts>, Failure> censuses =
      store.Censuses();
  if (!censuses) return Complain(censuses.error(), io);
  if (!censuses->empty()) standing.census = censuses->back();
  std::optional<Individual> best;
  if (status->best != 0) {
    Expected<Individual, Failure> found = store.Find(status->best);
    if (!found) return Complain(found.error(), io);
    best = std::move(*found);
  }
  if (command.format == OutputFormat::kJson) {
    PrintRunJson(command, store, standing, io.out);
    return Exit::kFine;
  }
  PrintRunText(store, standing, io.out);
  if (standing.census)
    PrintCensus(*standing.census, store.experiment(), io.out);
  if (best) PrintBest(*best, io.out);
  io.out << (command.verify ? "checksums: of all results, and right\n"
             : best ? "checksums: of the best robot, and right (of all: "
                      "--verify)\n"
                    : "checksums: not looked at (--verify does)\n");
  return Exit::kFine;
}

}  // namespace

Exit Run(const ShowCommand& command, Io& io) {
  // Asked first: not to be asked of a store that is open.
  const std::optional<std::string> worker = WhoWorksOn(command.run);
  RunStore store;
  if (const auto failure = store.OpenForReading(command.run))
    return Complain(*failure, io);
  if (command.verify)
    if (const auto problem = Examine(command.run).problem)
      return Complain(*problem, io);
  return command.individual.empty() ? ShowRun(command, worker, store, io)
                                    : ShowIndividual(command, store, io);
}

}  // namespace plsc::cli
