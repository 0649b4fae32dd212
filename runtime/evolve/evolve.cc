// The paper's evolution (authors' program, population.py, selection.py): a
// population, as many children as the experiment says, and the next population
// taken from both by tournaments, without an elite. What selection goes by is
// how many others of the pool an individual dominates over all seasons;
// survivors keep the numbers of their pool, by which the next parents are
// chosen.
//
// A run must be the same bit for bit with any number of workers, and after any
// number of stops. Three things make it so. Every draw comes from a stream
// named by seed, generation, individual and purpose, so no state of random
// numbers is carried along; ids follow from the generation alone (FirstIdOf).
// Births are all told before the first evaluation is asked for, evaluations may
// come in any order, and nothing is decided before all are there. And what a
// generation decides is told to observers once, when it is complete: a run that
// is stopped or killed within a generation makes the same births again, finds
// those evaluated that were, and decides alike.
//
// Whatever waits or takes long asks IsStopped; once it has said so it stays so,
// or a generation could be half stopped. The loop costs some 1 ms of CPU time a
// robot, domination counts (the pool squared) included, beside some 400 ms of
// physics; that is why it is not spread over the workers.

#include "runtime/evolve/evolve.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "runtime/evolve/breed.h"
#include "runtime/evolve/select.h"
#include "runtime/evolve/worker_request.h"
#include "runtime/life/evaluation.h"
#include "runtime/scenario/scenario_fitness.h"
#include "runtime/workers/worker_count.h"
#include "runtime/workers/worker_pool.h"

namespace plsc {

namespace {

// How long a stop may stay unseen; SIGINT ends the waiting at once.
constexpr int kPatience = 100;  // ms

// Pools up to here, by tournaments up to there, are selected in a moment,
// mostly of milliseconds: who asks for a stop meanwhile gets the generation
// completed.
constexpr std::size_t kSmallPool = 1000;
constexpr int kSmallTournament = 10;

std::vector<int> IdsOf(const std::vector<Individual>& individuals) {
  std::vector<int> ids;
  ids.reserve(individuals.size());
  for (const Individual& one : individuals) ids.push_back(one.id);
  return ids;
}

// Ties go to the older one, so that the best of a run does not change for
// nothing from generation to generation.
std::size_t BestOf(const std::vector<Individual>& population,
                   const std::vector<int>& counts) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < population.size(); ++i)
    if (counts[i] > counts[best] ||
        (counts[i] == counts[best] && population[i].id < population[best].id))
      best = i;
  return best;
}

// One run. Each function that can end it returns whether it goes on.
class Run {
 public:
  Run(const Experiment& experiment, const EvolveOptions& options)
      : experiment_(experiment),
        options_(options),
        planner_(experiment.scenario, options.simulate),
        workers_(MakeWorkers()),
        evaluator_(planner_, *workers_, options.caches,
                   {experiment.seed, experiment.trials}) {
    if (!options.saved) return;
    result_.generations = options.saved->generations;
    result_.evaluations = options.saved->evaluations;
    result_.population = options.saved->population;
    result_.counts = options.saved->counts;
    next_id_ = FirstIdOf(result_.generations);
    Summarise(result_.population);
  }

  RunResult Evolve() {
    while (result_.ending == Ending::kFinished &&
           result_.generations < experiment_.generations &&
           EvolveGeneration(result_.generations)) {
    }
    // Asked to stop when everything was done already.
    if (result_.ending == Ending::kStopped &&
        result_.generations == experiment_.generations)
      result_.ending = Ending::kFinished;
    if (!result_.population.empty())
      result_.best =
          result_.population[BestOf(result_.population, result_.counts)];
    result_.counts_of_work = evaluator_.counts();
    return std::move(result_);
  }

 private:
  std::unique_ptr<Workers> MakeWorkers() const {
    const Work work = WorkOf(planner_);
    if (options_.make_workers) return options_.make_workers(work);
    return std::make_unique<WorkerPool>(
        WorkerPoolOptions{WorkerCount(options_.jobs), HangSeconds(experiment_)},
        work);
  }

  // The store numbers births in the same way (store/row_checks, IdsBornIn), and
  // finds by it which are missing.
  int FirstIdOf(int generation) const {
    return 1 + (generation == 0 ? 0
                                : experiment_.population +
                                      (generation - 1) * experiment_.offspring);
  }

  bool EvolveGeneration(int generation) {
    return generation == 0 ? Begin() : Continue(generation);
  }

  bool Begin() {
    std::vector<Individual> robots;
    robots.reserve(static_cast<std::size_t>(experiment_.population));
    for (int i = 0; i < experiment_.population; ++i) {
      if (IsStopped()) return false;
      robots.push_back(CreateFirst(experiment_, next_id_++));
    }
    if (!Evaluate(robots)) return false;
    const std::vector<int> ids = IdsOf(robots);
    std::optional<std::vector<int>> counts = CountsOf(robots);
    if (!counts) return false;
    result_.counts = std::move(*counts);
    result_.population = std::move(robots);
    return Complete({0, ids, result_.counts, ids, 0});
  }

  bool Continue(int generation) {
    std::vector<Individual> children;
    children.reserve(static_cast<std::size_t>(experiment_.offspring));
    for (int i = 0; i < experiment_.offspring; ++i) {
      if (IsStopped()) return false;
      children.push_back(CreateChild(experiment_, generation, next_id_++,
                                     result_.population, result_.counts));
    }
    if (!Evaluate(children)) return false;
    std::vector<Individual> all = std::move(result_.population);
    std::move(children.begin(), children.end(), std::back_inserter(all));
    std::optional<GenerationRecord> record = Select(generation, all);
    if (!record) {
      // The parents, who come first in the pool and are still the last
      // completed generation.
      all.resize(result_.counts.size());
      result_.population = std::move(all);
      return false;
    }
    return Complete(std::move(*record));
  }

