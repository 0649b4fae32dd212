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

TEST_CASE("Everybody gets one verdict, twins share their simulations",
          "[judging]") {
  const LifePlanner planner(PaperScenario(), test::Look);
  Here workers(WorkOf(planner));
  Judging judging(planner, workers, {});
  std::vector<Individual> robots = Robots(10);
  robots.push_back(robots.front());
  judging.Begin(robots);
  CHECK(judging.outstanding() == 11);
  std::vector<int> seen(11, 0);
  std::vector<JudgedLife> lives(11);
  while (judging.outstanding() > 0)
    for (Verdict& verdict : judging.Wait(0)) {
      ++seen[verdict.robot];
      lives[verdict.robot] = std::move(verdict.life);
    }
  CHECK(seen == std::vector<int>(11, 1));
  CHECK(judging.counts().simulations == workers.submitted);
  CHECK(judging.counts().simulations + judging.counts().looked_up == 22);
  CHECK(judging.counts().looked_up >= 2);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(lives[0].evaluation.seasons[i].state_hash ==
          lives[10].evaluation.seasons[i].state_hash);
}

TEST_CASE("Those with an evaluation are not judged again", "[judging]") {
  const LifePlanner planner(PaperScenario(), test::Look);
  Here workers(WorkOf(planner));
  Judging judging(planner, workers, {});
  std::vector<Individual> robots = Robots(3);
  robots[1].evaluation.seasons.resize(2);
  judging.Begin(robots);
  CHECK(judging.outstanding() == 2);
  while (judging.outstanding() > 0)
    for (const Verdict& verdict : judging.Wait(0)) CHECK(verdict.robot != 1);
}

TEST_CASE("A death is an outcome, and the end of workers a failure",
          "[judging]") {
  const LifePlanner planner(PaperScenario(), test::Look);
  Here workers(WorkOf(planner));
  Judging judging(planner, workers, {});
  workers.is_deadly = true;
  const std::vector<Individual> robots = Robots(1);
  judging.Begin(robots);
  while (judging.outstanding() > 0)
    for (const Verdict& verdict : judging.Wait(0))
      CHECK(verdict.life.evaluation.seasons[1].outcome == Outcome::kWorkerDied);
  CHECK_FALSE(judging.failure());
  judging.Begin(robots);
  workers.Fail();
  CHECK(judging.Wait(0).empty());
  CHECK(judging.failure() == "no worker can be started");
}

}  // namespace plsc
