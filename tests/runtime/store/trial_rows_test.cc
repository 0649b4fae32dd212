#include "runtime/store/trial_rows.h"

#include <catch2/catch.hpp>

#include "runtime/evolve/generation_evaluator.h"
#include "runtime/evolve/worker_request.h"
#include "runtime/store/result_dump.h"
#include "runtime/store/run_store.h"
#include "runtime/store/salvage.h"
#include "runtime/store/verify.h"
#include "tests/runtime/evolve/fake_run.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

Experiment Tried(EngineKind engine) {
  Experiment experiment = test::SmallExperiment();
  experiment.generations = 2;
  experiment.trials.count = 3;
  experiment.trials.noise.start_height = 1e-4;
  experiment.trials.noise.motor = 0.05;
  for (Season& season : experiment.scenario.seasons) season.duration = 0.2;
  CHECK_FALSE(SetEngine(experiment.scenario, engine));
  return experiment;
}

/// Until `stop` robots are evaluated, and then on to the end.
void RunInto(const std::string& path, const Experiment& experiment, int jobs,
             std::int64_t stop) {
  std::int64_t evaluated = 0;
  EvolveOptions options;
  options.jobs = jobs;
  options.on_progress = [&](const Progress& now) {
    evaluated = now.evaluations;
  };
  options.should_stop = [&] { return stop > 0 && evaluated >= stop; };
  {
    RunStore store;
    REQUIRE_FALSE(store.Create(path, experiment));
    options.observers = {&store};
    options.caches = {&store};
    Evolve(experiment, options);
    REQUIRE_FALSE(store.Close());
  }
  if (stop == 0) return;
  RunStore store;
  REQUIRE_FALSE(store.Open(path));
  auto saved = store.Load();
  REQUIRE(saved);
  options.saved = std::move(*saved);
  options.should_stop = {};
  options.observers = {&store};
  options.caches = {&store};
  CHECK(Evolve(experiment, options).ending == Ending::kFinished);
  REQUIRE_FALSE(store.Close());
}

}  // namespace

TEST_CASE("Trials are stored the same by any workers, after any stop",
          "[trial_rows]") {
  for (const EngineKind engine : {EngineKind::kOde, EngineKind::kArticulated}) {
    const Experiment experiment = Tried(engine);
    const test::Scratch scratch;
    const std::string one = scratch / "one.sqlite";
    const std::string two = scratch / "two.sqlite";
    RunInto(one, experiment, 1, 0);
    RunInto(two, experiment, 2, 5);
    CHECK_FALSE(Examine(one).problem);
    const auto dump = DumpResults(one);
    REQUIRE(dump);
    CHECK(*DumpResults(two) == *dump);

    RunStore store;
    REQUIRE_FALSE(store.OpenForReading(one));
    const auto trials = store.TrialsOf(3);
    REQUIRE(trials);
    REQUIRE(trials->size() == 2);
    CHECK((*trials)[0].size() == 3);
    // Its first life again is the life that is stored, to the last bit.
    const auto first = store.FindFirstLife(3);
    REQUIRE(first);
    REQUIRE(first->disturbances.size() == 2);
    CHECK(first->disturbances[0].lift > 0);
    const LifePlanner planner(experiment.scenario);
    for (const LifePiece& piece : planner.Plan(
             first->genotype, first->heritage.senses, first->disturbances)) {
      const Simulated again =
          planner.Simulate(first->genotype, first->heritage.senses, piece,
                           first->disturbances)[0];
      CHECK(again.state_hash ==
            first->evaluation.seasons[piece.first].state_hash);
    }
    Salvage salvage;
    REQUIRE_FALSE(salvage.Open(one));
    for (const auto& season : *trials)
      for (const StoredTrial& trial : season)
        CHECK((trial.simulation == Key{} || salvage.Find(trial.simulation)));
  }
}

TEST_CASE("A trial that was changed is damage", "[trial_rows]") {
  const Experiment experiment = Tried(EngineKind::kArticulated);
  for (const char* sql :
       {"UPDATE trial SET lift = 0 WHERE individual = 3 AND number = 2",
        "DELETE FROM trial WHERE individual = 3 AND number = 3"}) {
    const test::Scratch scratch;
    const std::string path = scratch / "run.sqlite";
    RunInto(path, experiment, 1, 0);
    {
      Database database;
      REQUIRE_FALSE(database.Open(path, Database::Mode::kWrite));
      database.Run(sql);
      REQUIRE_FALSE(database.TakeFailure());
    }
    const Health health = Examine(path);
    REQUIRE(health.problem);
    CHECK_THAT(health.problem->text, Catch::Contains("robot 3"));
  }
}

}  // namespace plsc
