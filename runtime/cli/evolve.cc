#include <fmt/format.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "compiler/print.h"
#include "runtime/cli/commands.h"
#include "runtime/cli/interrupt.h"
#include "runtime/cli/load_yaml.h"
#include "runtime/cli/progress.h"
#include "runtime/develop.h"
#include "runtime/evolve/evolve.h"
#include "runtime/evolve/run_log.h"
#include "runtime/formats/body_text.h"
#include "runtime/season_teller.h"

namespace plsc::cli {

namespace {

double ChildrenCpuSeconds() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) +
           1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Workers are children that have ended when the run returns, so their CPU
// time over what they could have had is how busy they were.
struct Effort {
  double seconds = 0;
  double busy_share = 0;
  int workers = 0;
};

void PrintSeason(const SeasonResult& result, std::ostream& out) {
  constexpr double kCentimetres = 100;
  out << fmt::format("season {}: ", result.season);
  if (!result.behaviour.is_valid) {
    out << OutcomeName(result.outcome) << ": " << result.reason << '\n';
    return;
  }
  out << fmt::format("speed {:.3f} cm/s, balance {:.4f}, {} modules\n",
                     kCentimetres * result.behaviour.displacement_velocity_hill,
                     result.behaviour.head_balance, result.body.absolute_size);
}

void PrintBest(const Individual& best, const Scenario& scenario,
               std::ostream& out) {
  out << fmt::format("best robot: {} of generation {}\n\n{}\n",
                     best.genotype.name, best.generation, Print(best.genotype));
  for (std::size_t i = 0; i < scenario.seasons.size(); ++i) {
    PrintSeason(best.evaluation.seasons[i], out);
    const SeasonResult& season = best.evaluation.seasons[i];
    // Nothing was sensed where a life did not reach.
    if (season.sensed.size() != best.genotype.states.size()) continue;
    if (const auto phenotype = Develop(
            best.genotype, EnvironmentOf(season.sensed, best.genotype.states)))
      out << BodyText(phenotype->body);
    out << '\n';
  }
}

void PrintJson(const EvolveCommand& command, const Experiment& experiment,
               const RunResult& result, const Effort& effort,
               std::ostream& out) {
  nlohmann::ordered_json json;
  json["experiment"] = experiment.name;
  json["seed"] = experiment.seed;
  json["finished"] = result.ending == Ending::kFinished;
  json["generations"] = result.generations;
  json["evaluations"] = result.evaluations;
  json["folder"] = command.output;
  json["seconds"] = effort.seconds;
  json["workers"] = effort.workers;
  json["busy_share"] = effort.busy_share;
  if (result.best) {
    json["best"]["id"] = result.best->id;
    json["best"]["genotype"] = Print(result.best->genotype);
    for (const SeasonResult& season : result.best->evaluation.seasons)
      json["best"]["fitness"][season.season] =
          season.fitness ? nlohmann::ordered_json(*season.fitness)
                         : nlohmann::ordered_json(nullptr);
  }
  out << json.dump() << '\n';
}

void PrintEffort(const RunResult& result, const Effort& effort, Io& io) {
  io.err << fmt::format(
      "{} evaluations in {} ({:.1f}/s), {} workers {:.0f} % busy\n",
      result.evaluations, DurationText(effort.seconds),
      static_cast<double>(result.evaluations) / effort.seconds, effort.workers,
      100 * effort.busy_share);
}

Exit ExitOf(const RunResult& result, const std::string& folder, Io& io) {
  switch (result.ending) {
    case Ending::kFinished:
      return Exit::kFine;
    case Ending::kStopped:
      io.err << fmt::format(
          "stopped after {} generations; what was done is in {}\n",
          result.generations, folder);
      return Exit::kInterrupted;
    case Ending::kFailed:
      io.err << fmt::format("error: {}\n", result.failure);
      return Exit::kBadInput;
  }
  return Exit::kBadInput;
}

RunResult RunExperiment(const EvolveCommand& command,
                        const Experiment& experiment, RunLog& log,
                        Effort& effort, Io& io) {
  ProgressLine line(io.err, io.err_is_terminal, experiment.generations);
  EvolveOptions options;
  options.jobs = command.jobs.value_or(0);
  const InterruptHandler handler;
  options.should_stop = [] { return InterruptHandler::is_interrupted(); };
  options.on_progress = [&](const Progress& progress) {
    effort.workers = progress.workers;
    if (!command.quiet) line.Show(progress);
  };
  options.observers = {&log};
  const double cpu_before = ChildrenCpuSeconds();
  RunResult result = Evolve(experiment, options);
  line.Finish();
  effort.seconds = line.seconds();
  effort.busy_share = (ChildrenCpuSeconds() - cpu_before) /
                      (effort.seconds * std::max(effort.workers, 1));
  return result;
}

}  // namespace

Exit Run(const EvolveCommand& command, Io& io) {
  auto experiment = LoadExperiment(command.experiment, io);
  if (!experiment) return Exit::kBadInput;
  if (command.seed) experiment->seed = *command.seed;

  RunLog log;
  if (const auto failure = log.Create(command.output, *experiment)) {
    io.err << fmt::format("error: {}\n", *failure);
    return Exit::kBadInput;
  }
  Effort effort;
  RunResult result = RunExperiment(command, *experiment, log, effort, io);
  if (const auto failure = log.Finish(result);
      failure && result.ending != Ending::kFailed) {
    result.ending = Ending::kFailed;
    result.failure = *failure;
  }
  if (!command.quiet) PrintEffort(result, effort, io);
  if (command.format == OutputFormat::kJson)
    PrintJson(command, *experiment, result, effort, io.out);
  else if (result.best)
    PrintBest(*result.best, experiment->scenario, io.out);
  return ExitOf(result, command.output, io);
}

}  // namespace plsc::cli
