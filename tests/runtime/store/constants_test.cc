#include "runtime/store/constants.h"
#include "runtime/scenario/scenario_yaml.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <string>

#include "runtime/scenario/scenario_profile.h"
#include "runtime/text/yaml_reader.h"

namespace plsc {

namespace {

std::map<std::string, ScenarioConstant> ByName(
    const std::vector<ScenarioConstant>& all) {
  std::map<std::string, ScenarioConstant> named;
  for (const ScenarioConstant& one : all)
    CHECK(named.emplace(one.name, one).second);
  return named;
}

}  // namespace

TEST_CASE("Every key that a scenario prints is a constant of each season",
          "[constants]") {
  Scenario scenario = PaperScenario();
  scenario.seasons[1].physics.friction = 0.25;
  for (const Season& season : scenario.seasons) {
    const auto constants = ByName(ConstantsOf(scenario, season));
    const Source yaml("scenario", PrintScenario(scenario));
    const YamlFile file(yaml);
    auto root = file.Root("a scenario");
    REQUIRE(root);
    int keys = 0;
    for (const YamlMap::Entry& entry : root->TakeAll()) {
      if (entry.key == "seasons" || entry.key == "name") continue;
      if (!entry.value.is_map()) {
        CAPTURE(entry.key);
        CHECK(constants.contains(entry.key));
        continue;
      }
      auto section = entry.value.Map("a section");
      for (const YamlMap::Entry& inner : section->TakeAll()) {
        CAPTURE(entry.key, inner.key);
        CHECK(constants.contains(entry.key + "." + inner.key));
        ++keys;
      }
    }
    CHECK(keys >= 26);  // physics 19, servo 5, imu 2
    CHECK(constants.contains("duration"));
    CHECK(constants.at("physics.friction").number == season.physics.friction);
    CHECK(constants.at("servo.gain").number == scenario.servo.gain);
  }
}

TEST_CASE("Numbers have their unit, other values are texts", "[constants]") {
  const Scenario scenario = PaperScenario();
  const auto constants = ByName(ConstantsOf(scenario, scenario.seasons[1]));
  struct Row {
    const char* name;
    const char* text;
    std::optional<double> number;
    std::optional<std::string> unit;
  };
  const std::vector<Row> rows = {
      {"duration", "50 s", 50, "s"},
      {"terrain.tilted", "5 deg", 5, "deg"},
      {"physics.solver", "direct", std::nullopt, std::nullopt},
      {"senses.hot", "False", std::nullopt, std::nullopt},
      {"max_steps", "1000000", 1000000, std::nullopt},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.name) {
      const ScenarioConstant& constant = constants.at(row.name);
      CHECK(constant.text == row.text);
      CHECK(constant.number == row.number);
      CHECK(constant.unit == row.unit);
    }
  }
}

}  // namespace plsc
