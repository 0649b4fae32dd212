#include "runtime/evolve/trials.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "runtime/evolve/breed.h"
#include "tests/runtime/evolve/fake_run.h"

namespace plsc {

namespace {

TrialPlan Noisy(int count) {
  TrialPlan plan{7, {}};
  plan.options.count = count;
  plan.options.noise = {30e-6, 0.1, 0.2, 0.01, 0.05, 0.03, 0.25};
  return plan;
}

}  // namespace

TEST_CASE("Fitness over trials", "[trials]") {
  using Values = std::vector<std::optional<double>>;
  const Values values = {3.0, 1.0, 2.0, 10.0};
  CHECK(FitnessOver(values, std::nullopt) == 4.0);
  CHECK(FitnessOver(values, 0.0) == 1.0);
  CHECK(FitnessOver(values, 0.5) == 2.5);
  CHECK(FitnessOver(values, 1.0) == 10.0);
  // R: quantile(c(3, 1, 2, 10), 0.25) is 1.75.
  CHECK(FitnessOver(values, 0.25) == 1.75);
  // What cannot move is still known by its number.
  CHECK(FitnessOver({-0.1, -0.1, -0.1}, std::nullopt) == -0.1);
  CHECK(FitnessOver({5.0, std::nullopt}, std::nullopt) == std::nullopt);
  CHECK(FitnessOver({5.0, std::nullopt}, 1.0) == std::nullopt);
}

TEST_CASE("Trials are drawn by what is lived, or by who lives it", "[trials]") {
  const LifePlanner planner(PaperScenario(), test::Look);
  Individual one = CreateFirst(test::SmallExperiment(), 1);
  Individual twin = one;
  twin.id = 2;
  TrialPlan plan = Noisy(20);
  const auto drawn = TrialsOf(plan, planner, one);
  REQUIRE(drawn.size() == 20);
  std::set<double> lifts;
  for (const Disturbances& life : drawn)
    for (const Disturbance& season : life) {
      lifts.insert(season.lift);
      CHECK(season.lift >= 0);
      CHECK(season.lift <= 30e-6);
      CHECK(std::abs(season.shift_x) <= 0.1);
      CHECK(std::abs(season.yaw) <= 0.2);
      CHECK(std::abs(season.lean) <= 0.01);
      CHECK(std::abs(season.friction - 1) <= 0.25);
      CHECK(season.touch.amplitude == 0.05);
      CHECK(season.motor.amplitude == 0.03);
    }
  CHECK(lifts.size() == 40);
  CHECK(TrialsOf(plan, planner, twin) == drawn);
  plan.seed = 8;
  CHECK(TrialsOf(plan, planner, one) != drawn);
  plan.options.own_lives = true;
  CHECK(TrialsOf(plan, planner, twin) != TrialsOf(plan, planner, one));
  CHECK(TrialsOf(plan, planner, one) == TrialsOf(plan, planner, one));
  // No noise, no disturbance; and more of one kind leaves the others.
  CHECK(TrialsOf({}, planner, one) == std::vector<Disturbances>{{}});
  TrialPlan few = Noisy(20);
  few.options.noise.motor = 0;
  few.options.noise.inclination = 0;
  TrialPlan fewer = few;
  fewer.options.noise.friction = 0;
  CHECK(TrialsOf(few, planner, one)[3][1].lift ==
        TrialsOf(fewer, planner, one)[3][1].lift);
}

TEST_CASE("A robot that breaks in one trial has no fitness", "[trials]") {
  EvaluatedLife fine;
  fine.evaluation.seasons.resize(1);
  fine.evaluation.seasons[0].fitness = 2;
  fine.evidence.resize(1);
  EvaluatedLife broken = fine;
  broken.evaluation.seasons[0].fitness.reset();
  broken.evaluation.seasons[0].outcome = Outcome::kUnstable;
  broken.evaluation.seasons[0].reason = "torn";
  const TrialOptions options = Noisy(2).options;
  const std::vector<Disturbances> none(2);
  const SeasonResult both =
      OverTrials({fine, fine}, none, options).evaluation.seasons[0];
  CHECK(both.fitness == 2.0);
  CHECK(both.outcome == Outcome::kCompleted);
  const EvaluatedLife one = OverTrials({fine, broken}, none, options);
  CHECK_FALSE(one.evaluation.seasons[0].fitness);
  CHECK(one.evaluation.seasons[0].outcome == Outcome::kUnstable);
  CHECK(one.evaluation.seasons[0].reason == "in trial 2 of 2: torn");
  REQUIRE(one.evidence[0].trials.size() == 2);
  CHECK(one.evidence[0].trials[0].result.fitness == 2.0);
}

namespace {

test::Recorder Recorded(const Experiment& experiment, int jobs) {
  test::Recorder recorder;
  EvolveOptions options;
  options.jobs = jobs;
  options.simulate = test::Look;
  options.observers = {&recorder};
  CHECK(Evolve(experiment, options).ending == Ending::kFinished);
  return recorder;
}

}  // namespace

TEST_CASE("Runs with trials do not depend on the number of workers",
          "[trials]") {
  for (const bool own : {false, true}) {
    Experiment experiment = test::SmallExperiment();
    experiment.trials = Noisy(3).options;
    experiment.trials.own_lives = own;
    const test::Recorder one = Recorded(experiment, 1);
    const test::Recorder three = Recorded(experiment, 3);
    CHECK(one.generations == three.generations);
    for (std::size_t i = 0; i < one.evidence.size(); ++i)
      for (std::size_t s = 0; s < one.evidence[i].size(); ++s) {
        const auto& a = one.evidence[i][s].trials;
        const auto& b = three.evidence[i][s].trials;
        REQUIRE(a.size() == 3);
        REQUIRE(b.size() == 3);
        for (std::size_t t = 0; t < 3; ++t) {
          CHECK(a[t].disturbance == b[t].disturbance);
          CHECK(a[t].evidence.simulation == b[t].evidence.simulation);
          CHECK(a[t].result.state_hash == b[t].result.state_hash);
        }
      }
  }
}

TEST_CASE("Own lives are never looked up", "[trials]") {
  Experiment experiment = test::SmallExperiment();
  experiment.trials.own_lives = true;
  EvolveOptions options;
  options.jobs = 1;
  options.simulate = test::Look;
  const RunResult result = Evolve(experiment, options);
  CHECK(result.counts_of_work.looked_up == 0);
  CHECK(result.counts_of_work.simulations > 2 * 20);
}

}  // namespace plsc
