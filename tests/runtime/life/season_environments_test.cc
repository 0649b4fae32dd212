#include "runtime/life/season_environments.h"

#include <catch2/catch.hpp>

#include "runtime/scenario/scenario_profile.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

using Environments = std::vector<NamedEnvironment>;

constexpr const char* kPlasticRobot =
    "sense hot: bool\nsense inclined: bool\niterations 1\n"
    "rule C -> if inclined = False then { C add_front B }\n"
    "rule C -> if inclined = True and hot = True then { C add_left B }\n";

// hot, inclined
const Environment kLevel{{0, 0}};
const Environment kSlope{{0, 1}};
const Environment kHotSlope{{1, 1}};

Scenario Hills() {
  Scenario scenario = PaperScenario();
  scenario.seasons.push_back(scenario.seasons[1]);
  scenario.seasons[2].name = "desert";
  scenario.seasons[2].senses["hot"] = "True";
  return scenario;
}

TEST_CASE("Seasons are environments, by what is felt and what is told",
          "[season_environments]") {
  const Genotype genotype = test::Robot(kPlasticRobot);
  const Environments expected = {
      {"flat", kLevel}, {"tilted", kSlope}, {"desert", kHotSlope}};
  CHECK(SeasonEnvironments(genotype, Hills()) == expected);
  CHECK(PossibleEnvironments(genotype, Hills()) == expected);
}

TEST_CASE("Who develops at birth has one environment",
          "[season_environments]") {
  Scenario scenario = Hills();
  scenario.plasticity = Plasticity::kMorphogenesis;
  for (const NamedEnvironment& one :
       PossibleEnvironments(test::Robot(kPlasticRobot), scenario))
    CHECK(one.environment == kLevel);
}

TEST_CASE("Who lives on may feel otherwise where it has come to",
          "[season_environments]") {
  Scenario scenario = Hills();
  scenario.lives = Lives::kContinuous;
  const Genotype genotype = test::Robot(kPlasticRobot);
  CHECK(PossibleEnvironments(genotype, scenario) ==
        Environments{{"flat", kLevel},
                     {"tilted, level", kLevel},
                     {"desert, level", {{1, 0}}},
                     {"tilted, inclined", kSlope},
                     {"desert, inclined", kHotSlope}});
  // Nothing is felt where the season tells it.
  scenario.seasons[1].senses["inclined"] = "True";
  CHECK(PossibleEnvironments(genotype, scenario).size() == 4);
}

}  // namespace
}  // namespace plsc
