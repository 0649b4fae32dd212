#include "runtime/evolve/evolve.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "runtime/life/simulated.h"
#include "tests/runtime/evolve/fake_run.h"
#include "tests/runtime/evolve/memory_cache.h"
#include "tests/sanitizer.h"

namespace plsc {

namespace {

using test::Look;
using test::MemoryCache;
using test::NumberOf;
using test::Recorder;
using test::SmallExperiment;

/// Slower for some than for others, so that answers overtake each other.
Simulated LookSlowly(const Phenotype& robot, const Season& season,
                     const Disturbance& disturbance) {
  for (std::uint64_t more = NumberOf(robot) % 5 * 5; more > 0; --more)
    Look(robot, season);
  return Look(robot, season, disturbance);
}

RunResult Record(const Experiment& experiment, int jobs,
                 SeasonSimulator simulate, Recorder& recorder) {
  EvolveOptions options;
  options.jobs = jobs;
  options.simulate = std::move(simulate);
  options.observers = {&recorder};
  return Evolve(experiment, options);
}

/// That both saw the same, whatever the order.
void CheckSame(const Recorder& one, const Recorder& other) {
  REQUIRE(one.individuals.size() == other.individuals.size());
  for (std::size_t i = 0; i < one.individuals.size(); ++i) {
    CAPTURE(i + 1);
    CHECK(one.individuals[i].genotype == other.individuals[i].genotype);
    CHECK(FitnessesOf(one.individuals[i]) == FitnessesOf(other.individuals[i]));
    REQUIRE(one.evidence[i].size() == other.evidence[i].size());
    for (std::size_t k = 0; k < one.evidence[i].size(); ++k) {
      CHECK(one.evidence[i][k].simulation == other.evidence[i][k].simulation);
      CHECK(one.evidence[i][k].phenotype == other.evidence[i][k].phenotype);
      CHECK(one.evidence[i][k].simulated.state_hash ==
            other.evidence[i][k].simulated.state_hash);
    }
  }
  CHECK(one.generations == other.generations);
}

std::vector<int> Ids(const std::vector<Individual>& individuals) {
  std::vector<int> ids;
  for (const Individual& one : individuals) ids.push_back(one.id);
  return ids;
}

}  // namespace

TEST_CASE("A run shows every birth, evaluation and generation", "[evolve]") {
  Recorder seen;
  const RunResult result = Record(SmallExperiment(), 2, LookSlowly, seen);
  CHECK(result.ending == Ending::kFinished);
  CHECK(result.evaluations == 32);
  CHECK(result.generations == 5);
  REQUIRE(seen.individuals.size() == 32);
  for (std::size_t i = 0; i < 32; ++i) {
    const Individual& one = seen.individuals[i];
    CHECK(one.id == static_cast<int>(i) + 1);
    CHECK(one.generation == (i < 8 ? 0 : 1 + (static_cast<int>(i) - 8) / 6));
    CHECK(one.heritage.parents.size() == (i < 8 ? 0 : 2));
  }
  const std::set<int> evaluated(seen.evaluated.begin(), seen.evaluated.end());
  CHECK(evaluated.size() == 32);
  CHECK(seen.evaluated.size() == 32);
  CHECK(seen.generations.size() == 5);
  REQUIRE(seen.births.size() == 5);
  CHECK(seen.births[0] == std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8});
  CHECK(seen.births[4] == std::vector<int>{27, 28, 29, 30, 31, 32});
}

TEST_CASE("A pool is the survivors and their children; the counts are its",
          "[evolve]") {
  Recorder seen;
  const RunResult result = Record(SmallExperiment(), 1, Look, seen);
  std::vector<int> parents;
  for (std::size_t g = 0; g < seen.generations.size(); ++g) {
    const GenerationRecord& record = seen.generations[g];
    CAPTURE(g);
    CHECK(record.generation == static_cast<int>(g));
    std::vector<int> expected = parents;
    for (const Individual& one : seen.individuals)
      if (one.generation == record.generation) expected.push_back(one.id);
    CHECK(record.pool == expected);
    std::vector<SeasonFitnesses> fitnesses;
    for (const int id : record.pool)
      fitnesses.push_back(
          FitnessesOf(seen.individuals[static_cast<std::size_t>(id - 1)]));
    CHECK(record.counts == DominationCounts(fitnesses));
    const std::set<int> survivors(record.survivors.begin(),
                                  record.survivors.end());
    CHECK(survivors.size() == 8);
    CHECK(record.survivors.size() == 8);
    for (const int id : survivors)
      CHECK(std::count(record.pool.begin(), record.pool.end(), id) == 1);
    // Parents of the generation are members of the one before.
    for (const Individual& one : seen.individuals)
      if (one.generation == record.generation)
        for (const int parent : one.heritage.parents)
          CHECK(std::count(parents.begin(), parents.end(), parent) == 1);
    parents = record.survivors;
  }
  CHECK(seen.generations[0].survivors == seen.generations[0].pool);
  CHECK(Ids(result.population) == parents);
}

