#include "runtime/formats/season_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace plsc {
namespace {

TEST_CASE("a season that was not lived has no behaviour and no fitness",
          "[season_json]") {
  SeasonResult result;
  result.season = "flat";
  result.outcome = Outcome::kOverlapping;
  const auto json = nlohmann::json::parse(SeasonJson("robot", result));
  CHECK(json["genotype"] == "robot");
  CHECK(json["outcome"] == "overlapping");
  CHECK(json["fitness"].is_null());
  CHECK(json["behaviour"].is_null());
}

TEST_CASE("numbers of a season come back bit for bit", "[season_json]") {
  SeasonResult result;
  result.fitness = 0.1 + 0.2;
  result.behaviour.is_valid = true;
  result.behaviour.head_balance = 1.0 / 3;
  result.body.absolute_size = 7;
  result.state_hash = 0xABCDEF;
  const auto json = nlohmann::json::parse(SeasonJson("robot", result));
  CHECK(json["fitness"].get<double>() == 0.1 + 0.2);
  CHECK(json["behaviour"]["head_balance"].get<double>() == 1.0 / 3);
  CHECK(json["body_descriptors"]["absolute_size"] == 7);
  CHECK(json["state_hash"] == "0000000000abcdef");
}

}  // namespace
}  // namespace plsc
