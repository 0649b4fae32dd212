#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "grammar/shown_line.h"
#include "runtime/cli/arguments/study.h"
#include "runtime/cli/files/load_yaml.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/running/interrupt.h"
#include "runtime/cli/running/run_experiment.h"
#include "runtime/cli/running/utc_now.h"
#include "runtime/scenario/scenario_physics.h"
#include "runtime/store/shared_cache.h"
#include "runtime/study/claims_record.h"
#include "runtime/study/run_study.h"
#include "runtime/study/slice.h"
#include "runtime/study/study_folder.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

/// With the engine that was asked for; what is wrong is printed.
std::optional<Study> LoadForRunning(const StudyRunCommand& command, Io& io) {
  std::optional<Study> study = LoadStudy(command.study, io);
  if (!study) return std::nullopt;
  for (StudyExperiment& one : study->experiments)
    if (!UseEngine(command.engine, one.experiment.scenario, io))
      return std::nullopt;
  return study;
}

/// Once for all of the study.
void MentionSwift(const StudyRunCommand& command, const Study& study, Io& io) {
  if (command.quiet || command.engine) return;
  const auto with_ode =
      std::find_if(study.experiments.begin(), study.experiments.end(),
                   [](const StudyExperiment& one) {
                     return UsesOde(one.experiment.scenario);
                   });
  if (with_ode != study.experiments.end())
    MentionSwift(with_ode->experiment.scenario, io);
}

/// The runs that `--only` and `--shard` choose; what is wrong is printed.
std::optional<std::vector<StudyRun>> ChosenRuns(const Study& study,
                                                const std::string& only,
                                                const std::string& shard,
                                                Io& io) {
  if (const auto problem = CheckOnly(study, only)) {
    Complain(*problem, io);
    return std::nullopt;
  }
  return RunsIn(study, only, ParseShard(shard).value_or(Shard{}));
}

std::string Plural(std::size_t count) {
  return fmt::format("{} run{}", count, count == 1 ? "" : "s");
}

RunEnd EndOf(const RunOutcome& outcome) {
  if (outcome.is_locked) return RunEnd::kInUse;
  switch (outcome.exit) {
    case Exit::kFine:
      return RunEnd::kFinished;
    case Exit::kInterrupted:
      return RunEnd::kStopped;
    default:
      return RunEnd::kFailed;
  }
}

RunEnd Execute(const RunTask& task, const StudyRunCommand& command, Io& io) {
  RunRequest request;
  request.path = task.path;
  request.experiment = task.experiment;
  // Also of a run that seemed missing: another process may have begun and left
  // it meanwhile.
  request.may_resume = true;
  request.allow_other_version = command.allow_other_version;
  request.jobs = command.jobs;
  request.cache = command.cache;
  request.quiet = command.quiet;
  return EndOf(ExecuteRun(request, io));
}

/// The cache first: where it cannot be opened, no folder is made.
MaybeFailure Prepare(const StudyRunCommand& command, const Study& study) {
  SharedCache cache;
  if (!command.cache.empty())
    if (auto failure = cache.Open(command.cache)) return failure;
  auto failure = PrepareFolder(command.output, study);
  if (!failure) failure = StateClaims(command.output, study, UtcNow());
  if (failure) cache.Discard();
  return failure;
}

std::string StepText(StudyStep step, const RunReport& report) {
  switch (step) {
    case StudyStep::kBegins:
      return "begins";
    case StudyStep::kResumes:
      return fmt::format("goes on after {} generations", report.generations);
    case StudyStep::kFinished:
      return fmt::format("done, {} evaluations", report.evaluations);
    case StudyStep::kDoneBefore:
      return "is done";
    case StudyStep::kInUse:
      return fmt::format("left: {} works on it", report.worker.empty()
                                                     ? "another process"
                                                     : report.worker);
    case StudyStep::kDamaged:
      return fmt::format("left: {}", report.problem);
  }
  return "";
}

