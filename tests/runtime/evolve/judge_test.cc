#include "runtime/evolve/judge.h"

#include <catch2/catch.hpp>

#include "compiler/print.h"
#include "tests/runtime/evolve/fake_run.h"

namespace plsc {

TEST_CASE("A worker judges the genotype that was sent", "[judge]") {
  Rng rng({31, 0, 0, Purpose::kInitialise});
  Genotype sent = Initialise({}, rng);
  sent.name = "robot_1";
  const Work work = JudgeWith([&](const Genotype& received) {
    CHECK(received == sent);
    return test::Look(received);
  });
  const Evaluation evaluation = EvaluationOf({1, work(Print(sent)), ""}, {});
  REQUIRE(evaluation.seasons.size() == 2);
  CHECK(evaluation.seasons[0].fitness == test::Look(sent).seasons[0].fitness);
}

TEST_CASE("A death is an outcome of every season", "[judge]") {
  const Evaluation evaluation =
      EvaluationOf({1, std::nullopt, "signal 11"}, PaperScenario().seasons);
  REQUIRE(evaluation.seasons.size() == 2);
  CHECK(evaluation.seasons[0].season == "flat");
  CHECK(evaluation.seasons[1].outcome == Outcome::kWorkerDied);
  CHECK_FALSE(evaluation.seasons[1].fitness);
}

}  // namespace plsc
