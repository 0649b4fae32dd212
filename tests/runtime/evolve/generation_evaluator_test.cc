#include "runtime/evolve/generation_evaluator.h"

#include <catch2/catch.hpp>

#include "runtime/evolve/breed.h"
#include "runtime/evolve/worker_request.h"
#include "tests/runtime/evolve/fake_run.h"
#include "tests/runtime/workers/here.h"

namespace plsc {

using test::Here;

namespace {

std::vector<Individual> Robots(int count) {
  std::vector<Individual> robots;
  for (int id = 1; id <= count; ++id)
    robots.push_back(CreateFirst(test::SmallExperiment(), id));
  return robots;
}

}  // namespace

TEST_CASE("Everybody is evaluated once, twins share their simulations",
          "[generation_evaluator]") {
  const LifePlanner planner(PaperScenario(), test::Look);
  Here workers(WorkOf(planner));
  GenerationEvaluator evaluator(planner, workers, {});
  std::vector<Individual> robots = Robots(10);
  robots.push_back(robots.front());
  evaluator.Begin(robots);
  CHECK(evaluator.outstanding() == 11);
  std::vector<int> seen(11, 0);
  std::vector<EvaluatedLife> lives(11);
  while (evaluator.outstanding() > 0)
    for (EvaluatedRobot& one : evaluator.Wait(0)) {
      ++seen[one.robot];
      lives[one.robot] = std::move(one.life);
    }
  CHECK(seen == std::vector<int>(11, 1));
  CHECK(evaluator.counts().simulations == workers.submitted);
  CHECK(evaluator.counts().simulations + evaluator.counts().looked_up == 22);
  CHECK(evaluator.counts().looked_up >= 2);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(lives[0].evaluation.seasons[i].state_hash ==
          lives[10].evaluation.seasons[i].state_hash);
}

TEST_CASE("Twins that are disturbed otherwise live otherwise",
          "[generation_evaluator]") {
  const LifePlanner planner(PaperScenario(), test::Look);
  Here workers(WorkOf(planner));
  GenerationEvaluator evaluator(planner, workers, {});
  std::vector<Individual> robots(4, Robots(1)[0]);
  robots[1].disturbances.resize(2);
  robots[1].disturbances[0].lift = 0.1;
  robots[2].disturbances = robots[1].disturbances;
  evaluator.Begin(robots);
  std::vector<EvaluatedLife> lives(4);
  while (evaluator.outstanding() > 0)
    for (EvaluatedRobot& one : evaluator.Wait(0))
      lives[one.robot] = std::move(one.life);
  const auto hash = [&](std::size_t robot, std::size_t season) {
    return lives[robot].evaluation.seasons[season].state_hash;
  };
  CHECK(hash(0, 0) != hash(1, 0));
  CHECK(hash(0, 1) == hash(1, 1));
  CHECK(hash(1, 0) == hash(2, 0));
  CHECK(hash(0, 0) == hash(3, 0));
  CHECK(evaluator.counts().simulations == 3);
  CHECK(evaluator.counts().looked_up == 5);
}

TEST_CASE("Those with an evaluation are not evaluated again",
          "[generation_evaluator]") {
  const LifePlanner planner(PaperScenario(), test::Look);
  Here workers(WorkOf(planner));
  GenerationEvaluator evaluator(planner, workers, {});
  std::vector<Individual> robots = Robots(3);
  robots[1].evaluation.seasons.resize(2);
  evaluator.Begin(robots);
  CHECK(evaluator.outstanding() == 2);
  while (evaluator.outstanding() > 0)
    for (const EvaluatedRobot& one : evaluator.Wait(0)) CHECK(one.robot != 1);
}

TEST_CASE("A death is an outcome, and the end of workers a failure",
          "[generation_evaluator]") {
  const LifePlanner planner(PaperScenario(), test::Look);
  Here workers(WorkOf(planner));
  GenerationEvaluator evaluator(planner, workers, {});
  workers.is_deadly = true;
  const std::vector<Individual> robots = Robots(1);
  evaluator.Begin(robots);
  while (evaluator.outstanding() > 0)
    for (const EvaluatedRobot& one : evaluator.Wait(0))
      CHECK(one.life.evaluation.seasons[1].outcome == Outcome::kWorkerDied);
  CHECK_FALSE(evaluator.failure());
  evaluator.Begin(robots);
  workers.Fail();
  CHECK(evaluator.Wait(0).empty());
  CHECK(evaluator.failure() == "no worker can be started");
}

}  // namespace plsc
