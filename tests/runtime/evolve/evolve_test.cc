#include "runtime/evolve/evolve.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/runtime/evolve/fake_run.h"

namespace plsc {

namespace {

using test::IdOf;
using test::Look;
using test::Recorder;
using test::SmallExperiment;

/// Slower for some than for others, so that answers overtake each other.
Evaluation LookSlowly(const Genotype& genotype) {
  usleep(static_cast<useconds_t>(IdOf(genotype) * 7919 % 5) * 500);
  return Look(genotype);
}

RunResult Record(const Experiment& experiment, int jobs, Evaluator evaluate,
                 Recorder& recorder) {
  EvolveOptions options;
  options.jobs = jobs;
  options.evaluate = std::move(evaluate);
  options.observers = {&recorder};
  return Evolve(experiment, options);
}

std::vector<int> Ids(const std::vector<Individual>& individuals) {
  std::vector<int> ids;
  for (const Individual& one : individuals) ids.push_back(one.id);
  return ids;
}

}  // namespace

TEST_CASE("A run shows everybody in order of id, and every generation",
          "[evolve]") {
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
    CHECK(FitnessesOf(one) == FitnessesOf({0, 0, {}, {}, Look(one.genotype)}));
  }
  CHECK(seen.generations.size() == 5);
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

TEST_CASE("The number of workers changes nothing", "[evolve]") {
  Recorder one;
  Recorder three;
  Record(SmallExperiment(), 1, Look, one);
  Record(SmallExperiment(), 3, LookSlowly, three);
  REQUIRE(one.individuals.size() == three.individuals.size());
  for (std::size_t i = 0; i < one.individuals.size(); ++i)
    CHECK(one.individuals[i].genotype == three.individuals[i].genotype);
  for (std::size_t g = 0; g < one.generations.size(); ++g)
    CHECK(one.generations[g].survivors == three.generations[g].survivors);
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
  // 4 % of first symbols are A1, and drift alone changes little of it.
  CHECK(mean(seen.generations.back().survivors) >
        2 * mean(seen.generations.front().survivors));
}

TEST_CASE("A run that is asked to stop ends with what has begun", "[evolve]") {
  Recorder seen;
  EvolveOptions options;
  options.jobs = 2;
  options.evaluate = LookSlowly;
  options.observers = {&seen};
  options.should_stop = [&] { return seen.individuals.size() >= 10; };
  const RunResult result = Evolve(SmallExperiment(), options);
  CHECK(result.ending == Ending::kStopped);
  CHECK(result.generations == 1);
  CHECK(seen.generations.size() == 1);
  CHECK(result.evaluations == static_cast<int>(seen.individuals.size()));
  CHECK(seen.individuals.size() >= 10);
  CHECK(seen.individuals.size() < 14);  // the generation was not completed
  for (std::size_t i = 0; i < seen.individuals.size(); ++i)
    CHECK(seen.individuals[i].id == static_cast<int>(i) + 1);
  CHECK(Ids(result.population) == seen.generations[0].survivors);
  CHECK(result.best);
}

TEST_CASE("A run that is stopped at once has no best", "[evolve]") {
  EvolveOptions options;
  options.jobs = 1;
  options.evaluate = Look;
  options.should_stop = [] { return true; };
  const RunResult result = Evolve(SmallExperiment(), options);
  CHECK(result.ending == Ending::kStopped);
  CHECK(result.generations == 0);
  CHECK(result.evaluations <= 1);
  CHECK_FALSE(result.best);
}

TEST_CASE("An observer that fails ends the run", "[evolve]") {
  Recorder seen;
  seen.failing_id = 5;
  const RunResult result = Record(SmallExperiment(), 2, Look, seen);
  CHECK(result.ending == Ending::kFailed);
  CHECK(result.failure == "the disk is full");
  CHECK(result.evaluations == 4);
}

TEST_CASE("Who kills its workers has no fitness, and the run goes on",
          "[evolve]") {
  Recorder seen;
  const auto deadly = [](const Genotype& genotype) {
    if (IdOf(genotype) == 5) raise(SIGKILL);
    return Look(genotype);
  };
  const RunResult result = Record(SmallExperiment(), 2, deadly, seen);
  CHECK(result.ending == Ending::kFinished);
  CHECK(result.evaluations == 32);
  const Evaluation& dead = seen.individuals[4].evaluation;
  REQUIRE(dead.seasons.size() == 2);
  for (const SeasonResult& season : dead.seasons) {
    CHECK(season.outcome == Outcome::kWorkerDied);
    CHECK_FALSE(season.fitness);
  }
  CHECK(seen.generations[0].counts[4] == 0);
}

TEST_CASE("Progress counts up to the whole run", "[evolve]") {
  std::vector<Progress> reports;
  EvolveOptions options;
  options.jobs = 2;
  options.evaluate = Look;
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
