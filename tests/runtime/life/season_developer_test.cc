#include "runtime/life/season_developer.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "runtime/develop/develop.h"
#include "runtime/life/simulated.h"
#include "runtime/scenario/scenario_profile.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {

namespace {

constexpr const char* kPlasticSeasons =
    "sense inclined: bool\n"
    "iterations 1\n"
    "rule C -> if inclined = False then { C add_front A2(0.5, 4, 2, 1) "
    "move_front add_front B }\n"
    "rule C -> if inclined = True then { C add_left B add_right B }\n";

// Felt on both sides of the threshold of 2.5 degrees, rad.
constexpr double kLevelSeason = 0;
constexpr double kSlopeSeason = 0.087;

}  // namespace

TEST_CASE("A season is developed from what is felt", "[season_developer]") {
  const Genotype genotype = test::Robot(kPlasticSeasons);
  const Scenario scenario = PaperScenario();
  const Senses nothing;
  SeasonDeveloper seasons(genotype, scenario, nothing);
  REQUIRE(seasons.AsksImu());
  const DevelopedSeason flat = seasons.Next(0, kLevelSeason);
  CHECK(flat.result.season == "flat");
  CHECK(flat.result.sensed ==
        std::vector<SensedState>{{"inclined", "False", SenseSource::kImu}});
  CHECK(flat.result.body.absolute_size == 3);
  CHECK(flat.result.change == Change::kBorn);
  const DevelopedSeason tilted = seasons.Next(50, kSlopeSeason);
  CHECK(tilted.result.begin == 50);
  CHECK(tilted.result.sensed[0].value == "True");
  CHECK(tilted.result.change == Change::kBody);
  CHECK(tilted.result.change_reason == "inclined False -> True (IMU 5.0 deg)");
  CHECK(tilted.robot == Develop(genotype, EnvironmentOf(tilted.result.sensed,
                                                        genotype.states)));
  CHECK(seasons.is_over());
}

TEST_CASE("Robots that develop at birth only keep body and brain",
          "[season_developer]") {
  const Genotype genotype = test::Robot(kPlasticSeasons);
  Scenario scenario = PaperScenario();
  scenario.plasticity = Plasticity::kMorphogenesis;
  const Senses nothing;
  SeasonDeveloper seasons(genotype, scenario, nothing);
  const DevelopedSeason flat = seasons.Next(0, kLevelSeason);
  CHECK_FALSE(seasons.AsksImu());
  const DevelopedSeason tilted = seasons.Next(0, std::nullopt);
  CHECK(tilted.robot == flat.robot);
  CHECK(tilted.result.change == Change::kNone);
  CHECK(tilted.result.change_reason == "developed at birth");
  CHECK(tilted.result.sensed == flat.result.sensed);
}

TEST_CASE("What is inherited goes before the senses of the first season",
          "[season_developer]") {
  const Genotype genotype = test::Robot(kPlasticSeasons);
  const Scenario scenario = PaperScenario();
  const Senses inherited = {{"inclined", "True"}};
  SeasonDeveloper seasons(genotype, scenario, inherited);
  CHECK_FALSE(seasons.AsksImu());
  const DevelopedSeason flat = seasons.Next(0, std::nullopt);
  CHECK(flat.result.sensed ==
        std::vector<SensedState>{{"inclined", "True", SenseSource::kParent}});
  CHECK(flat.result.change_reason == "inclined=True (parent)");
  CHECK(flat.result.body.brick_count == 2);
  // Later it senses for itself.
  REQUIRE(seasons.AsksImu());
  CHECK(seasons.Next(0, kLevelSeason).result.change == Change::kBody);
}

TEST_CASE("Where nothing develops the outcome says so", "[season_developer]") {
  const Genotype genotype = test::Robot(
      "iterations 12\nrule C -> { C add_front B }\n"
      "rule B -> { B add_front B add_left B add_right B }\n");
  const Scenario scenario = PaperScenario();
  const Senses nothing;
  SeasonDeveloper seasons(genotype, scenario, nothing);
  const DevelopedSeason developed = seasons.Next(0, std::nullopt);
  CHECK_FALSE(developed.robot);
  CHECK(developed.result.outcome == Outcome::kUndeveloped);
  CHECK(developed.result.body.absolute_size == 0);
  CHECK(seasons.Skip().outcome == Outcome::kNotReached);
}

TEST_CASE("Developed and simulated make a result, and come apart again",
          "[season_developer]") {
  SeasonResult developed;
  developed.season = "flat";
  developed.body.hinge_count = 2;
  developed.inclination = 0.25;
  Simulated simulated;
  simulated.begin = 50;
  simulated.inclination = 0.25;
  simulated.behaviour.is_valid = true;
  simulated.behaviour.displacement_velocity_hill = -0.02;
  simulated.state_hash = 7;
  simulated.steps = 100;
  simulated.solver_warnings = 1;
  const SeasonResult result = Complete(developed, simulated, Season{});
  CHECK(result.fitness == Approx(-0.002));
  CHECK(result.begin == 50);
  const Simulated again = SimulatedOf(result);
  CHECK(again.inclination == 0.25);
  CHECK(again.state_hash == 7);
  CHECK(again.steps == 100);
  CHECK(again.solver_warnings == 1);
  simulated.outcome = Outcome::kUnstable;
  simulated.reason = "too fast";
  CHECK_FALSE(Complete(developed, simulated, Season{}).fitness);
  CHECK(Complete(developed, simulated, Season{}).reason == "too fast");
}

}  // namespace plsc
