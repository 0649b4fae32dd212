// Everything is opened and looked through before anything is made, and what a
// failing command made is removed again (Discard): a typo must not leave half a
// store that the next attempt trips over. Caches are asked in the order of
// nearness: the run's own store, a salvaged one, the shared one.
//
// Evolve reads no clock and knows no signal. It asks should_stop some ten times
// a second, and that is where the progress line ticks and Ctrl-C is noticed.
// What went wrong at the end, in closing the store, makes a failed run of a
// finished one: results that are not on the disk are no results.

#include "runtime/cli/running/run_experiment.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <ostream>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/running/interrupt.h"
#include "runtime/cli/running/json_log.h"
#include "runtime/cli/running/progress.h"
#include "runtime/cli/running/utc_now.h"
#include "runtime/evolve/worker_request.h"
#include "runtime/store/lock.h"
#include "runtime/store/run_store.h"
#include "runtime/store/salvage.h"
#include "runtime/store/schema.h"
#include "runtime/store/shared_cache.h"
#include "runtime/workers/worker_count.h"
#include "runtime/workers/worker_pool.h"

namespace plsc::cli {

namespace {

double CpuSeconds(int who) {
  rusage usage{};
  ::getrusage(who, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) +
           1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

bool IsNew(const RunRequest& request) {
  std::error_code error;
  return request.experiment &&
         !(request.may_resume && std::filesystem::exists(request.path, error));
}

/// The store of a run to go on with, or what is wrong.
MaybeFailure OpenStore(const RunRequest& request, RunStore& store) {
  if (MaybeFailure failure =
          store.Open(request.path, request.allow_other_version)) {
    // So damaged that the store has no more to say.
    if (failure->kind == Failure::Kind::kMalformed)
      failure->text += fmt::format(
          "; 'plsc evolve --salvage {} -o NEW' makes the run again with the "
          "simulations that are whole",
          request.path);
    return failure;
  }
  if (!request.experiment || AreSame(*request.experiment, store.experiment()))
    return std::nullopt;
  store.Discard();
  return fmt::format(
      "'{}' is a run of another experiment or seed: choose another name, or "
      "`plsc evolve --resume {}` to go on with it as it is",
      request.path, request.path);
}

std::unique_ptr<Workers> WorkersFor(const RunRequest& request,
                                    const Experiment& experiment,
                                    const Work& work) {
  const double hang = request.hang_seconds.value_or(HangSeconds(experiment));
  if (request.mpi != nullptr)
    return request.mpi->MakeWorkers(PrintExperiment(experiment), hang);
  return std::make_unique<WorkerPool>(
      WorkerPoolOptions{WorkerCount(request.jobs.value_or(0)), hang}, work);
}

/// A damaged run and an experiment for the new one, or what is wrong.
MaybeFailure OpenSalvage(RunRequest& request, Salvage& salvage, Io& io) {
  if (MaybeFailure failure = salvage.Open(request.salvage)) return failure;
  const std::optional<Experiment>& own_experiment = salvage.experiment();
  if (!own_experiment && !request.experiment)
    return fmt::format(
        "what '{}' is a run of cannot be read: name the experiment's file, too",
        request.salvage);
  if (own_experiment && request.experiment &&
      !AreSame(*own_experiment, *request.experiment))
    return fmt::format("'{}' is a run of another experiment or seed",
                       request.salvage);
  const Versions own = VersionsFor(
      (own_experiment ? own_experiment : request.experiment)->scenario);
  if (!request.allow_other_version && !MakeTheSame(salvage.versions(), own))
    return fmt::format(
        "'{}' was begun by {}, and this is {} (where that does not matter: "
        "--allow-other-version)",
        request.salvage, VersionsText(salvage.versions()), VersionsText(own));
  if (own_experiment) request.experiment = own_experiment;
  if (const auto missing = MissingMeasures(salvage.schema()); !missing.empty())
    io.err << fmt::format(
        "'{}' is a store of schema {}, whose simulations lack {}: all are made "
        "again\n",
        request.salvage, salvage.schema(), fmt::join(missing, ", "));
  else
    io.err << fmt::format("{} simulated seasons of '{}' can be used\n",
                          salvage.size(), request.salvage);
  return std::nullopt;
}

/// Where a run's results and what is told of it go.
struct Stores {
  RunStore run;
  std::optional<SharedCache> cache;
  std::optional<Salvage> salvage;
  JsonLog log;

  /// A command that fails before it begins leaves nothing behind.
  void Discard() {
    log.Discard();
    if (cache) cache->Discard();
    run.Discard();
  }
};

/// Runs what the store has not got yet; prints nothing but progress.
void ExecuteRest(const RunRequest& request, Stores& stores, SavedRun saved,
                 RunOutcome& outcome, Io& io) {
  RunStore& store = stores.run;
  JsonLog& log = stores.log;
  const Experiment& experiment = outcome.experiment;
  Effort& effort = outcome.effort;
  const std::int64_t done_before = saved.evaluations;
  ProgressLine line(io.err, io.err_is_terminal, experiment.generations,
                    done_before);
  EvolveOptions options;
  options.make_workers = [&](const Work& work) {
    return WorkersFor(request, experiment, work);
  };
  options.caches = {&store};
  if (stores.salvage) options.caches.push_back(&*stores.salvage);
  if (stores.cache) options.caches.push_back(&*stores.cache);
  options.saved = std::move(saved);
  options.observers = {&store};
  const InterruptHandler handler;
  options.should_stop = [&] {  // asked ten times a second
    if (!request.quiet) line.Tick();
    log.Tick();
    return InterruptHandler::is_interrupted();
  };
  options.on_progress = [&](const Progress& progress) {
    effort.workers = progress.workers;
    if (!request.quiet) line.Report(progress);
    log.Report(progress);
  };
  log.Start({request.path, experiment.name, experiment.seed,
             experiment.generations, done_before, Evaluations(experiment)});
  const double children_before = CpuSeconds(RUSAGE_CHILDREN);
  const double own_before = CpuSeconds(RUSAGE_SELF);
  outcome.result = Evolve(experiment, options);
  if (!request.quiet) line.Finish();
  log.Finish(outcome.result.ending, outcome.result.failure);
  const double children = CpuSeconds(RUSAGE_CHILDREN) - children_before;
  effort.seconds = line.seconds();
  effort.cpu_seconds = children + CpuSeconds(RUSAGE_SELF) - own_before;
  // Workers are children that have ended when the run returns, so their CPU
  // time over what they could have had is how busy they were.
  if (request.mpi == nullptr)
    effort.busy_share =
        children / (effort.seconds * std::max(effort.workers, 1));
  effort.evaluations = outcome.result.evaluations - done_before;
  effort.counts = outcome.result.counts_of_work;
}

/// The shared cache and the log, if they are wanted.
MaybeFailure OpenOthers(const RunRequest& request, const Scenario& scenario,
                        Stores& stores) {
  if (!request.json_log.empty())
    if (MaybeFailure failure = stores.log.Open(request.json_log))
      return failure;
  if (request.cache.empty()) return std::nullopt;
  return stores.cache.emplace().Open(request.cache,
                                     ThisEngine(UsesOde(scenario)));
}

/// All that the run needs, its session begun. What is there already is opened,
/// and looked through, before anything is made.
MaybeFailure OpenAll(const RunRequest& request, Stores& stores,
                     RunOutcome& outcome) {
  const bool is_new = IsNew(request);
  RunStore& store = stores.run;
  const auto check_lock = [&](MaybeFailure failure) {
    if (failure) outcome.is_locked = WhoWorksOn(request.path).has_value();
    return failure;
  };
  if (MaybeFailure failure =
          check_lock(is_new ? RunStore::CheckCreate(request.path)
                            : OpenStore(request, store)))
    return failure;
  const Experiment& experiment =
      is_new ? *request.experiment : store.experiment();
  if (MaybeFailure failure = OpenOthers(request, experiment.scenario, stores))
    return failure;
  if (is_new)
    if (MaybeFailure failure =
            check_lock(store.Create(request.path, *request.experiment)))
      return failure;
  return store.BeginSession({UtcNow(), request.jobs.value_or(0)});
}

SessionEnd EndOf(const RunOutcome& outcome) {
  const Effort& effort = outcome.effort;
  SessionEnd end;
  end.ended = UtcNow();
  end.how = NameIn(kEndingNames, outcome.result.ending);
  if (!outcome.result.failure.empty()) end.how += ": " + outcome.result.failure;
  end.workers = effort.workers;
  end.evaluations = effort.evaluations;
  end.simulated = effort.counts.simulations;
  end.looked_up = effort.counts.looked_up;
  end.seconds = effort.seconds;
  end.cpu_seconds = effort.cpu_seconds;
  return end;
}

Exit ExitOf(const RunOutcome& outcome, const std::string& path, Io& io) {
  const RunResult& result = outcome.result;
  const std::string shown = Escaped(path);
  switch (result.ending) {
    case Ending::kFinished:
      return Exit::kFine;
    case Ending::kStopped:
      io.err << fmt::format(
          "stopped after {} generations and {} evaluations, which are in {}; "
          "go on with\n  plsc evolve --resume {}\n",
          result.generations, result.evaluations, shown, shown);
      return Exit::kInterrupted;
    case Ending::kFailed:
      io.err << fmt::format(
          "error: {}\n{} generations and what was evaluated since are in {}; "
          "when the cause is mended, go on with\n  plsc evolve --resume {}\n",
          Escaped(result.failure), result.generations, shown, shown);
      return Exit::kBadInput;
  }
  return Exit::kBadInput;
}

}  // namespace

RunOutcome ExecuteRun(const RunRequest& asked, Io& io) {
  RunRequest request = asked;
  RunOutcome outcome;
  const auto complain = [&](const Failure& failure) {
    outcome.exit = Complain(failure, io);
    return outcome;
  };
  Stores stores{{}, {}, {}, JsonLog(io.out)};
  RunStore& store = stores.run;
  if (!request.salvage.empty())
    if (const MaybeFailure failure =
            OpenSalvage(request, stores.salvage.emplace(), io))
      return complain(*failure);
  if (const MaybeFailure failure = OpenAll(request, stores, outcome)) {
    stores.Discard();
    return complain(*failure);
  }
  outcome.experiment = store.experiment();
  Expected<SavedRun, Failure> saved = store.Load();
  if (!saved) return complain(saved.error());
  ExecuteRest(request, stores, std::move(*saved), outcome, io);
  for (const MaybeFailure& warning :
       {stores.cache ? stores.cache->warning() : MaybeFailure(),
        stores.log.failure()})
    if (warning) io.err << fmt::format("warning: {}\n", Escaped(warning->text));
  MaybeFailure closing = store.EndSession(EndOf(outcome));
  if (const MaybeFailure failure = store.Close(); failure && !closing)
    closing = failure;
  if (closing && outcome.result.ending != Ending::kFailed) {
    outcome.result.ending = Ending::kFailed;
    outcome.result.failure = closing->text;
  }
  outcome.exit = store.is_lost() ? Complain(outcome.result.failure, io)
                                 : ExitOf(outcome, request.path, io);
  return outcome;
}

}  // namespace plsc::cli