  /// Leaves the survivors in the result; nothing, and all as it was, where a
  /// stop is asked for meanwhile.
  std::optional<GenerationRecord> Select(int generation,
                                         std::vector<Individual>& all) {
    std::optional<std::vector<int>> counts = CountsOf(all);
    if (!counts) return std::nullopt;
    Rng rng({experiment_.seed, static_cast<std::uint64_t>(generation), 0,
             Purpose::kSelectSurvivors});
    const auto size = static_cast<std::size_t>(experiment_.population);
    const std::vector<std::size_t> survivors = SelectDistinct(
        *counts, size, experiment_.tournament, rng, StopFor(all));
    if (survivors.size() < size) return std::nullopt;
    GenerationRecord record = {generation, IdsOf(all), *counts, {}, 0};
    result_.population.clear();
    result_.counts.clear();
    for (const std::size_t i : survivors) {
      result_.population.push_back(std::move(all[i]));
      result_.counts.push_back((*counts)[i]);
    }
    record.survivors = IdsOf(result_.population);
    return record;
  }

  /// What selection from the pool is to ask.
  std::function<bool()> StopFor(const std::vector<Individual>& pool) {
    if (pool.size() <= kSmallPool && experiment_.tournament <= kSmallTournament)
      return {};
    return [this] { return IsStopped(); };
  }

  std::optional<std::vector<int>> CountsOf(
      const std::vector<Individual>& pool) {
    std::vector<SeasonFitnesses> fitnesses;
    fitnesses.reserve(pool.size());
    for (const Individual& one : pool) fitnesses.push_back(FitnessesOf(one));
    std::vector<int> counts = DominationCounts(fitnesses, StopFor(pool));
    if (counts.size() < pool.size()) return std::nullopt;
    return counts;
  }

  bool Complete(GenerationRecord record) {
    ++result_.generations;
    record.best =
        result_.population[BestOf(result_.population, result_.counts)].id;
    for (RunObserver* observer : options_.observers)
      if (auto failure = observer->OnGeneration(record)) return Fail(*failure);
    Summarise(result_.population);
    return true;
  }

  /// Evaluates all that were not before the run was left.
  bool Evaluate(std::vector<Individual>& robots) {
    for (RunObserver* observer : options_.observers)
      if (auto failure =
              observer->OnBirths(robots, [this] { return IsStopped(); }))
        return Fail(*failure);
    if (IsStopped()) return false;
    if (options_.saved)
      for (Individual& robot : robots)
        if (const auto known = options_.saved->evaluated.find(robot.id);
            known != options_.saved->evaluated.end())
          robot.evaluation = known->second;
    if (result_.population.empty()) Summarise(robots);
    evaluator_.Begin(robots);
    while (evaluator_.outstanding() > 0) {
      if (IsStopped()) evaluator_.Cancel();
      const std::vector<EvaluatedRobot> evaluated = evaluator_.Wait(kPatience);
      for (const EvaluatedRobot& one : evaluated)
        if (!Keep(one, robots)) return false;
      if (!evaluated.empty()) ReportProgress(robots.front().generation);
      if (evaluator_.failure()) return Fail(*evaluator_.failure());
      if (result_.ending == Ending::kStopped && workers_->outstanding() == 0 &&
          evaluated.empty())
        break;
    }
    return evaluator_.outstanding() == 0;
  }

  bool Keep(const EvaluatedRobot& one, std::vector<Individual>& robots) {
    Individual& robot = robots[one.robot];
    robot.evaluation = one.life.evaluation;
    for (RunObserver* observer : options_.observers)
      if (auto failure = observer->OnEvaluated(robot, one.life.evidence))
        return Fail(*failure);
    ++result_.evaluations;
    if (result_.population.empty()) summary_.Add(robot.evaluation);
    return true;
  }

  /// Once it is, it stays so.
  bool IsStopped() {
    if (result_.ending != Ending::kStopped && options_.should_stop &&
        options_.should_stop())
      result_.ending = Ending::kStopped;
    return result_.ending == Ending::kStopped;
  }

  bool Fail(const Failure& failure) {
    result_.ending = Ending::kFailed;
    result_.failure = failure.text;
    return false;
  }

  void Summarise(const std::vector<Individual>& robots) {
    summary_ = {};
    for (const Individual& robot : robots) summary_.Add(robot.evaluation);
  }

  void ReportProgress(int generation) const {
    if (!options_.on_progress) return;
    Progress progress;
    progress.generation = generation;
    progress.evaluations = result_.evaluations;
    progress.total = Evaluations(experiment_);
    progress.workers = workers_->workers();
    progress.busy_workers = workers_->busy();
    progress.simulations = evaluator_.counts().simulations;
    progress.looked_up = evaluator_.counts().looked_up;
    progress.simulated_seconds = evaluator_.counts().simulated_seconds;
    progress.seasons = summary_.Summaries();
    progress.has_own_fitness = HasOwnFitness(experiment_.scenario);
    options_.on_progress(progress);
  }

  const Experiment& experiment_;
  const EvolveOptions& options_;
  const LifePlanner planner_;
  std::unique_ptr<Workers> workers_;
  GenerationEvaluator evaluator_;
  int next_id_ = 1;
  /// Of the population; of those evaluated so far in generation 0.
  SeasonSummary summary_;
  RunResult result_;
};

}  // namespace

RunResult Evolve(const Experiment& experiment, const EvolveOptions& options) {
  assert(experiment.population >= 2 && experiment.offspring >= 1 &&
         experiment.generations >= 1);
  return Run(experiment, options).Evolve();
}

}  // namespace plsc
