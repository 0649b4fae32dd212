#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "compiler/print.h"
#include "runtime/cli/arguments/runs.h"
#include "runtime/cli/commands/robot_text.h"
#include "runtime/cli/files/load_yaml.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/running/progress.h"
#include "runtime/cli/running/run_experiment.h"
#include "runtime/evolve/worker_request.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

void PrintJson(const EvolveCommand& command, const RunOutcome& outcome,
               std::ostream& out) {
  const auto& [exit, is_locked, experiment, result, effort] = outcome;
  nlohmann::ordered_json json;
  json["experiment"] = experiment.name;
  json["seed"] = std::to_string(experiment.seed);
  json["finished"] = result.ending == Ending::kFinished;
  json["generations"] = result.generations;
  json["evaluations"] = result.evaluations;
  json["run"] = command.resume.empty() ? command.output : command.resume;
  json["seconds"] = effort.seconds;
  json["cpu_seconds"] = effort.cpu_seconds;
  json["workers"] = effort.workers;
  json["busy_share"] = effort.busy_share
                           ? nlohmann::ordered_json(*effort.busy_share)
                           : nlohmann::ordered_json(nullptr);
  json["simulations"] = effort.counts.simulations;
  json["looked_up"] = effort.counts.looked_up;
  json["simulated_seconds"] = effort.counts.simulated_seconds;
  if (result.best) {
    json["best"]["id"] = result.best->id;
    json["best"]["genotype"] = Print(result.best->genotype);
    for (const SeasonResult& season : result.best->evaluation.seasons)
      json["best"]["fitness"][season.season] =
          season.fitness ? nlohmann::ordered_json(*season.fitness)
                         : nlohmann::ordered_json(nullptr);
  }
  out << DumpJson(json) << '\n';
}

void PrintEffort(const Effort& effort, Io& io) {
  const EvaluationCounts& counts = effort.counts;
  const auto seasons = counts.simulations + counts.looked_up;
  io.err << fmt::format(
      "{} evaluations in {} ({:.1f}/s), {:.0f} x real time, {:.0f} % of "
      "seasons known already, {} workers{}\n",
      effort.evaluations, DurationText(effort.seconds),
      static_cast<double>(effort.evaluations) / effort.seconds,
      counts.simulated_seconds / effort.seconds,
      seasons == 0 ? 0.0
                   : 100.0 * static_cast<double>(counts.looked_up) /
                         static_cast<double>(seasons),
      effort.workers,
      effort.busy_share
          ? fmt::format(" {:.0f} % busy", 100 * *effort.busy_share)
          : "");
}

/// What is asked for; nothing if the experiment is wrong, which was printed.
std::optional<RunRequest> RequestOf(const EvolveCommand& command, Io& io) {
  RunRequest request;
  if (!command.salvage.empty() && command.experiment.empty()) {
    request.path = command.output;
  } else if (command.resume.empty()) {
    request.experiment = LoadExperiment(command.experiment, io);
    if (!request.experiment ||
        !UseEngine(command.engine, request.experiment->scenario, io))
      return std::nullopt;
    if (command.seed) request.experiment->seed = *command.seed;
    request.path = command.output;
    request.may_resume = command.or_resume;
  } else {
    request.path = command.resume;
  }
  request.salvage = command.salvage;
  request.allow_other_version = command.allow_other_version;
  request.jobs = command.jobs;
  request.hang_seconds = command.hang_limit;
  request.cache = command.cache;
  request.json_log = command.json_log;
  request.quiet = command.quiet;
  return request;
}

/// Where and what to run, given on the command line in one of two ways.
std::optional<std::string> WrongUsage(const EvolveCommand& command) {
  const bool is_new = !command.experiment.empty() || !command.output.empty() ||
                      !command.salvage.empty();
  if (!command.resume.empty() && (is_new || command.seed || command.engine))
    return "--resume RUN goes on with what the run is of; it takes neither an "
           "experiment nor --output nor --seed nor --engine";
  if (!command.resume.empty()) return std::nullopt;
  if (!command.salvage.empty() &&
      (command.or_resume || command.seed || command.engine))
    return "--salvage RUN makes that run again; it takes neither --or-resume "
           "nor --seed nor --engine";
  if (command.experiment.empty() && command.salvage.empty())
    return "expected EXPERIMENT, a YAML file, or --resume RUN";
  if (command.output.empty()) return "expected --output RUN, a file to make";
  return std::nullopt;
}

}  // namespace

Exit Run(const EvolveCommand& command, Io& io) {
  if (const auto wrong = WrongUsage(command)) {
    io.err << fmt::format("plsc evolve: {}\nsee 'plsc evolve --help'\n",
                          *wrong);
    return Exit::kBadUsage;
  }
  MpiSession session;
  if (MpiSession::IsUnderMpi()) {
    if (const auto failure = session.Join(command.jobs.value_or(1), WorkFor))
      return Complain(*failure, io);
    if (session.rank() != 0) return session.Serve(), Exit::kFine;
  }
  std::optional<RunRequest> request = RequestOf(command, io);
  if (!request) return Exit::kBadInput;
  if (MpiSession::IsUnderMpi()) request->mpi = &session;
  if (request->experiment && !command.quiet && !command.engine)
    MentionSwift(request->experiment->scenario, io);
  const RunOutcome outcome = ExecuteRun(*request, io);
  if (outcome.exit == Exit::kBadInput && outcome.result.generations == 0)
    return outcome.exit;
  if (!command.quiet) PrintEffort(outcome.effort, io);
  if (command.format == OutputFormat::kJson) {
    PrintJson(command, outcome, io.out);
  } else if (outcome.result.best) {
    const Individual& best = *outcome.result.best;
    io.out << fmt::format("best robot: {} of generation {}\n\n{}\n{}",
                          best.genotype.name, best.generation,
                          Print(best.genotype), SeasonsText(best));
  }
  return outcome.exit;
}

}  // namespace plsc::cli