TEST_CASE("The best has the highest count and the lowest id", "[evolve]") {
  Recorder seen;
  const RunResult result = Record(SmallExperiment(), 1, Look, seen);
  REQUIRE(result.best);
  const GenerationRecord& last = seen.generations.back();
  int best = 0;
  int best_count = -1;
  for (const int id : last.survivors) {
    const auto place = static_cast<std::size_t>(
        std::find(last.pool.begin(), last.pool.end(), id) - last.pool.begin());
    const int count = last.counts[place];
    if (count > best_count || (count == best_count && id < best)) {
      best = id;
      best_count = count;
    }
  }
  CHECK(result.best->id == best);
  CHECK(last.best == best);
}

TEST_CASE("Evaluations are what the seasons tell", "[evolve]") {
  Recorder seen;
  Record(SmallExperiment(), 2, LookSlowly, seen);
  const Scenario scenario = SmallExperiment().scenario;
  const LifePlanner planner(scenario, Look);
  for (std::size_t i = 0; i < seen.individuals.size(); ++i) {
    CAPTURE(i + 1);
    const Individual& one = seen.individuals[i];
    std::vector<std::optional<Simulated>> simulated(2);
    const std::vector<LifePiece> pieces = planner.Plan(one.genotype, {});
    for (const LifePiece& piece : pieces) {
      simulated[piece.first] = planner.Simulate(one.genotype, {}, piece)[0];
      CHECK(seen.evidence[i][piece.first].simulation == piece.keys[0]);
    }
    const EvaluatedLife life = planner.Assemble(one.genotype, {}, simulated);
    for (std::size_t k = 0; k < 2; ++k) {
      CHECK(life.evaluation.seasons[k].fitness ==
            one.evaluation.seasons[k].fitness);
      CHECK(life.evaluation.seasons[k].state_hash ==
            one.evaluation.seasons[k].state_hash);
      CHECK(life.evaluation.seasons[k].change_reason ==
            one.evaluation.seasons[k].change_reason);
    }
  }
}

TEST_CASE("The number of workers changes nothing", "[evolve]") {
  Recorder one;
  Recorder three;
  Record(SmallExperiment(), 1, Look, one);
  Record(SmallExperiment(), 3, LookSlowly, three);
  CheckSame(one, three);
}

TEST_CASE("Nothing is simulated twice, and caches change nothing", "[evolve]") {
  // Small genotypes, so that many robots are lone cores.
  Experiment experiment = SmallExperiment();
  experiment.genotype.max_groups = 1;
  experiment.generations = 8;
  Recorder plain;
  const RunResult first = Record(experiment, 2, LookSlowly, plain);

  MemoryCache memory;
  EvolveOptions options;
  options.jobs = 2;
  options.simulate = LookSlowly;
  options.caches = {&memory};
  Recorder cached;
  options.observers = {&cached};
  const RunResult second = Evolve(experiment, options);
  CheckSame(plain, cached);
  std::set<Key> different;
  std::int64_t seasons = 0;
  for (const auto& evidence : cached.evidence)
    for (const SeasonEvidence& season : evidence) {
      different.insert(season.simulation);
      ++seasons;
    }
  CHECK(second.counts_of_work.simulations ==
        static_cast<std::int64_t>(different.size()));
  CHECK(second.counts_of_work.simulations + second.counts_of_work.looked_up ==
        seasons);
  CHECK(second.counts_of_work.looked_up > first.counts_of_work.looked_up);
  CHECK(second.counts_of_work.simulated_seconds ==
        Approx(50.0 * static_cast<double>(different.size())));

  Recorder known;
  options.observers = {&known};
  options.simulate = [](const Phenotype&, const Season&,
                        const Disturbance&) -> Simulated {
    raise(SIGKILL);
    return {};
  };
  const RunResult third = Evolve(experiment, options);
  CHECK(third.counts_of_work.simulations == 0);
  CheckSame(plain, known);
}

TEST_CASE("Another seed gives another run", "[evolve]") {
  Experiment experiment = SmallExperiment();
  Recorder one;
  Recorder two;
  Record(experiment, 1, Look, one);
  experiment.seed = 2;
  Record(experiment, 1, Look, two);
  CHECK(one.individuals[0].genotype.rules != two.individuals[0].genotype.rules);
  CHECK(one.generations[4].survivors != two.generations[4].survivors);
}

TEST_CASE("Selection makes what it favours common", "[evolve]") {
  Experiment experiment;
  experiment.population = 40;
  experiment.offspring = 40;
  experiment.generations = 30;
  Recorder seen;
  Record(experiment, 2, Look, seen);
  const auto mean = [&](const std::vector<int>& ids) {
    double sum = 0;
    for (const int id : ids)
      sum += *seen.individuals[static_cast<std::size_t>(id - 1)]
                  .evaluation.seasons[0]
                  .fitness;
    return sum / static_cast<double>(ids.size());
  };
  // Drift alone changes little of it.
  CHECK(mean(seen.generations.back().survivors) >
        2 * mean(seen.generations.front().survivors));
}

