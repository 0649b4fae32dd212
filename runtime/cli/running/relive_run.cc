// A file that has all that is asked for is only read, so that it can be shown
// wherever it lies. Otherwise orders go to workers in phases that differ in the
// scenario: as it was, one season alone for those that are swapped, by the
// other engine. A robot is swapped by what it is told: in a scenario of that
// season alone it is born with the senses of another one, and so develops as it
// did there.

#include "runtime/cli/running/relive_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <span>
#include <utility>

#include "runtime/cli/files/open_run.h"
#include "runtime/cli/running/interrupt.h"
#include "runtime/cli/running/relive.h"
#include "runtime/relive/displacement.h"
#include "sim/results.h"

namespace plsc::cli {

namespace {

// Robots that are ready for the workers: enough that these hardly ever wait for
// the last of them, few enough to take some megabytes.
constexpr std::size_t kAtOnce = 1000;

bool IsSamePhase(const LifeOf& a, const LifeOf& b) {
  return a.is_other_engine == b.is_other_engine &&
         a.is_swapped() == b.is_swapped() &&
         (!a.is_swapped() || a.season == b.season);
}

/// What the robots of a phase live in.
Experiment ExperimentFor(const LifeOf& of, Experiment experiment) {
  Scenario& scenario = experiment.scenario;
  if (of.is_other_engine) SetEngine(scenario, OtherEngine(scenario));
  if (of.is_swapped())
    scenario.seasons = {scenario.seasons[static_cast<std::size_t>(of.season)]};
  return experiment;
}

Senses SensesIn(const SeasonResult& season) {
  Senses senses;
  for (const SensedState& state : season.sensed)
    senses[state.name] = state.value;
  return senses;
}

class ReliveTask {
 public:
  ReliveTask(RunStore& store, RelivedFile& file, std::optional<int> jobs,
             const OnLived& on_lived, ReliveOutcome& outcome)
      : store_(store),
        file_(file),
        jobs_(jobs),
        on_lived_(on_lived),
        outcome_(outcome) {}

  /// Whether all of them are lived.
  bool Run(std::span<const LifeOrder> orders) {
    on_lived_(0, outcome_.missing);
    while (!orders.empty()) {
      std::size_t count = 1;
      while (count < orders.size() &&
             IsSamePhase(orders[0].of, orders[count].of))
        ++count;
      if (!RunPhase(orders.first(count))) return false;
      orders = orders.subspan(count);
    }
    return true;
  }

 private:
  bool Fail(MaybeFailure failure) {
    outcome_.exit = Exit::kBadInput;
    outcome_.failure = std::move(failure);
    return false;
  }

  bool RunPhase(std::span<const LifeOrder> orders) {
    const Experiment experiment =
        ExperimentFor(orders[0].of, store_.experiment());
    if (auto failure = file_.BeginEngine(orders[0].of.is_other_engine,
                                         VersionsFor(experiment.scenario)))
      return Fail(std::move(failure));
    Relive relive(experiment, jobs_);
    while (!orders.empty()) {
      const auto batch = orders.first(std::min(orders.size(), kAtOnce));
      orders = orders.subspan(batch.size());
      std::vector<Individual> robots;
      if (auto failure = Load(batch, robots)) return Fail(std::move(failure));
      const auto keep = [&](const std::vector<EvaluatedRobot>& lived) {
        return Keep(lived, batch, robots);
      };
      if (relive.Live(robots, keep, InterruptHandler::is_interrupted)) continue;
      if (relive.failure()) return Fail(relive.failure());
      outcome_.exit = Exit::kInterrupted;
      return false;
    }
    return true;
  }

  MaybeFailure Load(std::span<const LifeOrder> orders,
                    std::vector<Individual>& robots) {
    const std::size_t seasons = store_.experiment().scenario.seasons.size();
    std::map<int, Individual> known;
    for (const LifeOrder& order : orders) {
      if (!known.contains(order.of.id)) {
        Expected<Individual, Failure> one = store_.Find(order.of.id);
        if (!one) return one.error();
        known.emplace(order.of.id, std::move(*one));
      }
      Individual& robot = robots.emplace_back(known.at(order.of.id));
      Disturbances starts =
          DisplacedStarts(store_.experiment().seed, robot.id, order.n, seasons);
      if (order.of.is_swapped()) {
        const auto other = static_cast<std::size_t>(order.of.phenotype);
        robot.heritage.senses = SensesIn(robot.evaluation.seasons[other]);
        starts = {starts[static_cast<std::size_t>(order.of.season)]};
      }
      robot.disturbances = std::move(starts);
      robot.evaluation = {};
    }
    return std::nullopt;
  }

