#include "runtime/life/season_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace plsc {
namespace {

Genotype Robot() {
  Genotype robot;
  robot.name = "robot";
  robot.states = {{"inclined", StateType::kBool, 0, 0, {}},
                  {"hot", StateType::kBool, 0, 0, {}},
                  {"heat", StateType::kReal, -40, 60, {}}};
  return robot;
}

TEST_CASE("a season that was not lived has no behaviour and no fitness",
          "[season_json]") {
  SeasonResult result;
  result.season = "flat";
  result.outcome = Outcome::kOverlapping;
  const auto json = nlohmann::json::parse(SeasonJson(Robot(), result));
  CHECK(json["genotype"] == "robot");
  CHECK(json["outcome"] == "overlapping");
  CHECK(json["fitness"].is_null());
  CHECK(json["behaviour"].is_null());
  // Without a robot there is nothing to describe.
  CHECK(json["body_descriptors"].is_null());
  CHECK(json["brain_descriptors"].is_null());
}

TEST_CASE("a season tells what was sensed and what changed", "[season_json]") {
  SeasonResult result;
  result.profile = Profile::kPublished;
  result.begin = 50;
  result.sensed = {{"inclined", "True", SenseSource::kImu},
                   {"hot", "False", SenseSource::kSeason},
                   {"heat", "30.5", SenseSource::kParent}};
  result.inclination = 0.0875;
  result.change = Change::kBody;
  result.change_reason = "inclined False -> True";
  result.outcome = Outcome::kUnstable;
  result.reason = "link 3 turns";
  result.steps = 77;
  result.solver_warnings = 2;
  const auto json = nlohmann::json::parse(SeasonJson(Robot(), result));
  CHECK(json["profile"] == "published");
  CHECK(json["begin"] == 50);
  CHECK(json["sensed"]["inclined"]["value"] == true);
  CHECK(json["sensed"]["hot"]["value"] == false);
  CHECK(json["sensed"]["heat"]["value"] == 30.5);
  CHECK(json["sensed"]["inclined"]["from"] == "imu");
  CHECK(json["sensed"]["hot"]["from"] == "season");
  CHECK(json["inclination"] == 0.0875);
  CHECK(json["change"] == "body");
  CHECK(json["change_reason"] == "inclined False -> True");
  CHECK(json["outcome"] == "unstable");
  CHECK(json["reason"] == "link 3 turns");
  CHECK(json["steps"] == 77);
  CHECK(json["solver_warnings"] == 2);
  CHECK(
      nlohmann::json::parse(SeasonJson(Robot(), {}))["inclination"].is_null());
}

TEST_CASE("numbers of a season come back bit for bit", "[season_json]") {
  SeasonResult result;
  result.fitness = 0.1 + 0.2;
  result.behaviour.is_valid = true;
  result.behaviour.head_balance = 1.0 / 3;
  result.body.absolute_size = 7;
  result.state_hash = 0xABCDEF;
  const auto json = nlohmann::json::parse(SeasonJson(Robot(), result));
  CHECK(json["fitness"].get<double>() == 0.1 + 0.2);
  CHECK(json["behaviour"]["head_balance"].get<double>() == 1.0 / 3);
  CHECK(json["body_descriptors"]["absolute_size"] == 7);
  CHECK(json["state_hash"] == "0000000000abcdef");
}

}  // namespace
}  // namespace plsc
