#include "runtime/scenario/scenario_yaml.h"

#include <catch2/catch.hpp>
#include <numbers>

#include "runtime/scenario/scenario_profile.h"
#include "tests/runtime/service/asked.h"

namespace plsc {
namespace {

using test::OrderedJson;

Scenario ReadBack(const OrderedJson& answer) {
  INFO(answer.dump());
  REQUIRE(answer["ok"] == true);
  const auto scenario =
      ParseScenario(Source("y", answer["yaml"].get<std::string>()));
  REQUIRE(scenario);
  return *scenario;
}

TEST_CASE("a scenario is answered with every constant", "[service]") {
  const OrderedJson usual = test::Answered({{"ask", "scenario"}});
  CHECK(ReadBack(usual) == BothSeasons(Profile::kSwift));
  const OrderedJson& seasons = usual["controls"]["seasons"];
  REQUIRE(seasons.size() == 2);
  CHECK(seasons[0]["slope"] == 0.0);
  CHECK(seasons[1]["slope"] == 5.0);
  CHECK(seasons[0]["friction"] == 1.0);
  CHECK(seasons[0]["duration"] == 50.0);
  CHECK(seasons[0]["senses"]["hot"] == "False");
  CHECK(seasons[0]["engine"] == "articulated");

  const OrderedJson swift = test::Answered(
      {{"ask", "scenario"},
       {"scenario",
        "plsc_scenario: 1\nseasons:\n  - {terrain: {rough: {seed: 3}}}\n"},
       {"engine", "articulated"}});
  CHECK(swift["controls"]["seasons"][0]["slope"].is_null());
  CHECK(swift["controls"]["seasons"][0]["engine"] == "articulated");
  CHECK(ReadBack(swift).seasons[0].terrain.rough.seed == 3);
}

TEST_CASE("settings are set in one season or in all", "[service]") {
  const OrderedJson answer =
      test::Answered({{"ask", "scenario"},
                      {"set",
                       {{{"friction", 0.5}, {"duration", 20}},
                        {{"season", "flat"},
                         {"slope", 7.5},
                         {"senses", {{"hot", "True"}, {"wet", "False"}}}},
                        {{"season", "tilted"},
                         {"slope", 0},
                         {"senses", {{"hot", nullptr}}}}}}});
  const Scenario scenario = ReadBack(answer);
  Scenario expected = BothSeasons(Profile::kSwift);
  for (Season& season : expected.seasons) {
    season.physics.friction = 0.5;
    season.duration = 20;
  }
  expected.seasons[0].terrain.type = TerrainType::kTilted;
  expected.seasons[0].terrain.tilt = 7.5 * std::numbers::pi / 180;
  expected.seasons[0].senses = {{"hot", "True"}, {"wet", "False"}};
  expected.seasons[1].terrain = {};
  expected.seasons[1].senses = {};
  CHECK(scenario == expected);
  // What is answered may be asked with again.
  const OrderedJson again =
      test::Answered({{"ask", "scenario"}, {"scenario", answer["yaml"]}});
  CHECK(again["yaml"] == answer["yaml"]);
  CHECK(again["controls"] == answer["controls"]);
}

TEST_CASE("what no file may say cannot be set", "[service]") {
  const auto words = [](const OrderedJson& change) {
    return test::WordsOf(
        {{"ask", "scenario"}, {"set", OrderedJson::array({change})}});
  };
  CHECK(words({{"season", "night"}, {"slope", 1}}) ==
        "the scenario has no season of that name");
  CHECK(words({{"wind", 3}}) ==
        "expected slope, friction, duration or senses to be set, not 'wind'");
  CHECK(words({{"friction", "high"}}) == "expected 'friction' to be a number");
  CHECK(words({{"senses", {{"hot", 1}}}}) ==
        "expected values of 'senses' to be texts, or null");
  CHECK(words("steep") == "expected 'set' to be a list of objects");
  for (const OrderedJson& change :
       {OrderedJson({{"friction", -1}}), OrderedJson({{"duration", 1e300}}),
        OrderedJson({{"slope", 1e300}}), OrderedJson({{"duration", 0}}),
        OrderedJson({{"senses", {{"hot", "true"}}}})})
    CHECK(words(change).starts_with("P"));
}

}  // namespace
}  // namespace plsc
