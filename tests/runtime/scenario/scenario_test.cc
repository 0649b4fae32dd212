#include "runtime/scenario/scenario.h"
#include "runtime/scenario/scenario_yaml.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace plsc {

namespace {

const State kInclined = {"inclined", StateType::kBool, 0, 0, {}};
const State kTemperature = {"temperature", StateType::kReal, -40, 60, {}};
const State kGround = {"ground", StateType::kEnum, 0, 0, {"dry", "wet"}};

}  // namespace

TEST_CASE("A robot senses its states in the season", "[scenario]") {
  Season season;
  season.name = "summer";
  season.senses = {{"inclined", "True"},
                   {"temperature", "30.5"},
                   {"ground", "wet"},
                   {"unasked", "1"}};
  const auto sensed = Sense(season, {kGround, kInclined, kTemperature});
  REQUIRE(sensed);
  CHECK(sensed->values == std::vector<double>{1, 1, 30.5});
  CHECK(Sense(season, {})->values.empty());
}

TEST_CASE("Every state that the season does not answer is an error",
          "[scenario]") {
  Season season;
  season.name = "summer";
  season.senses = {{"inclined", "1"}, {"temperature", "90"}};
  const auto sensed = Sense(season, {kInclined, kTemperature, kGround});
  REQUIRE_FALSE(sensed);
  REQUIRE(sensed.diagnostics().size() == 3);
  CHECK(sensed.diagnostics()[0].message ==
        "season 'summer': expected True or False for state 'inclined', found "
        "'1'");
  CHECK(sensed.diagnostics()[1].message ==
        "season 'summer': expected a number in -40..60 for state "
        "'temperature', found '90'");
  CHECK(sensed.diagnostics()[2].message ==
        "season 'summer': expected one of dry, wet for state 'ground', found "
        "nothing");
  CHECK(sensed.diagnostics()[2].help ==
        "add 'ground' to the senses of the season");
}

TEST_CASE("What a robot feels counts where the season says nothing",
          "[scenario]") {
  Season season;
  season.name = "slope";
  const auto felt = Sense(season, {kInclined}, {{"inclined", "True"}});
  REQUIRE(felt);
  CHECK(felt->values == std::vector<double>{1});
  season.senses = {{"inclined", "False"}};
  CHECK(Sense(season, {kInclined}, {{"inclined", "True"}})->values ==
        std::vector<double>{0});
}

TEST_CASE("Only a bool called inclined can be felt, and only by an IMU",
          "[scenario]") {
  Scenario scenario;
  Season season;
  season.name = "summer";
  scenario.seasons = {season};
  const State hot = {"hot", StateType::kBool, 0, 0, {}};
  const State slope = {"inclined", StateType::kReal, 0, 90, {}};
  CHECK(CheckSenses(scenario, {kInclined}).empty());
  CHECK(CheckSenses(scenario, {slope}).size() == 1);
  const auto errors = CheckSenses(scenario, {kInclined, hot});
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].message ==
        "season 'summer': expected True or False for state 'hot', found "
        "nothing");
  scenario.sensing = Sensing::kGiven;
  CHECK(CheckSenses(scenario, {kInclined}).size() == 1);
  scenario.seasons[0].senses = {{"inclined", "True"}};
  CHECK(CheckSenses(scenario, {kInclined}).empty());
}

TEST_CASE("The format's version is checked", "[scenario]") {
  CHECK(ParseScenario(Source("s", "plsc_scenario: 1\nseasons: [{}]\n")));
  CHECK(ParseScenario(Source("s", "seasons: [{}]\n")));
  const auto newer =
      ParseScenario(Source("s", "plsc_scenario: 2\nseasons: [{}]\n"));
  REQUIRE_FALSE(newer);
  CHECK(newer.diagnostics()[0].span == Span{15, 16});
}

}  // namespace plsc
