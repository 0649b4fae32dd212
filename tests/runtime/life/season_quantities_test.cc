#include "runtime/life/season_quantities.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <random>

#include "runtime/formula/quantities.h"
#include "runtime/formula/read_formula.h"
#include "runtime/life/evaluation.h"
#include "runtime/life/life_plan.h"
#include "runtime/life/season_developer.h"
#include "runtime/scenario/scenario_fitness.h"
#include "runtime/scenario/scenario_profile.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

const char* const kRobot =
    "sense inclined: bool\n"
    "iterations 1\n"
    "rule C -> if inclined = False then { C add_front A2(0.5, 4, 2, 1) "
    "move_front add_front B }\n"
    "rule C -> if inclined = True then { C add_left B add_right B }\n";

Scenario Short(const char* fitness) {
  Scenario scenario = BothSeasons(Profile::kSwift);
  for (Season& season : scenario.seasons) {
    season.duration = 1;
    season.fitness = *ReadFormula(fitness);
  }
  return scenario;
}

std::uint64_t Bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

TEST_CASE("The default as a formula has the program's bits", "[fitness]") {
  const std::uint32_t seed = 11;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::vector<double> values(Quantities().size(), 0);
  double& speed = values[*FindQuantity("speed")];
  double& hinges = values[*FindQuantity("hinge_count")];
  const double special[] = {0, -0.0, 5e-324, -5e-324, 50, -50, 1e-17};
  for (int i = 0; i < 20000; ++i) {
    speed = i % 4 == 0 ? special[random() % 7]
                       : std::ldexp(static_cast<double>(random()) - 2e9,
                                    -static_cast<int>(random() % 80));
    hinges = static_cast<double>(random() % 3);
    const FormulaValue value = DefaultFitness().Evaluate(values);
    REQUIRE(value.problem == nullptr);
    REQUIRE(Bits(value.value) ==
            Bits(SeasonFitness(speed, static_cast<int>(hinges))));
  }
}

TEST_CASE("Formulas see what is known of the season", "[fitness]") {
  const Scenario scenario = Short("final_y");
  const Evaluation evaluation = Evaluate(test::Robot(kRobot), scenario);
  for (std::size_t i = 0; i < 2; ++i) {
    const SeasonResult& result = evaluation.seasons[i];
    REQUIRE(result.outcome == Outcome::kCompleted);
    const auto of = [&](const char* name) {
      return QuantitiesOf(result, scenario.seasons[i])[*FindQuantity(name)];
    };
    CHECK(of("speed") == result.behaviour.displacement_velocity_hill);
    CHECK(of("hinge_count") == result.body.hinge_count);
    CHECK(of("recurrence") == result.brain.recurrence);
    CHECK(of("energy") == result.behaviour.energy);
    CHECK(std::isnan(of("target_distance")));
    CHECK(of("duration") == Approx(1));
    CHECK(of("path") == Approx(result.behaviour.velocity));
    CHECK(of("displacement") == Approx(result.behaviour.displacement_velocity));
    CHECK(result.fitness == result.behaviour.final_y);
  }
}

TEST_CASE("What comes to no number is an outcome", "[fitness]") {
  const Genotype genotype = test::Robot(kRobot);
  const Scenario scenario = Short("1 / hinge_count");
  const Evaluation evaluation = Evaluate(genotype, scenario);
  CHECK(evaluation.seasons[0].fitness == 1);
  const SeasonResult& none = evaluation.seasons[1];
  CHECK(none.outcome == Outcome::kUndefinedFitness);
  CHECK(none.reason == "division by 0 in '1 / hinge_count'");
  CHECK_FALSE(none.fitness);
  CHECK(none.behaviour.is_valid);
  // What was simulated was completed, whatever it is worth.
  CHECK(SimulatedOf(none).outcome == Outcome::kCompleted);
  CHECK(SimulatedOf(none).reason.empty());
}

TEST_CASE("Who has no fitness lives on all the same", "[fitness]") {
  const Genotype genotype = test::Robot(kRobot);
  Scenario scenario = Short("1 / (hinge_count - 1)");
  scenario.lives = Lives::kContinuous;
  const Evaluation evaluation = Evaluate(genotype, scenario);
  CHECK(evaluation.seasons[0].outcome == Outcome::kUndefinedFitness);
  CHECK(evaluation.seasons[1].outcome == Outcome::kCompleted);
  // As planned and put together.
  const LifePlanner planner(scenario);
  std::vector<std::optional<Simulated>> simulated(2);
  for (const LifePiece& piece : planner.Plan(genotype, {})) {
    const std::vector<Simulated> lived = planner.Simulate(genotype, {}, piece);
    for (std::size_t i = 0; i < lived.size(); ++i) {
      CHECK(lived[i].outcome == Outcome::kCompleted);
      simulated[piece.first + i] = lived[i];
    }
  }
  const Evaluation planned =
      planner.Assemble(genotype, {}, simulated).evaluation;
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(planned.seasons[i].outcome == evaluation.seasons[i].outcome);
    CHECK(planned.seasons[i].reason == evaluation.seasons[i].reason);
    CHECK(planned.seasons[i].fitness == evaluation.seasons[i].fitness);
  }
}

TEST_CASE("What a season is worth is not in the keys of its simulation",
          "[fitness]") {
  const Genotype genotype = test::Robot(kRobot);
  for (const Lives lives : {Lives::kIndependent, Lives::kContinuous}) {
    Scenario other = Short("energy");
    other.lives = lives;
    Scenario plain = WithoutFitness(other);
    const auto keys = [&](const Scenario& scenario) {
      std::vector<Key> all;
      for (const LifePiece& piece : LifePlanner(scenario).Plan(genotype, {}))
        all.insert(all.end(), piece.keys.begin(), piece.keys.end());
      return all;
    };
    CHECK(keys(other) == keys(plain));
    // The distance to targets is kept with it.
    Scenario aimed = plain;
    aimed.targets = {{1, 2}};
    CHECK(keys(aimed) != keys(plain));
  }
}

}  // namespace
}  // namespace plsc