/// As the user would type it again.
std::string CommandText(const StudyRunCommand& command) {
  std::string text =
      fmt::format("plsc study run {} -o {}", command.study, command.output);
  if (!command.only.empty()) text += " --only " + command.only;
  if (!command.shard.empty()) text += " --shard " + command.shard;
  if (command.jobs) text += fmt::format(" --jobs {}", *command.jobs);
  if (!command.cache.empty()) text += " --cache " + command.cache;
  if (command.engine)
    text += fmt::format(" --engine {}", NameIn(kEngineNames, *command.engine));
  return text;
}

Exit Conclude(const StudyRunCommand& command, const Study& study,
              std::size_t runs, const StudyResult& result, Io& io) {
  io.out << fmt::format("{}: {} done now, {} before", Plural(runs),
                        result.finished, result.done_before);
  if (result.in_use > 0)
    io.out << fmt::format(", {} left to other processes", result.in_use);
  if (result.damaged > 0) io.out << fmt::format(", {} damaged", result.damaged);
  io.out << '\n';
  if (result.stopped_in)
    io.err << fmt::format(
        "the study {} in {}; go on with\n  {}\n",
        result.end == RunEnd::kStopped ? "was stopped" : "failed",
        Escaped(RunName(study, *result.stopped_in)), CommandText(command));
  switch (result.end) {
    case RunEnd::kStopped:
      return Exit::kInterrupted;
    case RunEnd::kFailed:
      return Exit::kBadInput;
    default:
      return Exit::kFine;
  }
}

}  // namespace

Exit Run(const StudyListCommand& command, Io& io) {
  const std::optional<Study> study = LoadStudy(command.study, io);
  if (!study) return Exit::kBadInput;
  const auto runs = ChosenRuns(*study, command.only, command.shard, io);
  if (!runs) return Exit::kBadInput;
  std::int64_t evaluations = 0;
  for (const StudyRun& run : *runs) {
    const Experiment experiment = ExperimentOf(*study, run);
    evaluations += Evaluations(experiment);
    if (command.format == OutputFormat::kText) {
      io.out << fmt::format("{:16} seed {:<20}  {} evaluations\n",
                            Escaped(RunName(*study, run)), experiment.seed,
                            Evaluations(experiment));
      continue;
    }
    nlohmann::ordered_json json;
    json["experiment"] = study->experiments[run.experiment].name;
    json["repetition"] = run.repetition;
    json["seed"] = std::to_string(experiment.seed);
    json["evaluations"] = Evaluations(experiment);
    io.out << DumpJson(json) << '\n';
  }
  if (command.format == OutputFormat::kText)
    io.out << fmt::format("{}, {} evaluations\n", Plural(runs->size()),
                          evaluations);
  return Exit::kFine;
}

Exit Run(const StudyRunCommand& command, Io& io) {
  const std::optional<Study> study = LoadForRunning(command, io);
  if (!study) return Exit::kBadInput;
  const auto runs = ChosenRuns(*study, command.only, command.shard, io);
  if (!runs) return Exit::kBadInput;
  if (const auto failure = Prepare(command, *study))
    return Complain(*failure, io);
  MentionSwift(command, *study, io);
  const InterruptHandler handler;
  StudyOptions options;
  options.execute = [&](const RunTask& task) {
    // Another study's folder, or none, may be there since the last run.
    if (const auto failure = CheckFolder(command.output, *study)) {
      io.err << fmt::format("error: {}\n", failure->text);
      return RunEnd::kFailed;
    }
    return Execute(task, command, io);
  };
  options.on_step = [&](const StudyRun& run, StudyStep step,
                        const RunReport& report) {
    if (command.quiet && step != StudyStep::kDamaged) return;
    io.err << fmt::format("{} {}\n", Escaped(RunName(*study, run)),
                          Escaped(StepText(step, report)));
  };
  const StudyResult result = RunStudy(command.output, *study, *runs, options);
  return Conclude(command, *study, runs->size(), result, io);
}

}  // namespace plsc::cli