TEST_CASE("A run that is asked to stop ends with what has begun", "[evolve]") {
  Recorder seen;
  EvolveOptions options;
  options.jobs = 2;
  options.simulate = LookSlowly;
  options.observers = {&seen};
  options.should_stop = [&] { return seen.evaluated.size() >= 10; };
  const RunResult result = Evolve(SmallExperiment(), options);
  CHECK(result.ending == Ending::kStopped);
  CHECK(result.generations == 1);
  CHECK(seen.generations.size() == 1);
  CHECK(result.evaluations == static_cast<int>(seen.evaluated.size()));
  CHECK(seen.evaluated.size() >= 10);
  CHECK(seen.evaluated.size() < 14);  // the generation was not completed
  CHECK(Ids(result.population) == seen.generations[0].survivors);
  CHECK(result.best);
}

TEST_CASE("A run goes on from any evaluation as if never left", "[evolve]") {
  Recorder whole;
  Record(SmallExperiment(), 2, Look, whole);
  for (std::size_t left_after = 0; left_after <= 32;
       left_after += test::kSparser) {
    CAPTURE(left_after);
    Recorder seen;
    EvolveOptions options;
    options.jobs = 2;
    options.simulate = Look;
    options.observers = {&seen};
    options.should_stop = [&] { return seen.evaluated.size() >= left_after; };
    const RunResult first = Evolve(SmallExperiment(), options);
    SavedRun saved;
    saved.generations = first.generations;
    saved.population = first.population;
    saved.counts = first.counts;
    saved.evaluations = first.evaluations;
    const int begun = seen.births.empty() ? 0 : seen.births.back().front();
    for (const int id : seen.evaluated)
      if (id >= begun && seen.births.size() > seen.generations.size())
        saved.evaluated[id] =
            seen.individuals[static_cast<std::size_t>(id - 1)].evaluation;
    options.saved = saved;
    options.should_stop = nullptr;
    const RunResult result = Evolve(SmallExperiment(), options);
    CHECK(result.ending == Ending::kFinished);
    CHECK(result.evaluations == 32);
    CHECK(seen.evaluated.size() == 32);
    REQUIRE(result.best);
    CHECK(result.best->id == whole.generations.back().best);
    CheckSame(whole, seen);
  }
}

TEST_CASE("A run that is stopped at once has no best", "[evolve]") {
  EvolveOptions options;
  options.jobs = 1;
  options.simulate = Look;
  options.should_stop = [] { return true; };
  const RunResult result = Evolve(SmallExperiment(), options);
  CHECK(result.ending == Ending::kStopped);
  CHECK(result.generations == 0);
  CHECK(result.evaluations <= 1);
  CHECK_FALSE(result.best);
}

TEST_CASE("An observer that fails ends the run", "[evolve]") {
  Recorder seen;
  seen.failing_after = 4;
  const RunResult result = Record(SmallExperiment(), 2, Look, seen);
  CHECK(result.ending == Ending::kFailed);
  CHECK(result.failure == "the disk is full");
  CHECK(result.evaluations == 4);
}

TEST_CASE("Who kills its workers has no fitness, and the run goes on",
          "[evolve]") {
  Recorder seen;
  const auto deadly = [](const Phenotype& robot, const Season& season,
                         const Disturbance&) {
    if (NumberOf(robot) % 4 == 1 && season.name == "flat") raise(SIGKILL);
    return Look(robot, season);
  };
  const RunResult result = Record(SmallExperiment(), 2, deadly, seen);
  CHECK(result.ending == Ending::kFinished);
  CHECK(result.evaluations == 32);
  int deaths = 0;
  for (const Individual& one : seen.individuals) {
    REQUIRE(one.evaluation.seasons.size() == 2);
    const SeasonResult& flat = one.evaluation.seasons[0];
    if (flat.outcome != Outcome::kWorkerDied) continue;
    ++deaths;
    CHECK_FALSE(flat.fitness);
    CHECK(flat.body.absolute_size > 0);  // it developed
    CHECK(flat.reason.find("signal 9") != std::string::npos);
    CHECK(one.evaluation.seasons[1].outcome != Outcome::kWorkerDied);
  }
  CHECK(deaths > 0);
}

TEST_CASE("Progress counts up to the whole run", "[evolve]") {
  std::vector<Progress> reports;
  EvolveOptions options;
  options.jobs = 2;
  options.simulate = Look;
  options.on_progress = [&](const Progress& progress) {
    reports.push_back(progress);
  };
  Evolve(SmallExperiment(), options);
  REQUIRE_FALSE(reports.empty());
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const Progress& report = reports[i];
    CHECK(report.total == 32);
    CHECK(report.workers == 2);
    CHECK(report.busy_workers <= 2);
    REQUIRE(report.seasons.size() == 2);
    CHECK(report.seasons[0].season == "flat");
    CHECK(report.seasons[0].best >= report.seasons[0].median);
    if (i > 0) CHECK(report.evaluations > reports[i - 1].evaluations);
  }
  CHECK(reports.back().evaluations == 32);
  CHECK(reports.back().generation == 4);
}

}  // namespace plsc