  MaybeFailure Keep(const std::vector<EvaluatedRobot>& lived,
                    std::span<const LifeOrder> orders,
                    const std::vector<Individual>& robots) {
    std::vector<RelivedSeason> rows;
    for (const EvaluatedRobot& one : lived) {
      const LifeOrder& order = orders[one.robot];
      const Disturbances& starts = robots[one.robot].disturbances;
      const auto& seasons = one.life.evaluation.seasons;
      bool has_died = false;
      for (std::size_t i = 0; i < seasons.size(); ++i) {
        LifeOf of = order.of;
        if (!of.is_swapped()) of.season = of.phenotype = static_cast<int>(i);
        rows.push_back(RelivedOf(of, order.n, starts[i].lift, seasons[i]));
        has_died = has_died || seasons[i].outcome == Outcome::kWorkerDied;
      }
      outcome_.deaths += has_died ? 1 : 0;
    }
    if (auto failure = file_.Add(rows)) return failure;
    outcome_.lived += static_cast<std::int64_t>(lived.size());
    on_lived_(outcome_.lived, outcome_.missing);
    return std::nullopt;
  }

  RunStore& store_;
  RelivedFile& file_;
  const std::optional<int> jobs_;
  const OnLived& on_lived_;
  ReliveOutcome& outcome_;
};

/// What of the request cannot be done, or must be known; it is changed so that
/// it can.
std::string NoteOf(const RunStore& store, ReliveRequest& request) {
  std::string note;
  if (request.is_engine_checked) {
    Scenario scenario = store.experiment().scenario;
    const EngineKind other = OtherEngine(scenario);
    if (const auto problem = SetEngine(scenario, other)) {
      request.is_engine_checked = false;
      note = fmt::format("'{}' cannot be lived by the other engine: {}",
                         store.path(), problem->message);
    }
  }
  const Versions own = VersionsFor(store.experiment().scenario);
  if (!MakeTheSame(store.versions(), own))
    note += fmt::format(
        "{}'{}' was made by {}, and this is {}: not all that its records lose "
        "is luck",
        note.empty() ? "" : "; ", store.path(), VersionsText(store.versions()),
        VersionsText(own));
  return note;
}

/// The lives in a file that is there; none if it is not.
Expected<std::vector<RelivedSeason>, Failure> LivesThere(
    const std::string& path, const ReliveSubjects& subjects,
    RelivedFile& file) {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, error)))
    return std::vector<RelivedSeason>{};
  if (auto failure = file.OpenForReading(path, subjects.run)) return *failure;
  if (auto failure = file.CheckRobots(subjects.Sums())) return *failure;
  return file.Lives();
}

/// Who lives how often, by how many workers, and who is told.
struct ReliveWork {
  const ReliveSubjects& subjects;
  const ReliveRequest& request;
  std::optional<int> jobs;
  const OnLived& on_lived;
};

MaybeFailure LiveMissing(RunStore& store, const ReliveWork& work,
                         RelivedFile& file, ReliveOutcome& outcome) {
  const ReliveSubjects& subjects = work.subjects;
  const std::string path = RelivedPathOf(store.path());
  if (auto failure = file.OpenForWriting(path, subjects.run)) return failure;
  if (auto failure = file.BeginRobots(subjects.Sums())) return failure;
  // Another process may have added to it since we looked.
  const auto there = file.Lives();
  if (!there) return there.error();
  const auto orders = MissingLives(subjects, work.request, *there);
  outcome.missing = static_cast<std::int64_t>(orders.size());
  ReliveTask(store, file, work.jobs, work.on_lived, outcome).Run(orders);
  MaybeFailure closing = file.Close();
  if (closing && !outcome.failure) return closing;
  return outcome.failure;
}

}  // namespace

ReliveOutcome ReliveRun(const std::string& run, const ReliveRequest& asked,
                        std::optional<int> jobs, const OnLived& on_lived) {
  ReliveOutcome outcome;
  const auto fail = [&](Failure failure) {
    outcome.exit = Exit::kBadInput;
    outcome.failure = std::move(failure);
    return outcome;
  };
  RunStore store;
  if (auto failure = store.OpenForReading(run)) return fail(*failure);
  ReliveRequest request = asked;
  outcome.note = NoteOf(store, request);
  const auto subjects = SubjectsOf(store, request.generations);
  if (!subjects) return fail(subjects.error());
  RelivedFile file;
  const std::string path = RelivedPathOf(run);
  const auto there = LivesThere(path, *subjects, file);
  if (!there) return fail(there.error());
  outcome.before = static_cast<std::int64_t>(there->size());
  const auto orders = MissingLives(*subjects, request, *there);
  if (!orders.empty()) {
    file.Close();
    if (auto failure = LiveMissing(store, {*subjects, request, jobs, on_lived},
                                   file, outcome))
      return fail(*failure);
    if (outcome.exit != Exit::kFine) return outcome;
    if (auto failure = file.OpenForReading(path, subjects->run))
      return fail(*failure);
  }
  Expected<RelivedRun, Failure> result = ReadRelivedRun(store, *subjects, file);
  if (!result) return fail(result.error());
  outcome.result = std::move(*result);
  return outcome;
}

}  // namespace plsc::cli
