#include "runtime/store/trials_json.h"

#include <nlohmann/json.hpp>
#include <string>

#include "grammar/enum_names.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

Json TrialJson(const StoredTrial& trial) {
  const Disturbance& disturbance = trial.disturbance;
  const auto noise = [](const Noise& one) {
    return Json{{"amplitude", one.amplitude},
                {"seed", std::to_string(one.seed)}};
  };
  Json json;
  json["fitness"] = trial.fitness ? Json(*trial.fitness) : Json(nullptr);
  json["outcome"] = OutcomeName(trial.outcome);
  json["reason"] = trial.reason;
  json["lift"] = disturbance.lift;
  json["shift"] = {disturbance.shift_x, disturbance.shift_y};
  json["yaw"] = disturbance.yaw;
  json["friction"] = disturbance.friction;
  json["lean"] = disturbance.lean;
  json["touch"] = noise(disturbance.touch);
  json["motor"] = noise(disturbance.motor);
  return json;
}

}  // namespace

Json TrialsJson(const std::vector<std::vector<StoredTrial>>& trials) {
  Json json = Json::array();
  for (const std::vector<StoredTrial>& season : trials) {
    json.push_back(Json::array());
    for (const StoredTrial& trial : season)
      json.back().push_back(TrialJson(trial));
  }
  return json;
}

}  // namespace plsc
