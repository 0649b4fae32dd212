// The scenario of a request, checked, and with the settings that a page has
// controls for changed.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "runtime/scenario/scenario_physics.h"
#include "runtime/scenario/scenario_terrain.h"
#include "runtime/scenario/scenario_yaml.h"
#include "runtime/service/asks.h"
#include "runtime/service/refusal.h"
#include "runtime/service/subject.h"

namespace plsc::service {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegree = 3.14159265358979323846 / 180;

bool IsPlane(const Terrain& terrain) {
  return terrain.type == TerrainType::kFlat ||
         terrain.type == TerrainType::kTilted;
}

Json SlopeJson(const Terrain& terrain) {
  if (!IsPlane(terrain)) return nullptr;
  const double degrees =
      terrain.type == TerrainType::kFlat ? 0 : terrain.tilt / kDegree;
  return std::round(degrees * 1e9) / 1e9;  // 5, not 5.000000000000001
}

Json SeasonControls(const Season& season) {
  Json json;
  json["name"] = season.name;
  json["terrain"] = PrintTerrain(season.terrain);
  json["slope"] = SlopeJson(season.terrain);
  json["friction"] = season.physics.friction;
  json["duration"] = season.duration;
  json["step"] = season.physics.step;
  json["gravity"] = season.physics.gravity;
  json["engine"] = NameIn(kEngineNames, season.physics.engine);
  json["senses"] = Json::object();
  for (const auto& [state, value] : season.senses)
    json["senses"][state] = value;
  return json;
}

Json Controls(const Scenario& scenario) {
  Json json;
  json["name"] = scenario.name;
  json["profile"] = NameIn(kProfileNames, scenario.profile);
  json["lives"] =
      scenario.lives == Lives::kContinuous ? "continuous" : "independent";
  json["seasons"] = Json::array();
  for (const Season& season : scenario.seasons)
    json["seasons"].push_back(SeasonControls(season));
  return json;
}

double NumberOf(const nlohmann::json& json, const std::string& key) {
  if (!json.is_number())
    throw Refusal(fmt::format("expected '{}' to be a number", key));
  return json.get<double>();
}

void SetSlope(double degrees, Terrain& terrain) {
  // No other ground has a slope to set.
  terrain = {};
  if (degrees == 0) return;
  terrain.type = TerrainType::kTilted;
  terrain.tilt = degrees * kDegree;
}

void SetSenses(const nlohmann::json& senses, Season& season) {
  if (!senses.is_object()) throw Refusal("expected 'senses' to be an object");
  for (const auto& [state, value] : senses.items()) {
    if (value.is_null())
      season.senses.erase(state);
    else if (value.is_string())
      season.senses[state] = value.get<std::string>();
    else
      throw Refusal("expected values of 'senses' to be texts, or null");
  }
}

void SetIn(const nlohmann::json& change, Season& season) {
  for (const auto& [key, value] : change.items()) {
    if (key == "slope")
      SetSlope(NumberOf(value, key), season.terrain);
    else if (key == "friction")
      season.physics.friction = NumberOf(value, key);
    else if (key == "duration")
      season.duration = NumberOf(value, key);
    else if (key == "senses")
      SetSenses(value, season);
    else if (key != "season")
      throw Refusal(fmt::format(
          "expected slope, friction, duration or senses to be set, not '{}'",
          key));
  }
}

/// Of the season that it names; of all without a name.
void Apply(const nlohmann::json& change, Scenario& scenario) {
  if (!change.is_object())
    throw Refusal("expected 'set' to be a list of objects");
  const auto named = change.find("season");
  bool is_found = false;
  for (Season& season : scenario.seasons) {
    if (named != change.end() && *named != season.name) continue;
    SetIn(change, season);
    is_found = true;
  }
  if (!is_found) throw Refusal("the scenario has no season of that name");
}

}  // namespace

Answer ShowScenario(const Request& request) {
  Scenario scenario = ScenarioOf(request);
  if (request.Has("set")) {
    for (const nlohmann::json& change : request.List("set"))
      Apply(change, scenario);
    // What was set is held to what a file may say.
    const Source yaml(kScenarioName, PrintScenario(scenario));
    Result<Scenario> checked = ParseScenario(yaml);
    if (!checked) throw Refusal(checked.diagnostics(), yaml);
    scenario = std::move(*checked);
  }
  Answer answer;
  answer.Add("yaml", PrintScenario(scenario));
  answer.Add("controls", Controls(scenario));
  return answer;
}

}  // namespace plsc::service
