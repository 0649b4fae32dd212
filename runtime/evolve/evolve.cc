#include "runtime/evolve/evolve.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "compiler/print.h"
#include "runtime/evolve/breed.h"
#include "runtime/evolve/judge.h"
#include "runtime/evolve/select.h"
#include "runtime/evolve/worker_count.h"
#include "runtime/evolve/worker_pool.h"

namespace plsc {

namespace {

// How long a stop may stay unseen; SIGINT ends the waiting at once.
constexpr int kPatience = 100;  // ms

std::vector<int> IdsOf(const std::vector<Individual>& individuals) {
  std::vector<int> ids;
  ids.reserve(individuals.size());
  for (const Individual& one : individuals) ids.push_back(one.id);
  return ids;
}

std::vector<int> CountsOf(const std::vector<Individual>& pool) {
  std::vector<SeasonFitnesses> fitnesses;
  fitnesses.reserve(pool.size());
  for (const Individual& one : pool) fitnesses.push_back(FitnessesOf(one));
  return DominationCounts(fitnesses);
}

std::size_t BestOf(const std::vector<Individual>& population,
                   const std::vector<int>& counts) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < population.size(); ++i)
    if (counts[i] > counts[best] ||
        (counts[i] == counts[best] && population[i].id < population[best].id))
      best = i;
  return best;
}

std::vector<SeasonProgress> Summarise(const std::vector<Individual>& robots,
                                      std::size_t count) {
  std::vector<SeasonProgress> summary;
  if (count == 0) return summary;
  const auto& seasons = robots.front().evaluation.seasons;
  for (std::size_t i = 0; i < seasons.size(); ++i) {
    SeasonFitnesses all;
    for (std::size_t k = 0; k < count; ++k)
      all.push_back(robots[k].evaluation.seasons[i].fitness);
    std::sort(all.begin(), all.end());
    summary.push_back(
        {seasons[i].season, all.back(), all[(all.size() - 1) / 2]});
  }
  return summary;
}

// One run. Each function that can end it returns whether it goes on.
class Run {
 public:
  Run(const Experiment& experiment, const EvolveOptions& options)
      : experiment_(experiment),
        options_(options),
        pool_(WorkerCount(options.jobs),
              JudgeWith(options.evaluate ? options.evaluate
                                         : [scenario = experiment.scenario](
                                               const Genotype& genotype) {
                                             return plsc::Evaluate(genotype,
                                                                   scenario);
                                           })) {}

  RunResult Live() {
    bool goes_on = Begin();
    for (int g = 1; goes_on && g < experiment_.generations; ++g)
      goes_on = result_.ending == Ending::kFinished && Continue(g);
    // Asked to stop when everything was done already.
    if (result_.ending == Ending::kStopped &&
        result_.generations == experiment_.generations)
      result_.ending = Ending::kFinished;
    if (!result_.population.empty())
      result_.best =
          result_.population[BestOf(result_.population, result_.counts)];
    return std::move(result_);
  }

 private:
  bool Begin() {
    std::vector<Individual> robots;
    robots.reserve(static_cast<std::size_t>(experiment_.population));
    for (int i = 0; i < experiment_.population; ++i)
      robots.push_back(CreateFirst(experiment_, next_id_++));
    if (!Judge(robots)) return false;
    const std::vector<int> ids = IdsOf(robots);
    result_.counts = CountsOf(robots);
    result_.population = std::move(robots);
    return Complete({0, ids, result_.counts, ids, 0});
  }

  bool Continue(int generation) {
    std::vector<Individual> children;
    children.reserve(static_cast<std::size_t>(experiment_.offspring));
    for (int i = 0; i < experiment_.offspring; ++i)
      children.push_back(CreateChild(experiment_, generation, next_id_++,
                                     result_.population, result_.counts));
    if (!Judge(children)) return false;
    std::vector<Individual> all = std::move(result_.population);
    std::move(children.begin(), children.end(), std::back_inserter(all));
    const std::vector<int> counts = CountsOf(all);
    GenerationRecord record = {generation, IdsOf(all), counts, {}, 0};
    Rng rng({experiment_.seed, static_cast<std::uint64_t>(generation), 0,
             Purpose::kSelectSurvivors});
    result_.population.clear();
    result_.counts.clear();
    for (const std::size_t i : SelectDistinct(
             counts, static_cast<std::size_t>(experiment_.population),
             experiment_.tournament, rng)) {
      result_.population.push_back(std::move(all[i]));
      result_.counts.push_back(counts[i]);
    }
    record.survivors = IdsOf(result_.population);
    return Complete(std::move(record));
  }

  bool Complete(GenerationRecord record) {
    ++result_.generations;
    record.best =
        result_.population[BestOf(result_.population, result_.counts)].id;
    for (RunObserver* observer : options_.observers)
      if (auto failure = observer->OnGeneration(record))
        return Fail(std::move(*failure));
    return true;
  }

  /// Evaluates all, and shows them to the observers in order of id.
  bool Judge(std::vector<Individual>& robots) {
    for (RunObserver* observer : options_.observers)
      if (auto failure = observer->OnBirths(robots))
        return Fail(std::move(*failure));
    for (std::size_t i = 0; i < robots.size(); ++i)
      pool_.Submit(static_cast<int>(i), Print(robots[i].genotype));
    std::vector<bool> is_judged(robots.size(), false);
    std::size_t shown = 0;
    while (pool_.outstanding() > 0 && !pool_.failure()) {
      StopIfAsked();
      for (const Reply& reply : pool_.Wait(kPatience)) {
        const auto i = static_cast<std::size_t>(reply.ticket);
        robots[i].evaluation =
            EvaluationOf(reply, experiment_.scenario.seasons);
        is_judged[i] = true;
      }
      const std::size_t shown_before = shown;
      while (shown < robots.size() && is_judged[shown] && Show(robots[shown]))
        ++shown;
      if (result_.ending == Ending::kFailed) return false;
      if (shown > shown_before) Tell(robots, shown);
    }
    if (pool_.failure()) return Fail(*pool_.failure());
    return shown == robots.size();
  }

  bool Show(const Individual& robot) {
    for (RunObserver* observer : options_.observers)
      if (auto failure = observer->OnEvaluated(robot, {}))
        return Fail(std::move(*failure));
    ++result_.evaluations;
    return true;
  }

  void StopIfAsked() {
    if (!options_.should_stop || !options_.should_stop()) return;
    result_.ending = Ending::kStopped;
    pool_.CancelWaiting();
  }

  bool Fail(std::string failure) {
    result_.ending = Ending::kFailed;
    result_.failure = std::move(failure);
    return false;
  }

  void Tell(const std::vector<Individual>& robots, std::size_t shown) const {
    if (!options_.on_progress) return;
    Progress progress;
    progress.generation = robots.front().generation;
    progress.evaluations = result_.evaluations;
    progress.total = Evaluations(experiment_);
    progress.workers = pool_.workers();
    progress.busy_workers = pool_.busy();
    progress.seasons =
        result_.population.empty()
            ? Summarise(robots, shown)
            : Summarise(result_.population, result_.population.size());
    options_.on_progress(progress);
  }

  const Experiment& experiment_;
  const EvolveOptions& options_;
  WorkerPool pool_;
  int next_id_ = 1;
  RunResult result_;
};

}  // namespace

RunResult Evolve(const Experiment& experiment, const EvolveOptions& options) {
  assert(experiment.population >= 2 && experiment.offspring >= 1 &&
         experiment.generations >= 1);
  return Run(experiment, options).Live();
}

}  // namespace plsc
