#include "runtime/scenario.h"

#include <catch2/catch.hpp>
#include <numbers>
#include <string>
#include <vector>

namespace plsc {

namespace {

const State kInclined = {"inclined", StateType::kBool, 0, 0, {}};
const State kTemperature = {"temperature", StateType::kReal, -40, 60, {}};
const State kGround = {"ground", StateType::kEnum, 0, 0, {"dry", "wet"}};

}  // namespace

TEST_CASE("The paper's scenario is Flat, then Tilted by 5 degrees",
          "[scenario]") {
  const Scenario paper = PaperScenario();
  REQUIRE(paper.seasons.size() == 2);
  const Season& flat = paper.seasons[0];
  CHECK(flat.terrain.type == TerrainType::kFlat);
  CHECK(flat.duration == 50);
  CHECK(flat.start_height == 0.03);
  CHECK(flat.senses.at("inclined") == "False");
  const Season& tilted = paper.seasons[1];
  CHECK(tilted.terrain.type == TerrainType::kTilted);
  CHECK(tilted.terrain.tilt == Approx(0.0872664626));
  CHECK(tilted.duration == 50);
  CHECK(tilted.start_height == 0.1);
  CHECK(tilted.senses.at("inclined") == "True");
}

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

TEST_CASE("The format's version is checked", "[scenario]") {
  CHECK(ParseScenario(Source("s", "plsc_scenario: 1\nseasons: [{}]\n")));
  CHECK(ParseScenario(Source("s", "seasons: [{}]\n")));
  const auto newer =
      ParseScenario(Source("s", "plsc_scenario: 2\nseasons: [{}]\n"));
  REQUIRE_FALSE(newer);
  CHECK(newer.diagnostics()[0].span == Span{15, 16});
}

}  // namespace plsc
